// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// The three movements that are needed to begin, in the order in which they are needed, for mouse and
/// keyboard. Used for exercises without a guide of their own (LivePart::controls). All other keys are in
/// keysInWords().
/// Thread: GUI.
std::vector<ControlHint> controlGuide(session::PointerTool tool);
/// The keys (Qt::Key) that move this tool.
std::vector<int> movementKeys(session::PointerTool tool);

} // namespace chiron::desktop
