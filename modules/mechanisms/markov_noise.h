// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"

#include <cmath>

namespace chiron::mechanisms {

/// Stationary first-order Gauss–Markov noise (Ornstein–Uhlenbeck), stepped exactly: x⁺ = a x + σ√(1−a²) n, a
/// = e^{−dt/τ}. It starts in its stationary state.
class MarkovNoise {
public:
    MarkovNoise() = default;
    MarkovNoise(double sd, double time_s, double dt_s, core::Random& random) noexcept
        : m_keep(std::exp(-dt_s / time_s)), m_new(sd * std::sqrt(1.0 - m_keep * m_keep)),
          m_value(sd * random.normal()) {}
    double advance(core::Random& random) noexcept {
        return m_value = m_keep * m_value + m_new * random.normal();
    }
    double value() const noexcept { return m_value; }

private:
    double m_keep = 0.0;
    double m_new = 0.0;
    double m_value = 0.0;
};

} // namespace chiron::mechanisms
