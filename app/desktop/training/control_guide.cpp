// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/control_guide.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(ControlGuide)
};

using devices::HandKind;
using session::PointerTool;

std::vector<ControlHint> withHandle(PointerTool tool) {
    const ControlHint move{Pictogram::moveStylus, Words::tr("Move"),
                           Words::tr("Take the handle and move it: the tool moves with it.")};
    switch (tool) {
    case PointerTool::endoscope:
        return {{Pictogram::pressStylus, Words::tr("Advance"),
                 Words::tr("Push the handle in. To withdraw, pull it out.")},
                {Pictogram::moveStylus, Words::tr("Turn"), Words::tr("Turn and tilt the handle.")},
                {Pictogram::moveStylus, Words::tr("Shift sideways"), Words::tr("Move the handle sideways.")}};
    case PointerTool::grasper:
        return {move,
                {Pictogram::pressStylus, Words::tr("Lower"),
                 Words::tr("Lower the handle. To raise the instrument, raise the handle.")},
                {Pictogram::stylusButton, Words::tr("Close the jaw"),
                 Words::tr("Close the grip of the handle. To open the jaw, open the grip.")}};
    case PointerTool::point:
        break;
    }
    return {move,
            {Pictogram::pressStylus, Words::tr("Lower"),
             Words::tr("Lower the handle until the tip makes contact. To raise the tip, raise the "
                       "handle.")},
            {Pictogram::stylusButton, Words::tr("Mark"),
             Words::tr("Press the button of the handle, or Enter, while you touch the place.")}};
}

std::vector<ControlHint> withMouseAndKeyboard(PointerTool tool) {
    if (tool == PointerTool::endoscope)
        return {
            {Pictogram::wheelAway, Words::tr("Advance"),
             Words::tr(
                 "Roll the wheel away from you, or hold W. To withdraw, roll it towards you, or hold S.")},
            {Pictogram::moveMouse, Words::tr("Turn"), Words::tr("Move the mouse, or use the arrow keys.")},
            {Pictogram::rightHeld, Words::tr("Shift sideways"),
             Words::tr("Move the mouse with the right button or Shift held.")}};
    const ControlHint move{Pictogram::moveMouse, Words::tr("Move"),
                           Words::tr("Move the mouse, or use the arrow keys.")};
    const QString towards = Words::tr(
        "Roll the wheel towards you, or hold Page Down. To raise, roll it away from you, or hold Page Up.");
    if (tool == PointerTool::grasper)
        return {move,
                {Pictogram::wheelTowards, Words::tr("Lower"), towards},
                {Pictogram::leftHeld, Words::tr("Close the jaw"),
                 Words::tr(
                     "Hold the left button, or G. When you let go, the jaw stays as it is. To open it, hold "
                     "Shift and the left button, or H.")}};
    return {move,
            {Pictogram::wheelTowards, Words::tr("Lower"), towards},
            {Pictogram::leftClick, Words::tr("Mark"),
             Words::tr("Click, or press Enter, while you touch the place.")}};
}

/// With a handle for each instrument nothing has to be changed.
std::vector<ControlHint> instrumentHint(HandKind hand, int tools) {
    if (tools < 2 || hand == HandKind::handle)
        return {};
    return {{Pictogram::keys, Words::tr("Change the instrument"),
             tools == 2
                 ? Words::tr("You move one instrument at a time. Press 1 for the right one, 2 for the "
                             "left one.")
                 : Words::tr("You move one instrument at a time. Press its number, 1 to %1.").arg(tools)}};
}

} // namespace

std::vector<ControlHint> controlGuide(PointerTool tool, HandKind hand, int tools) {
    std::vector<ControlHint> hints = hand == HandKind::handle ? withHandle(tool) : withMouseAndKeyboard(tool);
    const std::vector<ControlHint> change = instrumentHint(hand, tools);
    hints.insert(hints.end(), change.begin(), change.end());
    return hints;
}

std::vector<int> movementKeys(PointerTool tool, HandKind hand) {
    if (hand == HandKind::handle)
        return {};
    std::vector<int> keys{Qt::Key_Left, Qt::Key_Right,  Qt::Key_Up,
                          Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown};
    if (tool == PointerTool::endoscope)
        keys.insert(keys.end(), {Qt::Key_W, Qt::Key_S, Qt::Key_Q, Qt::Key_E});
    return keys;
}

} // namespace chiron::desktop
