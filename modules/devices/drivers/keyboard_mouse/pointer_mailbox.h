// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/drivers/keyboard_mouse/motion_mailbox.h"

namespace chiron::devices {

/// A point that a mouse and a keyboard move: x, y, z of D, m.
class PointerMailbox final : public MotionMailbox<3> {
public:
    /// The pointer or wheel moved by this, in metres of D (the window converts pixels).
    void move(double dx_m, double dy_m, double dz_m) noexcept { add({dx_m, dy_m, dz_m}); }
    /// Keys that move the tool are held: its speed, zero when they are let go.
    void setRate(double x_m_per_s, double y_m_per_s, double z_m_per_s) noexcept {
        setRates({x_m_per_s, y_m_per_s, z_m_per_s});
    }
};

} // namespace chiron::devices
