// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/control_guide.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(ControlGuide)
};
} // namespace

std::vector<ControlHint> controlGuide(session::PointerTool tool) {
    if (tool == session::PointerTool::endoscope)
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
    if (tool == session::PointerTool::grasper)
        return {move,
                {Pictogram::wheelTowards, Words::tr("Lower"), towards},
                {Pictogram::leftHeld, Words::tr("Close the jaw"),
                 Words::tr("Hold the left button, or G. To open it, hold Shift and the left button, or H.")}};
    return {move,
            {Pictogram::wheelTowards, Words::tr("Lower"), towards},
            {Pictogram::leftClick, Words::tr("Mark"),
             Words::tr("Click, or press Enter, while you touch the place.")}};
}

std::vector<int> movementKeys(session::PointerTool tool) {
    std::vector<int> keys{Qt::Key_Left, Qt::Key_Right,  Qt::Key_Up,
                          Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown};
    if (tool == session::PointerTool::endoscope)
        keys.insert(keys.end(), {Qt::Key_W, Qt::Key_S, Qt::Key_Q, Qt::Key_E});
    return keys;
}

} // namespace chiron::desktop
