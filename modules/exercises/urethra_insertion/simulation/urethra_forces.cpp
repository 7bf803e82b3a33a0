// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"

#include "modules/exercises/urethra_insertion/cues/canal_reach.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_sections.h"
#include "simulation/geometry/urethra/smoothstep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::simulation {

namespace {

// Least cos²φ_y: φ_x is not defined for a tool perpendicular to the plane of symmetry
constexpr double kSidewaysSquare = 1e-12;

/// Parabola from 0 at −w to slope 1 at w; 0 before, and x after it.
double roundedRamp(double x, double w) noexcept {
    const double u = std::clamp(x, -w, w) + w;
    return u * u / (4.0 * w) + std::max(0.0, x - w);
}

double rampSlope(double x, double w) noexcept {
    return (std::clamp(x, -w, w) + w) / (2.0 * w);
}

/// Computes the part of the response that depends on orientation: φ_x, φ_y and the torque vector that does
/// the work of T_x, T_y: τ = T_x (x̂ − tan φ_y z″) + T_y y′, with y′ = (0, a_z, −a_y)/cos φ_y and z″ = (0,
/// a_y, a_z)/cos φ_y. Returns the angles that the spring turns back, φ_x + c e_n and φ_y − c e_x: with the
/// pelvic floor as its pivot, the shaft's tilt follows the tip's offset. This is P1's second part of T_x,
/// "off the parabolic CL (endoscope y-z translation)".
core::Vec2 orient(UrethraResponse& r, const core::Vec3& a, double k_phi, double turn_per_m) noexcept {
    const core::Vec3& t = r.foot.at.t_A;
    r.phiX_rad = std::atan2(t.y() * a.z() - t.z() * a.y(), t.z() * a.z() + t.y() * a.y());
    r.phiY_rad = std::asin(std::clamp(a.x(), -1.0, 1.0));
    const core::Vec2 twist(r.phiX_rad + turn_per_m * r.foot.en_m, r.phiY_rad - turn_per_m * r.foot.ex_m);
    r.torqueX_Nm = -k_phi * twist.x();
    r.torqueY_Nm = -k_phi * twist.y();
    const double square = std::max(a.y() * a.y() + a.z() * a.z(), kSidewaysSquare);
    const double tilt = r.torqueX_Nm * a.x() / square;
    const double turn = r.torqueY_Nm / std::sqrt(square);
    r.wrench_A.torque = core::Vec3(r.torqueX_Nm, turn * a.z() - tilt * a.y(), -turn * a.y() - tilt * a.z());
    return twist;
}

/// Bounds the norm of a second derivative with these parts across, along and mixed. Those of U(s, e) are
/// U_ee, U_ss ‖∇s‖² − U_n κ ‖∇s‖ (n turns along the line) and U_se ‖∇s‖; U_s ∂²s is added to the result.
double largestStretch(double across, double along, double mixed) noexcept {
    return 0.5 * (across + along) + std::sqrt(0.25 * (across - along) * (across - along) + mixed * mixed);
}

/// The free part follows the shaft, but it hangs on the body: beyond the reach it is held by ½ k
/// (‖e‖ − reach)² w(s). w rises from 0 at the first contact to 1 where the wall's own springs set in, and
/// falls back to 0 where they have taken over. A part that hangs on its root yields most at its end. A shaft
/// that is held aside there comes out without a kick (if w rose over the beak alone, the 30 mJ stored would
/// push with 6 N).
struct FreeHold {
    double energy_J = 0.0, slope_N = 0.0, stiffness_N_per_m = 0.0, axial_N_per_m = 0.0, cross_N_per_m = 0.0;
    core::Vec2 gradient_N = core::Vec2::Zero();
};

FreeHold holdFreePart(const UrethraForces::Tables& tables, const CentrelineFoot& foot) noexcept {
    FreeHold hold;
    const double offset = std::sqrt(foot.ex_m * foot.ex_m + foot.en_m * foot.en_m),
                 beyond = offset - kCanalReach_m;
    if (!(tables.freeHold_N_per_m > 0.0 && beyond > 0.0))
        return hold;
    const double s = foot.at.s_m, in = (s + tables.ahead_m) / tables.freeRise_m,
                 on = 0.5 + 0.5 * (s - tables.freeFrom_m) / tables.freeBlend_m;
    const double rise = smoothstep(in), fall = 1.0 - smoothstep(on);
    const double k = tables.freeHold_N_per_m, half = 0.5 * k * beyond * beyond;
    hold.energy_J = half * rise * fall;
    const double weightSlope = smoothstepSlope(in) / tables.freeRise_m * fall -
                               rise * smoothstepSlope(on) * 0.5 / tables.freeBlend_m;
    hold.slope_N = half * weightSlope;
    hold.cross_N_per_m = k * beyond * std::abs(weightSlope);
    hold.gradient_N = k * beyond * rise * fall / offset * core::Vec2(foot.ex_m, foot.en_m);
    hold.stiffness_N_per_m = k * rise * fall;
    // Bounds the second derivatives of the two smoothsteps
    const double steep = 6.0 * (1.0 / (tables.freeRise_m * tables.freeRise_m) +
                                0.25 / (tables.freeBlend_m * tables.freeBlend_m));
    hold.axial_N_per_m = (in > 0.0 && in < 1.0) || (on > 0.0 && on < 1.0) ? half * steep : 0.0;
    return hold;
}

} // namespace

