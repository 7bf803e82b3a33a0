// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/palpation/evaluate_palpation.h"

#include "core/units.h"
#include "simulation/palpation/contact_frame.h"
#include "simulation/palpation/lean.h"
#include "simulation/palpation/lump_law.h"

#include <array>
#include <cmath>

namespace chiron::simulation {

namespace {

using core::LawColumn;
using core::LawParameter;
using core::Vec3;

constexpr std::array<LawColumn, 6> kVoigtInputs{{{"dx_m", "m"},
                                                 {"dy_m", "m"},
                                                 {"dz_m", "m"},
                                                 {"vx_m_per_s", "m/s"},
                                                 {"vy_m_per_s", "m/s"},
                                                 {"vz_m_per_s", "m/s"}}};
constexpr std::array<LawColumn, 4> kVoigtOutputs{
    {{"fx_N", "N"}, {"fy_N", "N"}, {"fz_N", "N"}, {"energy_J", "J"}}};
/// Defaults: P3, figure 6.
constexpr std::array<LawParameter, 6> kVoigtParameters{{{"kx_N_per_m", "N/m", 800.0, 0.0, 100000.0},
                                                        {"ky_N_per_m", "N/m", 700.0, 0.0, 100000.0},
                                                        {"kz_N_per_m", "N/m", 650.0, 0.0, 100000.0},
                                                        {"bx_Ns_per_m", "N·s/m", 0.050, 0.0, 1000.0},
                                                        {"by_Ns_per_m", "N·s/m", 0.045, 0.0, 1000.0},
                                                        {"bz_Ns_per_m", "N·s/m", 0.055, 0.0, 1000.0}}};

/// The inputs are in the contact frame: d from the tool to its contact point (dz is the depth), and v, the
/// rate at which d grows. Without depth there is no contact.
void evaluateVoigt(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    for (double& value : out)
        value = 0.0;
    if (!(in[2] > 0.0))
        return;
    const Vec3 k(p[0], p[1], p[2]), b(p[3], p[4], p[5]);
    const Vec3 d(in[0], in[1], in[2]), v(in[3], in[4], in[5]);
    const Vec3 f = voigtForce(k, d, b, v);
    for (std::size_t axis = 0; axis < 3; ++axis)
        out[axis] = 0.0 + f[static_cast<Eigen::Index>(axis)]; // not -0 at rest
    out[3] = 0.5 * k.cwiseProduct(d).dot(d);
}

constexpr std::array<LawColumn, 6> kContactInputs{
    {{"fx_N", "N"}, {"fy_N", "N"}, {"fz_N", "N"}, {"nx", "1"}, {"ny", "1"}, {"nz", "1"}}};
constexpr std::array<LawColumn, 5> kContactOutputs{{{"alpha_rad", "rad"},
                                                    {"normal_force_N", "N"},
                                                    {"pitch_rad", "rad"},
                                                    {"roll_rad", "rad"},
                                                    {"saturated", "1"}}};
constexpr std::array<LawParameter, 6> kContactParameters{
    {{"finger_x", "1", 1.0, -1.0, 1.0},
     {"finger_y", "1", 0.0, -1.0, 1.0},
     {"finger_z", "1", 0.0, -1.0, 1.0},
     {"largest_pitch_rad", "rad", LeanLimits{}.pitch_rad, 0.01, 0.5 * core::kPi},
     {"largest_roll_rad", "rad", LeanLimits{}.roll_rad, 0.01, 0.5 * core::kPi},
     {"largest_lean_rad", "rad", LeanLimits{}.lean_rad, 0.01, 0.5 * core::kPi}}};

std::string contactProblem(std::span<const double> p, std::span<const double> in) {
    if (!(Vec3(p[0], p[1], p[2]).norm() > 0.0))
        return "finger_x, finger_y, finger_z 0: expected a direction across the finger, of any length but 0";
    return !in.empty() && !(Vec3(in[3], in[4], in[5]).norm() > 0.0)
               ? "nx, ny, nz 0: expected a normal of any length but 0"
               : "";
}

/// n may have any length but 0 (then nothing is shown); (finger_x, finger_y, finger_z) points across the
/// finger and may have any length.
void evaluateContact(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const Vec3 n(in[3], in[4], in[5]), x(p[0], p[1], p[2]);
    const double length = n.norm();
    for (double& value : out)
        value = 0.0;
    if (!(length > 0.0))
        return;
    const Lean lean = leanOf(Vec3(in[0], in[1], in[2]), n / length,
                             x.norm() > 0.0 ? Vec3(x.normalized()) : Vec3(Vec3::UnitX()), {p[3], p[4], p[5]});
    out[0] = lean.angle_rad;
    out[1] = lean.normalForce_N;
    out[2] = 0.0 + lean.display.pitch_rad;
    out[3] = 0.0 + lean.display.roll_rad;
    out[4] = lean.saturated ? 1.0 : 0.0;
}

constexpr std::array<LawColumn, 2> kLumpInputs{{{"depth_m", "m"}, {"rho_m", "m"}}};
constexpr std::array<LawColumn, 4> kLumpOutputs{
    {{"chi", "1"}, {"normal_force_N", "N"}, {"lateral_force_N", "N"}, {"energy_J", "J"}}};
constexpr std::array<LawParameter, 6> kLumpParameters{
    {{"a_m", "m", 0.005, 0.0005, 0.05},
     {"R_m", "m", 0.0075, 0.0, 0.1},
     {"h_m", "m", 0.012, 0.0005, 0.2},
     {"m", "1", 10.0, 0.0, 1000.0},
     {"k_N_per_m", "N/m", 2.0 * 0.005 * 17e3 / 0.75, 0.0, 100000.0},
     {"lambda", "1", 0.25, 0.0, 1.0}}};

/// Checks the range in which the law of models.md §3 is valid: R ≤ 0.75 h, a ≤ h/2, λ d ≤ (h − R)/2. Content
/// is held to the same limits.
std::string lumpProblem(std::span<const double> p, std::span<const double> in) {
    if (p[1] == 0.0) // no lump
        return {};
    if (p[1] > 0.75 * p[2])
        return core::lawProblem("R_m", p[1],
                                "at most 0.75 h_m, or the lump comes too near to the surface for the law");
    if (p[0] > 0.5 * p[2])
        return core::lawProblem("a_m", p[0], "at most 0.5 h_m, or the contact is too wide for the law");
    if (!in.empty() && p[5] * in[0] > 0.5 * (p[2] - p[1]))
        return core::lawProblem(
            "depth_m", in[0],
            "lambda depth_m at most (h_m - R_m)/2, or the contact comes too near to the lump for the law");
    return {};
}

/// Above the surface (depth_m ≤ 0) χ is the value that a touch would meet, and there is no force.
void evaluateLump(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const double depth = in[0] > 0.0 ? in[0] : 0.0;
    SunkContact at;
    at.q_W = Vec3(in[1], 0.0, p[2] - p[5] * depth);
    at.depth_m = depth;
    at.sinkage = p[5];
    at.spread2_m2 = 5.0 / 3.0 * p[0] * p[0];
    StiffnessGain sum;
    addLump(at, Vec3::Zero(), lumpStrength(p[0], p[1], p[3]), sum);
    out[0] = sum.gain;
    out[1] = p[4] * (depth * (1.0 + sum.gain) - sum.lateral_m2.z());
    out[2] = 0.0 - p[4] * sum.lateral_m2.x();
    out[3] = 0.5 * p[4] * depth * depth * (1.0 + sum.gain);
}

} // namespace

core::LawDescription voigtLaw() noexcept {
    return {"voigt",
            "anisotropic Voigt contact in the contact frame (x along the fibres, z = normal), F = K d + B v, "
            "pushes out, normal part >= 0; "
            "conservative at v = 0",
            "P3 eq. 1; models.md §3",
            kVoigtInputs,
            kVoigtOutputs,
            kVoigtParameters,
            &evaluateVoigt};
}

core::LawDescription palpationContactLaw() noexcept {
    return {"palpation-contact",
            "what the fingertip platform shows of a force: lean angle alpha (unlimited), normal force, alpha "
            "split into limited pitch and roll",
            "P3 eq. 2 and 3; models.md §3",
            kContactInputs,
            kContactOutputs,
            kContactParameters,
            &evaluateContact,
            &contactProblem};
}

core::LawDescription palpationLumpLaw() noexcept {
    return {"palpation-lump",
            "a stiff ball felt through the tissue, U = k d^2 (1 + chi)/2, chi = (8/pi) a R^3 H^2/(rho^2 + "
            "H^2)^3 (m - 1)/(1 + 0.4 (m - 1)), "
            "H^2 = (h - lambda d)^2 + (5/3) a^2; lateral force outward; conservative",
            "models.md §3; Johnson, Contact Mechanics; Eshelby 1957",
            kLumpInputs,
            kLumpOutputs,
            kLumpParameters,
            &evaluateLump,
            &lumpProblem};
}

} // namespace chiron::simulation
