// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/display_state.h"

#include <QPointF>
#include <span>

namespace chiron::desktop {

/// Converts mouse and key input over the scene into movements of a tool. There is one derived class per kind
/// of tool.
/// Thread: GUI.
class HandControl {
public:
    HandControl() = default;
    HandControl(const HandControl&) = delete;
    HandControl& operator=(const HandControl&) = delete;
    virtual ~HandControl() = default;

    /// The pointer moved by this many pixels (y down). `other`: the right button or Shift is held.
    virtual void drag(QPointF pixels, bool other) noexcept = 0;
    virtual void wheel(int eighthsOfDegree) noexcept = 0;
    virtual std::span<const int> keys() const noexcept = 0; ///< the keys that move the tool (Qt::Key)
    virtual bool keyDown(int key) = 0;                      ///< false: the key is not one of them
    virtual bool keyUp(int key) = 0;
    /// On pause, or if the window loses the keyboard focus: nothing may continue to move.
    virtual void releaseKeys() = 0;
    virtual void click() = 0; ///< "Here it is", if the exercise asks for it
    /// Whether each mark has to come from click(), because it belongs to one of several tools.
    virtual bool marks() const noexcept { return false; }
    /// The left button was pressed over the scene; the argument says whether Shift is held. Not every tool
    /// uses it.
    virtual void buttonDown(bool) {}
    virtual void buttonUp() {}
    virtual void feel(const haptics::DisplayState&) {}    ///< called every frame with the tools' contacts
    virtual int activeTool() const noexcept { return 0; } ///< the moving tool, if there are several
};

} // namespace chiron::desktop
