// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/fingertip_platform_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::mechanisms {

/// A finger's pad on the platform (FingerPadParameters), modelled as a ball. The ball's centre O is at (0, 0,
/// R + z₀) of F, so that a level platform at z = z₀ just touches it. The gradient of the penetration δ = R −
/// n·(O − c) turns the force into the platform's generalised force −F ∂δ/∂(z, β, α). The relaxing part is the
/// state of `PadRelaxation`. Pure; allocates nothing.
class FingerPad {
public:
    explicit FingerPad(const FingerPadParameters& parameters) noexcept : m_p(parameters) {}

    core::Vec3 centre() const noexcept { return {0.0, 0.0, m_p.radius_m + m_p.surface_m}; }
    double penetration(const FingertipLoop& at) const noexcept {
        return m_p.radius_m - at.normal.dot(centre() - at.centre);
    }
    core::Vec3 gradient(const FingertipLoop& at) const noexcept { ///< ∂δ/∂(z, β, α)
        return at.centreBy.transpose() * at.normal - at.normalBy.transpose() * (centre() - at.centre);
    }
    double elasticForce(double depth_m) const noexcept {
        const double depth = std::clamp(depth_m, 0.0, 0.01);
        return m_p.stiffness_N_per_m / m_p.hardening_per_m * std::expm1(m_p.hardening_per_m * depth);
    }
    /// `relaxed_N` is the part of the elastic force that has relaxed.
    double force(double depth_m, double rate_m_per_s, double relaxed_N = 0.0) const noexcept {
        if (!(depth_m > 0.0))
            return 0.0;
        return std::max(0.0, elasticForce(depth_m) - relaxed_N +
                                 m_p.damping_Ns_per_m * rate_m_per_s * std::min(1.0, depth_m / 0.0002));
    }
    double energy_J(double depth_m) const noexcept { ///< elastic, ∫F dδ
        const double depth = std::clamp(depth_m, 0.0, 0.01), b = m_p.hardening_per_m;
        return m_p.stiffness_N_per_m / b * (std::expm1(b * depth) / b - depth);
    }
    double depthOf(double force_N) const noexcept { ///< inverse of elasticForce
        return std::log1p(std::max(0.0, force_N) * m_p.hardening_per_m / m_p.stiffness_N_per_m) /
               m_p.hardening_per_m;
    }
    double stiffnessAt(double force_N) const noexcept {
        return m_p.stiffness_N_per_m + m_p.hardening_per_m * std::max(0.0, force_N);
    }
    /// Returns the height at which a platform with this lean presses the pad by `depth_m` (negative: the
    /// platform stands off).
    double heightFor(const FingertipLoop& at, double depth_m) const noexcept {
        const double along = at.normal.x() * at.centre.x() + at.normal.y() * at.centre.y();
        return m_p.radius_m + m_p.surface_m - (m_p.radius_m - depth_m + along) / at.normal.z();
    }
    /// Returns the point of contact, from the platform's middle, in the platform's own axes (m).
    core::Vec2 place(const FingertipLoop& at) const noexcept {
        const core::Vec3 to = at.turn.transpose() * (centre() - at.centre);
        return {to.x(), to.y()};
    }

    const FingerPadParameters& parameters() const noexcept { return m_p; }

private:
    FingerPadParameters m_p;
};

/// The relaxed part of a pad's force, in two terms that follow the elastic force with a lag (Fung's
/// quasi-linear viscoelasticity with two exponentials of equal share): r_i˙ = (c/2 · F_el − r_i)/τ_i. After a
/// long press a pad gives 1 − c of its initial force; when it is pressed and released, it gives less on the
/// way back.
/// Thread: haptic; allocates nothing.
class PadRelaxation {
public:
    void reset() noexcept { m_part = {}; }
    void advance(const FingerPadParameters& pad, double elastic_N, double dt_s) noexcept {
        for (std::size_t i = 0; i < m_part.size(); ++i)
            m_part[i] += dt_s / pad.relaxationTimes_s[i] * (0.5 * pad.relaxation * elastic_N - m_part[i]);
    }
    double force_N() const noexcept { return m_part[0] + m_part[1]; }

private:
    std::array<double, 2> m_part{};
};

} // namespace chiron::mechanisms
