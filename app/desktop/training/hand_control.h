// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/display_state.h"

#include <QPointF>
#include <span>

namespace chiron::desktop {

/// What a hand does over the scene, with a mouse and with keys, made into movements of a tool: one class a kind of tool.
/// GUI thread.
class HandControl {
public:
    HandControl() = default;
    HandControl(const HandControl&) = delete;
    HandControl& operator=(const HandControl&) = delete;
    virtual ~HandControl() = default;

    /// The pointer moved by this many pixels (y down); `other`: with the right button or Shift held.
    virtual void drag(QPointF pixels, bool other) noexcept = 0;
    virtual void wheel(int eighthsOfDegree) noexcept = 0;
    virtual std::span<const int> keys() const noexcept = 0; ///< that move the tool (Qt::Key)
    virtual bool keyDown(int key) = 0;                      ///< false: not one of them
    virtual bool keyUp(int key) = 0;
    virtual void releaseKeys() = 0; ///< paused, or the window lost the keyboard: nothing may go on moving
    virtual void click() = 0;       ///< "here it is", where an exercise asks for it
    virtual void buttonDown(bool) {} ///< the left button went down over the scene; with Shift held or not. Not every tool has a use for it
    virtual void buttonUp() {}
    virtual void feel(const haptics::DisplayState&) {} ///< each frame: what the tools touch
    virtual int activeTool() const noexcept { return 0; } ///< the tool that moves, where there are several
};

} // namespace chiron::desktop
