// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver.h"
#include "session/exercise_kind.h"

#include <QString>
#include <vector>

namespace chiron::desktop {

/// The picture of the part of a mouse, of a device's handle or of the keyboard that is used.
enum class Pictogram {
    moveMouse,
    wheelTowards,
    wheelAway,
    leftClick,
    leftHeld,
    rightHeld,
    moveStylus,
    pressStylus,
    stylusButton,
    keys
};

/// One action with the tool, and how to do it with the present device.
struct ControlHint {
    Pictogram picture = Pictogram::moveMouse;
    QString what; ///< "Move"
    QString how;  ///< "Mouse, or arrow keys"
};

/// The movements that are needed to begin, in the order in which they are needed, with what the person holds:
/// three, and how to change the instrument where one hand moves several of `tools`. Used for exercises
/// without a guide of their own (LivePart::guide). All other keys are in keysInWords().
/// Thread: GUI.
std::vector<ControlHint> controlGuide(session::PointerTool tool, devices::HandKind hand, int tools = 1);
/// The keys (Qt::Key) that move this tool; none if the person holds the handle of a device.
std::vector<int> movementKeys(session::PointerTool tool, devices::HandKind hand);

} // namespace chiron::desktop
