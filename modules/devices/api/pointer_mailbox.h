// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/motion_mailbox.h"

namespace chiron::devices {

/// A point that a mouse and a keyboard move: x, y, z of D, m; and the jaw of a grasper, rad (0 closed). Threads as
/// MotionMailbox.
class PointerMailbox final : public MotionMailbox<4> {
public:
    /// The pointer or wheel moved by this, in metres of D (the window converts pixels).
    void move(double dx_m, double dy_m, double dz_m) noexcept { add({dx_m, dy_m, dz_m, 0.0}); }
    /// Keys that move the tool are held: its speed, zero when they are let go.
    void setRate(double x_m_per_s, double y_m_per_s, double z_m_per_s) noexcept {
        m_rate = {x_m_per_s, y_m_per_s, z_m_per_s, m_rate[3]};
        setRates(m_rate);
    }
    /// What opens (> 0) or closes (< 0) the jaw is held: how fast, zero when it is let go. A tool without a jaw ignores it.
    void setJawRate(double rad_per_s) noexcept {
        m_rate[3] = rad_per_s;
        setRates(m_rate);
    }

private:
    Motion m_rate{}; ///< GUI's copy
};

} // namespace chiron::devices
