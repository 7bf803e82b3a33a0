// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/scripted_motion.h"

#include "core/units.h"

#include <cmath>

namespace chiron::mechanisms {

HandIntention ScriptedMotion::decide(const HandPerception& seen) noexcept {
    HandIntention wanted;
    wanted.p_DDesired = m_centre_D;
    for (const Term& term : m_terms) {
        const double omega = 2.0 * core::kPi * term.frequency_Hz;
        const double angle = omega * seen.time_s + term.phase_rad;
        wanted.p_DDesired += term.amplitude_m * std::sin(angle);
        wanted.v_DDesired += term.amplitude_m * (omega * std::cos(angle));
    }
    return wanted;
}

} // namespace chiron::mechanisms
