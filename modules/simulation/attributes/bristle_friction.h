// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cmath>

namespace chiron::simulation {

/// Friction of one tool on one surface as a clipped bristle, once a tick:
///   z ← P_n (z + Δx),  ‖z‖ ≤ μ f_n / σ₀,  f = −σ₀ z
/// Δx = the tool's displacement since the last tick, P_n the projection on the tangent plane of the outward normal n.
/// σ₀ is constant, so the stored ½ σ₀ z² only ever shrinks by clipping and projecting: never active; it sticks (a still
/// tool keeps its force) and does not creep (inside the clip a cycle returns to where it began). Source: models.md §2.2.
/// State lives here: one object a tool. Thread: haptic.
class BristleFriction {
public:
    /// `p_WT` m; `normal` unit, W; `normalForce_N` = f_n ≥ 0; `mu` ≥ 0; `bristleStiffness_N_per_m` = σ₀ > 0. Returns the
    /// friction force on the tool (N, W), in the tangent plane, at most μ f_n. The first call after release() gives 0.
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

    /// Contact ended: the bristle springs back and its energy is lost.
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
