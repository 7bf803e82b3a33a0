// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/motion_mailbox.h"

namespace chiron::devices {

/// Movement of an endoscope by a hand, as its picture shows it (the tool's frame T: it looks along −z, x
/// right, y up).
struct EndoscopeMovement {
    double advance_m = 0.0; ///< along the viewing direction
    double right_m = 0.0;   ///< sideways, in the plane of the picture
    double up_m = 0.0;
    double turnUp_rad = 0.0;    ///< the view turns upwards in the picture, about the tip
    double turnRight_rad = 0.0; ///< the view turns to the right in the picture, about the tip
    /// Rotation of the endoscope about its own axis, right-handed about the viewing direction.
    double spin_rad = 0.0;
};

/// Input of an endoscope that is moved with a mouse and a keyboard.
/// Thread: as MotionMailbox.
class EndoscopeMailbox final : public MotionMailbox<6> {
public:
    /// Adds a movement of the pointer or wheel (the window converts pixels).
    void move(const EndoscopeMovement& by) noexcept { add(toArray(by)); }
    /// Sets the movement per second while keys are held; all zero when they are released.
    void setRate(const EndoscopeMovement& perSecond) noexcept { setRates(toArray(perSecond)); }

    static EndoscopeMovement toMovement(const Motion& m) noexcept {
        return {m[0], m[1], m[2], m[3], m[4], m[5]};
    }

private:
    static Motion toArray(const EndoscopeMovement& m) noexcept {
        return {m.advance_m, m.right_m, m.up_m, m.turnUp_rad, m.turnRight_rad, m.spin_rad};
    }
};

} // namespace chiron::devices
