// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/elasticity.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

/// Response of a surface to a press.
struct DeformationResponse {
    double force_N = 0.0;           ///< along the outward normal, ≥ 0
    double energy_J = 0.0;          ///< stored in both springs, ≥ 0
    double stiffness_N_per_m = 0.0; ///< ∂force/∂depth for a sudden change: F'(d) + k₁; 0 where no force acts
    double surface_m = 0.0;         ///< how deep the surface itself lies below its rest position, ≥ 0
};

/// Deformation of a surface as a standard linear solid under one tool: a spring F in parallel with a spring
/// k₁ and a damper in series, whose extension is q:
///   f = max(0, F(d) + k₁ (d − q)),   q' = (max(0, d) − q)/τ
/// d is the depth from the rest surface (m), F the ElasticLaw of the object (k d without stiffening), k₁ =
/// recoveryShare · k ≥ 0 and τ = recoveryTime ≥ 0 (s). A quick press meets k + k₁; a lasting press relaxes to
/// k with τ, and that steady state is P2's "normal force proportional to the distance from the original
/// surface position". A tool that leaves faster than the surface follows feels nothing until it presses
/// again: the surface then lies at surface_m, where F = k₁ (q − d), and rises as q falls with τ. If k₁ = 0 or
/// τ = 0, q equals d at once and the surface is purely elastic.
///
/// In each tick, q first relaxes towards the depth of the previous tick by the exact exponential, and then
/// the tool moves. Over any sequence of depths this gives f_n (d_n − d_{n−1}) ≥ E_n − E_{n−1}, so the law is
/// never active. Here E = U_F(d) + ½ k₁ (d − q)², or its minimum over d while no force acts. The law is not
/// conservative, because the damper turns energy into heat. The dent belongs to the tool and moves with it:
/// when the tool slides onto fresh tissue, it finds the same dent as at its old position, and the lateral
/// force of ploughing is left out. Use one instance per tool. Source: P2 "Deformation Model"; models.md §2.2;
/// the solid: Fung, Biomechanics, §2.11.
/// Thread: haptic.
class Deformation {
public:
    struct Parameters {
        ElasticLaw elastic;
        double extraStiffness_N_per_m = 0.0; ///< k₁ ≥ 0
        double recoveryTime_s = 0.0;         ///< τ ≥ 0
        bool gives() const noexcept { return extraStiffness_N_per_m > 0.0 && recoveryTime_s > 0.0; }
    };

    /// Advances by one tick of `dt_s`. `depth_m` may be negative (the tool is outside). Call it in every tick
    /// while a surface whose parameters let it give way may still be recovering.
    DeformationResponse press(const Parameters& law, double depth_m, double dt_s) noexcept {
        const double d = std::max(0.0, depth_m);
        if (law.gives())
            m_stretch_m = m_depth_m + (m_stretch_m - m_depth_m) * std::exp(-dt_s / law.recoveryTime_s);
        else
            m_stretch_m = d;
        m_depth_m = d;
        DeformationResponse out;
        out.surface_m = d;
        const double rest = law.extraStiffness_N_per_m * (d - m_stretch_m);
        const double force = law.elastic.tension(d) + (law.gives() ? rest : 0.0);
        if (force > 0.0) {
            out.force_N = force;
            out.stiffness_N_per_m = law.elastic.slope(d) + (law.gives() ? law.extraStiffness_N_per_m : 0.0);
        } else if (law.gives()) {
            out.surface_m = freeSurface(law);
        }
        const double apart = law.gives() ? out.surface_m - m_stretch_m : 0.0;
        out.energy_J = law.elastic.energy(out.surface_m) + 0.5 * law.extraStiffness_N_per_m * apart * apart;
        return out;
    }

    /// Continues from a dent that is kept elsewhere (per vertex of a mesh, geometry/mesh/mesh_dents.h), given
    /// by q and the depth of the previous tick, both in m and ≥ 0. The law then stays passive only as far as
    /// that dent is the one that this tool left.
    void resume(double stretch_m, double depth_m) noexcept {
        m_stretch_m = stretch_m;
        m_depth_m = depth_m;
    }
    /// Removes the dent.
    void reset() noexcept { m_stretch_m = m_depth_m = 0.0; }
    double stretch_m() const noexcept { return m_stretch_m; } ///< q

private:
    /// Solves F(d) = k₁ (q − d) for the surface on which nothing presses. Newton's method starts from the
    /// solution without stiffening and falls to the root without overshoot, because F is convex.
    double freeSurface(const Parameters& law) const noexcept {
        double d = m_stretch_m * law.extraStiffness_N_per_m /
                   (law.extraStiffness_N_per_m + law.elastic.stiffness_N_per_m);
        if (law.elastic.stiffening_per_m == 0.0)
            return d;
        for (int i = 0; i < kNewtonSteps; ++i)
            d -= (law.elastic.tension(d) - law.extraStiffness_N_per_m * (m_stretch_m - d)) /
                 (law.elastic.slope(d) + law.extraStiffness_N_per_m);
        return std::max(0.0, d);
    }
    /// These steps leave an error of 1e-15 of q after the linear guess for b q ≤ 5.
    static constexpr int kNewtonSteps = 8;

    double m_stretch_m = 0.0; ///< q
    double m_depth_m = 0.0;   ///< depth of the previous tick
};

} // namespace chiron::simulation
