// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/motion_mailbox.h"

namespace chiron::devices {

/// Input of a point that is moved with a mouse and a keyboard: x, y, z of D, m; and the jaw of a grasper, rad
/// (0 closed).
/// Thread: as MotionMailbox.
class PointerMailbox final : public MotionMailbox<4> {
public:
    /// Adds a movement of the pointer or wheel, in metres of D (the window converts pixels).
    void move(double dx_m, double dy_m, double dz_m) noexcept { add({dx_m, dy_m, dz_m, 0.0}); }
    /// Sets the speed of the tool while keys that move it are held; zero when they are released.
    void setRate(double x_m_per_s, double y_m_per_s, double z_m_per_s) noexcept {
        m_rate = {x_m_per_s, y_m_per_s, z_m_per_s, m_rate[3]};
        setRates(m_rate);
    }
    /// Sets the speed at which the jaw opens (> 0) or closes (< 0) while its input is held; zero when it is
    /// released. A tool without a jaw ignores it.
    void setJawRate(double rad_per_s) noexcept {
        m_rate[3] = rad_per_s;
        setRates(m_rate);
    }

private:
    Motion m_rate{}; ///< the GUI's copy
};

} // namespace chiron::devices
