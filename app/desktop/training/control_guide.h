// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/exercise_kind.h"

#include <QString>
#include <vector>

namespace chiron::desktop {

/// What of a mouse, of a device's handle or of the keyboard is used, as a picture.
enum class Pictogram { moveMouse, wheelTowards, wheelAway, leftClick, leftHeld, rightHeld, moveStylus, pressStylus, stylusButton, keys };

/// One thing that a hand does with a tool, and how with the device in hand.
struct ControlHint {
    Pictogram picture = Pictogram::moveMouse;
    QString what; ///< "Move"
    QString how;  ///< "Mouse, or arrow keys"
};

/// The three movements without which nobody can begin, in the order in which they are needed, for mouse and keyboard, where the exercise
/// has no guide of its own (LivePart::controls). Everything else is in keysInWords(). GUI thread.
std::vector<ControlHint> controlGuide(session::PointerTool tool);
/// The keys (Qt::Key) that move this tool.
std::vector<int> movementKeys(session::PointerTool tool);

} // namespace chiron::desktop