double UrethraAngularStiffness::value_Nm_per_rad(double s_m) const noexcept {
    return slope_Nm_per_rad_m * (roundedRamp(s_m - from_m, corner_m) - roundedRamp(s_m - to_m, corner_m));
}

UrethraPivot::Turn UrethraPivot::at(double s_m) const noexcept {
    if (!(span_m > 0.0))
        return {};
    const double l = s_m - from_m, l2 = l * l, span2 = span_m * span_m, sum = l2 + span2;
    return {l / sum, (span2 - l2) / (sum * sum), std::abs(2.0 * l * (l2 - 3.0 * span2)) / (sum * sum * sum)};
}

double UrethraAngularStiffness::slope(double s_m) const noexcept {
    return slope_Nm_per_rad_m * (rampSlope(s_m - from_m, corner_m) - rampSlope(s_m - to_m, corner_m));
}

int UrethraForces::Tables::firstFrom(double s_m) const noexcept {
    const int count = static_cast<int>(sections.size());
    const double place = s_m * bucketsPerMetre;
    if (!(place > 0.0))
        return 0;
    if (place >= static_cast<double>(bucket.size()))
        return count;
    int i = bucket[static_cast<std::size_t>(place)];
    while (i < count && sections[static_cast<std::size_t>(i)].s_m < s_m)
        ++i;
    return i;
}

