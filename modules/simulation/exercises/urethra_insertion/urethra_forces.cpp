// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/exercises/urethra_insertion/urethra_forces.h"

#include "simulation/exercises/urethra_insertion/urethra_forces_sections.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

constexpr double kSidewaysSquare = 1e-12; // of cos²φ_y: φ_x has no meaning for a tool at right angles to the plane of symmetry

/// Parabola from 0 at −w to slope 1 at w; 0 before, x after.
double roundedRamp(double x, double w) noexcept {
    const double u = std::clamp(x, -w, w) + w;
    return u * u / (4.0 * w) + std::max(0.0, x - w);
}

double rampSlope(double x, double w) noexcept {
    return (std::clamp(x, -w, w) + w) / (2.0 * w);
}

/// The moving frame's part of the response: φ_x, φ_y and the torque vector that does the work of T_x, T_y:
/// τ = T_x (x̂ − tan φ_y z″) + T_y y′, with y′ = (0, a_z, −a_y)/cos φ_y and z″ = (0, a_y, a_z)/cos φ_y.
void orient(UrethraResponse& r, const core::Vec3& a, double k_phi) noexcept {
    const core::Vec3& t = r.foot.at.t_A;
    r.phiX_rad = std::atan2(t.y() * a.z() - t.z() * a.y(), t.z() * a.z() + t.y() * a.y());
    r.phiY_rad = std::asin(std::clamp(a.x(), -1.0, 1.0));
    r.torqueX_Nm = -k_phi * r.phiX_rad;
    r.torqueY_Nm = -k_phi * r.phiY_rad;
    const double square = std::max(a.y() * a.y() + a.z() * a.z(), kSidewaysSquare);
    const double tilt = r.torqueX_Nm * a.x() / square;
    const double turn = r.torqueY_Nm / std::sqrt(square);
    r.wrench_A.torque = core::Vec3(r.torqueX_Nm, turn * a.z() - tilt * a.y(), -turn * a.y() - tilt * a.z());
}

} // namespace

double UrethraAngularStiffness::value_Nm_per_rad(double s_m) const noexcept {
    return slope_Nm_per_rad_m * (roundedRamp(s_m - from_m, corner_m) - roundedRamp(s_m - to_m, corner_m));
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
    const double k_phi = r.touching ? tables.angular.value_Nm_per_rad(at.s_m) : 0.0; // nothing outside the body
    orient(r, a, k_phi);
    if (!r.touching)
        return r;
    const UrethraSectionSums sums = sumUrethraSections(tables, at.s_m, r.foot.ex_m, r.foot.en_m);
    const double tilt2 = r.phiX_rad * r.phiX_rad + r.phiY_rad * r.phiY_rad;
    r.energy_J = sums.energy_J + 0.5 * k_phi * tilt2 + bladder.energy_J;
    const double slope = sums.slope_N + 0.5 * tables.angular.slope(at.s_m) * tilt2 +
                         k_phi * r.phiX_rad * at.curvature_per_m; // ∂U/∂s_t: ψ turns by κ_c a metre
    r.elastic_N = -slope * r.foot.gradientOfS_A.dot(at.t_A);
    r.lateral_A = -sums.gradient_N.x() * core::Vec3::UnitX() - sums.gradient_N.y() * at.n_A + bladder.force_A;
    r.normal_N = sums.normal_N;
    r.stiffness_N_per_m = sums.stiffness_N_per_m + bladder.stiffness_N_per_m;

    const double along = motion.v_A.dot(a);
    const double spin = motion.w_A.dot(a);
    const double around = spin * tables.scopeRadius_m;
    const double v0 = std::max(tables.leastSpeed_m_per_s, sums.friction_N / tables.maximumDamping_Ns_per_m);
    const double coulomb = sums.friction_N / std::sqrt(along * along + around * around + v0 * v0);
    const double viscous = tables.viscosity_Ns_per_m2 * sums.opened_m;
    r.friction_N = -coulomb * along;
    r.viscous_N = -viscous * along;
    r.torqueZ_Nm = -(coulomb + viscous) * around * tables.scopeRadius_m;
    r.wrench_A.force = r.lateral_A - slope * r.foot.gradientOfS_A + (r.friction_N + r.viscous_N) * a;
    r.wrench_A.torque += r.torqueZ_Nm * a;
    return r;
}

} // namespace chiron::simulation
