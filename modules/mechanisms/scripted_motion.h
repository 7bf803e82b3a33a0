// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_strategy.h"

#include <cstddef>
#include <vector>

namespace chiron::mechanisms {

/// A hand that follows a prescribed path and uses no perception: p(t) = centre + Σ a_i sin(2π f_i t + φ_i),
/// with its exact velocity. For calibration, recordings and tests.
/// Unit: SI.
/// Frame: D.
class ScriptedMotion final : public HandStrategy {
public:
    struct Term {
        core::Vec3 amplitude_m = core::Vec3::Zero();
        double frequency_Hz = 1.0;
        double phase_rad = 0.0;
    };
    explicit ScriptedMotion(const core::Vec3& centre_D, std::vector<Term> terms = {});
    ~ScriptedMotion() override;
    HandIntention decide(const HandPerception& seen) noexcept override;

private:
    core::Vec3 m_centre_D;
    std::vector<Term> m_terms; ///< filled before the first tick, then only read
};

} // namespace chiron::mechanisms
