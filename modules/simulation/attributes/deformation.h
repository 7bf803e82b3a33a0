// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/elasticity.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

/// What a surface answers to being pressed.
struct DeformationResponse {
    double force_N = 0.0;           ///< along the outward normal, ≥ 0
    double energy_J = 0.0;          ///< stored in both springs, ≥ 0
    double stiffness_N_per_m = 0.0; ///< ∂force/∂depth at once: F'(d) + k₁; 0 where nothing is felt
    double surface_m = 0.0;         ///< how deep the surface itself now lies below its rest place, ≥ 0
};

/// Deformation of a surface as a standard linear solid under one tool: a spring F beside a spring k₁ with a damper in series,
/// whose extension is q:
///   f = max(0, F(d) + k₁ (d − q)),   q' = (max(0, d) − q)/τ
/// d = depth from the rest surface (m), F = ElasticLaw of the object (k d without stiffening), k₁ = recoveryShare · k ≥ 0,
/// τ = recoveryTime ≥ 0 (s). A quick press meets k + k₁, a lasting one gives way to k with τ; that steady state is P2's
/// "normal force proportional to the distance from the original surface position". A tool that goes away faster than the
/// surface follows feels nothing until it presses again: the surface lies at surface_m, where F = k₁ (q − d), and rises as
/// q falls with τ. k₁ = 0 or τ = 0: q = d at once, plain elasticity.
///
/// Each tick q first goes towards the depth of the tick before, by the exact exponential, then the tool moves. So over any
/// history of depths, however wild, f_n (d_n − d_{n−1}) ≥ E_n − E_{n−1}: never active, E = U_F(d) + ½ k₁ (d − q)², or its
/// least value over d while nothing is felt. Not conservative (heat in the damper). The dent is the tool's own, kept by
/// the tick and moving with the tool: a slide onto fresh tissue finds it dented as where it came from (the lateral force of
/// ploughing is left out with it).
/// One object a tool. Thread: haptic. Source: P2 "Deformation Model"; models.md §2.2; the solid: Fung, Biomechanics, §2.11.
class Deformation {
public:
    struct Parameters {
        ElasticLaw elastic;
        double extraStiffness_N_per_m = 0.0; ///< k₁ ≥ 0
        double recoveryTime_s = 0.0;         ///< τ ≥ 0
        bool gives() const noexcept { return extraStiffness_N_per_m > 0.0 && recoveryTime_s > 0.0; }
    };

    /// One tick of `dt_s`; `depth_m` may be negative (the tool is outside). Call it every tick while a surface with
    /// parameters that give may still be recovering.
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

    /// Goes on from a dent that is kept elsewhere (per vertex of a mesh, geometry/mesh/mesh_dents.h): q and the depth of the
    /// tick before, both m, ≥ 0. Then "never active" holds as far as that dent is the one this tool left.
    void resume(double stretch_m, double depth_m) noexcept {
        m_stretch_m = stretch_m;
        m_depth_m = depth_m;
    }
    /// As new: nothing dented.
    void reset() noexcept { m_stretch_m = m_depth_m = 0.0; }
    double stretch_m() const noexcept { return m_stretch_m; } ///< q

private:
    /// Where nothing presses: F(d) = k₁ (q − d). Newton from q falls towards it without overshoot, F being convex.
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
    static constexpr int kNewtonSteps = 8; ///< 1e-15 of q from the linear guess for b q ≤ 5

    double m_stretch_m = 0.0; ///< q
    double m_depth_m = 0.0;   ///< of the tick before
};

} // namespace chiron::simulation
