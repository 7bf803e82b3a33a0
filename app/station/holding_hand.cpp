// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/holding_hand.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::station {

HoldingHand::HoldingHand(Motion motion) : m_motion(motion) {}

HoldingHand::~HoldingHand() = default;

mechanisms::HandIntention HoldingHand::decide(const mechanisms::HandPerception& seen) noexcept {
    if (!m_holds) {
        m_at.p_DDesired = seen.p_DT;
        m_at.q_DDesired = seen.q_DT;
        m_holds = true;
    }
    mechanisms::HandIntention wanted = m_at;
    const double rate = 2.0 * core::kPi * m_motion.frequency_Hz;
    const double phase = rate * seen.time_s;
    const core::Vec3 along(0.0, 0.8, 0.6);
    wanted.p_DDesired += m_motion.amplitude_m * std::sin(phase) * along;
    wanted.v_DDesired = m_motion.amplitude_m * rate * std::cos(phase) * along;
    if (m_motion.depth_m > 0.0) {
        const double t = seen.time_s;
        const double down = std::clamp(t - m_motion.after_s, 0.0, 1.0);
        wanted.p_DDesired +=
            down * core::Vec3(0.004 * std::sin(2.0 * t), 0.004 * std::cos(1.3 * t), -m_motion.depth_m);
    }
    return wanted;
}

} // namespace chiron::station
