// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cmath>

namespace chiron::simulation {

/// Friction of one tool on one surface, modelled as a clipped bristle and updated once per tick:
///   z ← P_n (z + Δx),  ‖z‖ ≤ μ f_n / σ₀,  f = −σ₀ z
/// Δx is the tool's displacement since the last tick, and P_n projects on the tangent plane of the outward
/// normal n. σ₀ is constant, so clipping and projecting can only reduce the stored energy ½ σ₀ z²: the law is
/// never active. It sticks (a still tool keeps its force) and does not creep (inside the clip a cycle returns
/// to where it began). Each instance holds the state of one tool. Source: models.md §2.2.
/// Thread: haptic.
class BristleFriction {
public:
    /// Advances by one tick. `p_WT` is the tool's position (m), `normal` a unit vector in W, `normalForce_N`
    /// = f_n ≥ 0, `mu` ≥ 0 and `bristleStiffness_N_per_m` = σ₀ > 0. Returns the friction force on the tool
    /// (N, W), which lies in the tangent plane and is at most μ f_n. The first call after release() returns
    /// 0.
    core::Vec3 update(const core::Vec3& p_WT, const core::Vec3& normal, double normalForce_N, double mu,
                      double bristleStiffness_N_per_m) noexcept {
        if (m_touching)
            m_stretch += p_WT - m_previous;
        m_touching = true;
        m_previous = p_WT;
        m_stretch -= normal * normal.dot(m_stretch);
        const double limit = mu * normalForce_N / bristleStiffness_N_per_m;
        const double length2 = m_stretch.squaredNorm();
        if (length2 > limit * limit)
            m_stretch *= limit / std::sqrt(length2);
        return -bristleStiffness_N_per_m * m_stretch;
    }

    /// Ends the contact: the bristle springs back and its energy is lost.
    void release() noexcept {
        m_touching = false;
        m_stretch.setZero();
    }

    bool touching() const noexcept { return m_touching; }
    const core::Vec3& stretch() const noexcept { return m_stretch; } ///< z, m

private:
    core::Vec3 m_stretch = core::Vec3::Zero();
    core::Vec3 m_previous = core::Vec3::Zero();
    bool m_touching = false;
};

} // namespace chiron::simulation
