// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/tremor.h"

#include "core/units.h"

#include <cmath>

namespace chiron::mechanisms {

Tremor::Tremor(double rmsPerAxis_m, core::Random random) noexcept {
    const double amplitude = rmsPerAxis_m * std::sqrt(2.0 / kSines); // each sine carries rms²/kSines
    for (auto& axis : m_phasors) {
        for (Phasor& phasor : axis) {
            phasor.omega = 2.0 * core::kPi * random.uniform(8.0, 12.0);
            const double phase = random.uniform(0.0, 2.0 * core::kPi);
            phasor.re = amplitude * std::cos(phase);
            phasor.im = amplitude * std::sin(phase);
            phasor.c = std::cos(phasor.omega * core::kTickSeconds);
            phasor.s = std::sin(phasor.omega * core::kTickSeconds);
        }
    }
    sum();
}

void Tremor::advance() noexcept {
    for (auto& axis : m_phasors) {
        for (Phasor& phasor : axis) {
            const double re = phasor.re * phasor.c - phasor.im * phasor.s;
            phasor.im = phasor.re * phasor.s + phasor.im * phasor.c;
            phasor.re = re;
        }
    }
    sum();
}

void Tremor::sum() noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        double x = 0.0, v = 0.0, a = 0.0;
        for (const Phasor& phasor : m_phasors[static_cast<std::size_t>(axis)]) {
            x += phasor.re;
            v -= phasor.omega * phasor.im;
            a -= phasor.omega * phasor.omega * phasor.re;
        }
        m_displacement[axis] = x;
        m_velocity[axis] = v;
        m_acceleration[axis] = a;
    }
}

} // namespace chiron::mechanisms
