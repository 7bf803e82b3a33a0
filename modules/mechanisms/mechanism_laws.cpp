// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/mechanism_laws.h"

#include "core/units.h"
#include "mechanisms/five_bar_kinematics.h"
#include "mechanisms/gimbal_kinematics.h"
#include "mechanisms/spherical_joint.h"

#include <array>
#include <cmath>

namespace chiron::mechanisms {

namespace {

using core::LawColumn;
using core::LawParameter;

constexpr std::array<LawColumn, 5> kForceInputs{
    {{"h_rad", "rad"}, {"p_rad", "rad"}, {"fx_N", "N"}, {"fy_N", "N"}, {"fz_N", "N"}}};
constexpr std::array<LawColumn, 10> kForceOutputs{{{"fh_published_N", "N"},
                                                   {"fp_published_N", "N"},
                                                   {"fd_published_N", "N"},
                                                   {"fh_exact_N", "N"},
                                                   {"fp_exact_N", "N"},
                                                   {"fd_exact_N", "N"},
                                                   {"torque_h_exact_Nm", "N·m"},
                                                   {"torque_p_exact_Nm", "N·m"},
                                                   {"error_N", "N"},
                                                   {"error_percent", "%"}}};
constexpr std::array<LawParameter, 1> kForceParameters{{{"depth_m", "m", 0.18, 0.01, 1.0}}};

void evaluateForces(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const core::Vec3 f(in[2], in[3], in[4]);
    const PolarForces published = GimbalKinematics::polarAsPublished(in[0], in[1], f);
    const PolarForces exact = GimbalKinematics::polarExact(in[0], in[1], f);
    GimbalCoordinates q;
    q.h = in[0];
    q.p = in[1];
    q.d = p[0];
    core::Wrench wrench;
    wrench.force = GimbalKinematics::directionToD(f);
    const GimbalVector torque = GimbalKinematics::efforts(q, wrench, PolarMap::exact);
    const core::Vec3 difference(published.heading_N - exact.heading_N, published.pitch_N - exact.pitch_N,
                                published.depth_N - exact.depth_N);
    const std::array<double, 8> values{published.heading_N, published.pitch_N, published.depth_N,
                                       exact.heading_N,     exact.pitch_N,     exact.depth_N,
                                       torque[0],           torque[1]};
    for (std::size_t i = 0; i < values.size(); ++i)
        out[i] = values[i];
    // The three exact directions are orthonormal, so the error of the resulting force is the norm of the
    // difference.
    out[8] = difference.norm();
    out[9] = f.norm() > 0.0 ? 100.0 * difference.norm() / f.norm() : 0.0;
}

constexpr std::array<LawColumn, 2> kWeightInputs{{{"h_rad", "rad"}, {"p_rad", "rad"}}};
constexpr std::array<LawColumn, 6> kWeightOutputs{{{"fh_published_N", "N"},
                                                   {"fp_published_N", "N"},
                                                   {"fd_published_N", "N"},
                                                   {"fh_exact_N", "N"},
                                                   {"fp_exact_N", "N"},
                                                   {"fd_exact_N", "N"}}};
constexpr std::array<LawParameter, 1> kWeightParameters{{{"mass_kg", "kg", 0.010, 0.0, 10.0}}};

void evaluateWeight(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const PolarForces published = GimbalKinematics::weightAsPublished(in[0], in[1], p[0]);
    const core::Vec3 weight_D(0.0, 0.0, -p[0] * core::kStandardGravity);
    const PolarForces exact =
        GimbalKinematics::polarExact(in[0], in[1], GimbalKinematics::directionToVendor(weight_D));
    const std::array<double, 6> values{published.heading_N, published.pitch_N, published.depth_N,
                                       exact.heading_N,     exact.pitch_N,     exact.depth_N};
    for (std::size_t i = 0; i < values.size(); ++i)
        out[i] = values[i];
}

constexpr FiveBarGeometry kLinkage{};
constexpr std::array<LawParameter, 3> kLinkageParameters{
    {{"proximal_m", "m", kLinkage.proximal_m, 0.01, 1.0},
     {"distal_m", "m", kLinkage.distal_m, 0.01, 1.0},
     {"half_base_m", "m", kLinkage.halfBase_m, 0.0, 1.0}}};

FiveBarLoop loopOf(std::span<const double> p, std::span<const double> in) noexcept {
    FiveBarGeometry geometry;
    geometry.proximal_m = p[0];
    geometry.distal_m = p[1];
    geometry.halfBase_m = p[2];
    return FiveBarKinematics(geometry).loop(in[0], in[1]);
}

/// Checks that the links meet and are not in line: in line they transmit no force.
std::string linkageProblem(std::span<const double> p, std::span<const double> in) {
    if (in.empty())
        return {};
    const FiveBarLoop loop = loopOf(p, in);
    if (!loop.closed)
        return "theta1_rad, theta2_rad: the elbows are " +
               std::to_string((loop.elbow[1] - loop.elbow[0]).norm()) +
               " m apart: expected more than 0 and at most twice distal_m, or the links do not meet";
    return std::abs(loop.determinant) > 1e-9 * p[1] * p[1]
               ? ""
               : "theta1_rad, theta2_rad: the distal links are in line: expected angles off this singularity";
}

constexpr std::array<LawColumn, 2> kPoseInputs{{{"theta1_rad", "rad"}, {"theta2_rad", "rad"}}};
constexpr std::array<LawColumn, 8> kPoseOutputs{{{"y_m", "m"},
                                                 {"z_m", "m"},
                                                 {"dy_dtheta1_m", "m/rad"},
                                                 {"dy_dtheta2_m", "m/rad"},
                                                 {"dz_dtheta1_m", "m/rad"},
                                                 {"dz_dtheta2_m", "m/rad"},
                                                 {"det_a_m2", "m²"},
                                                 {"condition", "1"}}};

void evaluatePose(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const FiveBarLoop loop = loopOf(p, in);
    const std::array<double, 8> values{loop.tip.x(),        loop.tip.y(),
                                       loop.jacobian(0, 0), loop.jacobian(0, 1),
                                       loop.jacobian(1, 0), loop.jacobian(1, 1),
                                       loop.determinant,    FiveBarKinematics::conditionNumber(loop)};
    for (std::size_t i = 0; i < values.size(); ++i)
        out[i] = values[i];
}

constexpr std::array<LawColumn, 10> kEffortInputs{{{"theta1_rad", "rad"},
                                                   {"theta2_rad", "rad"},
                                                   {"pitch_rad", "rad"},
                                                   {"yaw_rad", "rad"},
                                                   {"fx_N", "N"},
                                                   {"fy_N", "N"},
                                                   {"fz_N", "N"},
                                                   {"tx_Nm", "N·m"},
                                                   {"ty_Nm", "N·m"},
                                                   {"tz_Nm", "N·m"}}};
constexpr std::array<LawColumn, 5> kEffortOutputs{{{"torque_theta1_Nm", "N·m"},
                                                   {"torque_theta2_Nm", "N·m"},
                                                   {"torque_pitch_Nm", "N·m"},
                                                   {"torque_yaw_Nm", "N·m"},
                                                   {"torque_roll_Nm", "N·m"}}};

void evaluateEfforts(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const core::Vec2 bars = FiveBarKinematics::efforts(loopOf(p, in), {in[4], in[5], in[6]});
    const core::Vec3 joint = SphericalJoint({in[2], in[3], 0.0}).efforts({in[7], in[8], in[9]});
    out[0] = bars[0];
    out[1] = bars[1];
    for (int axis = 0; axis < 3; ++axis)
        out[static_cast<std::size_t>(axis) + 2] = joint[axis];
}

constexpr std::array<core::LawDescription, 4> kLaws{{
    {"polar_forces", "Cartesian force to heading, pitch and depth: as published and exact (vendor axes)",
     "P2, Coordinate System; models.md §2.1", kForceInputs, kForceOutputs, kForceParameters, &evaluateForces},
    {"polar_weight",
     "weight of a mass as heading, pitch and depth forces: as published, and exact with z of D up",
     "P2, Mass Model; models.md §2.1", kWeightInputs, kWeightOutputs, kWeightParameters, &evaluateWeight},
    {"five_bar_pose", "tip, Jacobian, det A and condition number of the five-bar linkage (D)",
     "P1 §2; devices.md §5", kPoseInputs, kPoseOutputs, kLinkageParameters, &evaluatePose, &linkageProblem},
    {"five_bar_efforts",
     "force at the tip and torque about it to torques of the linkage and the spherical joint (D)",
     "P1 §2; devices.md §5", kEffortInputs, kEffortOutputs, kLinkageParameters, &evaluateEfforts,
     &linkageProblem},
}};

} // namespace

std::span<const core::LawDescription> evaluateLaws() noexcept {
    return kLaws;
}

} // namespace chiron::mechanisms