UrethraResponse UrethraForces::respond(const EndoscopeMotion& motion) const noexcept {
    const Tables& tables = *m_tables;
    const core::Vec3& a = motion.axis_A;
    UrethraResponse r;
    r.foot = m_centreline.foot(motion.p_A);
    const CentrelinePoint& at = r.foot.at;
    const BladderResponse bladder = tables.bladder.respond(motion.p_A);
    r.bladder_A = bladder.force_A;
    r.touching = at.s_m > -tables.ahead_m || bladder.energy_J > 0.0;
    // There is no angular stiffness outside the body
    const double k_phi = r.touching ? tables.angular.value_Nm_per_rad(at.s_m) : 0.0;
    const UrethraPivot::Turn pivot = tables.pivot.at(at.s_m);
    const core::Vec2 twist = orient(r, a, k_phi, pivot.turn_per_m);
    if (!r.touching)
        return r;
    const UrethraSectionSums sums = sumUrethraSections(tables, at.s_m, r.foot.ex_m, r.foot.en_m);
    const double tilt2 = twist.squaredNorm(), tilt = std::sqrt(tilt2);
    const double bent = std::abs(at.curvature_per_m), turned = std::abs(pivot.slope_per_m2);
    const FreeHold hold = holdFreePart(tables, r.foot);
    r.energy_J = sums.energy_J + hold.energy_J + 0.5 * k_phi * tilt2 + bladder.energy_J;
    // ∂U/∂s_t: ψ turns by κ_c per metre
    const double slope = sums.slope_N + hold.slope_N + 0.5 * tables.angular.slope(at.s_m) * tilt2 +
                         k_phi * (twist.x() * (at.curvature_per_m + pivot.slope_per_m2 * r.foot.en_m) -
                                  twist.y() * pivot.slope_per_m2 * r.foot.ex_m);
    r.elastic_N = -slope * r.foot.gradientOfS_A.dot(at.t_A);
    const core::Vec2 gradient =
        sums.gradient_N + hold.gradient_N + k_phi * pivot.turn_per_m * core::Vec2(-twist.y(), twist.x());
    r.lateral_A = -gradient.x() * core::Vec3::UnitX() - gradient.y() * at.n_A + bladder.force_A;
    r.normal_N = sums.normal_N;
    const double stretch = r.foot.gradientOfS_A.norm(),
                 offset = std::sqrt(r.foot.ex_m * r.foot.ex_m + r.foot.en_m * r.foot.en_m);
    const double turning = bent + turned * offset, stiffening = std::abs(tables.angular.slope(at.s_m)),
                 lever = std::abs(pivot.turn_per_m);
    const double across = sums.stiffness_N_per_m + hold.stiffness_N_per_m + k_phi * lever * lever;
    const double axial =
        sums.axial_N_per_m + hold.axial_N_per_m + 0.5 * tilt2 * tables.angular.bend() +
        2.0 * stiffening * tilt * turning +
        k_phi * (turning * turning + tilt * (std::abs(at.bending_per_m2) + pivot.bend_per_m3 * offset));
    const double mixed = sums.cross_N_per_m + hold.cross_N_per_m +
                         tilt * (stiffening * lever + k_phi * turned) + k_phi * lever * turning;
    r.stiffness_N_per_m =
        bladder.stiffness_N_per_m + std::abs(slope) * r.foot.bendOfS_per_m +
        largestStretch(across, stretch * (stretch * axial + bent * std::abs(gradient.y())), stretch * mixed);

    const double along = motion.v_A.dot(a);
    const double spin = motion.w_A.dot(a);
    const double around = spin * tables.scopeRadius_m;
    // Viscosity and friction's slope share the tool's budget; friction keeps at least half of it.
    const double viscous =
        std::min(tables.viscosity_Ns_per_m2 * sums.opened_m, 0.5 * motion.mostDamping_Ns_per_m);
    const double steepest = std::min(tables.maximumDamping_Ns_per_m, motion.mostDamping_Ns_per_m - viscous);
    const double v0 = steepest > 0.0 ? std::max(tables.leastSpeed_m_per_s, sums.friction_N / steepest)
                                     : std::numeric_limits<double>::infinity();
    const double coulomb = sums.friction_N / std::sqrt(along * along + around * around + v0 * v0);
    // The wall is not purely elastic (Kelvin–Voigt). It damps across the axis, where friction and viscosity
    // do not act, so each direction has the whole budget.
    const double wall =
        std::min(tables.wallRetardation_s * sums.yielding_N_per_m, motion.mostDamping_Ns_per_m);
    const core::Vec3 across_A = motion.v_A - along * a;
    r.wallDamped_N = wall * across_A.norm();
    r.damping_Ns_per_m = std::max(coulomb + viscous, wall);
    r.friction_N = -coulomb * along;
    r.viscous_N = -viscous * along;
    r.torqueZ_Nm = -(coulomb + viscous) * around * tables.scopeRadius_m;
    r.wrench_A.force =
        r.lateral_A - slope * r.foot.gradientOfS_A + (r.friction_N + r.viscous_N) * a - wall * across_A;
    r.wrench_A.torque += r.torqueZ_Nm * a;
    return r;
}

} // namespace chiron::simulation
