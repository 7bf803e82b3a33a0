// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/attributes/bristle_friction.h"
#include "simulation/attributes/evaluate_attributes.h"
#include "simulation/attributes/roughness.h"

#include <array>

namespace chiron::simulation {

namespace {

using core::LawColumn;
using core::LawParameter;

constexpr std::array<LawColumn, 3> kRoughnessInputs{{{"px_m", "m"}, {"py_m", "m"}, {"depth_m", "m"}}};
constexpr std::array<LawColumn, 7> kRoughnessOutputs{{{"height_m", "m"},
                                                      {"slope_x", "1"},
                                                      {"slope_y", "1"},
                                                      {"fx_N", "N"},
                                                      {"fy_N", "N"},
                                                      {"fz_N", "N"},
                                                      {"energy_J", "J"}}};
constexpr std::array<LawParameter, 4> kRoughnessParameters{
    {{"roughness_m", "m", 0.00004, 0.0, 0.001},
     {"wavelength_m", "m", 0.003, 0.001, 0.1},
     {"seed", "1", 1.0, 0.0, 1e9, true},
     {"stiffness_N_per_m", "N/m", 500.0, 0.0, 100000.0}}};

/// Evaluates roughness on the plane z = 0 for a tool at (px, py, −depth).
void evaluateRoughness(std::span<const double> p, std::span<const double> in,
                       std::span<double> out) noexcept {
    const RoughnessSample micro =
        Roughness(p[0], p[1], static_cast<std::uint64_t>(p[2])).sample(core::Vec3(in[0], in[1], 0.0));
    out[0] = micro.height_m;
    out[1] = micro.gradient.x();
    out[2] = micro.gradient.y();
    const double depth = in[2] + micro.height_m;
    const double force = depth > 0.0 ? p[3] * depth : 0.0;
    out[3] = 0.0 - force * micro.gradient.x();
    out[4] = 0.0 - force * micro.gradient.y();
    out[5] = force;
    out[6] = 0.5 * force * (depth > 0.0 ? depth : 0.0);
}

constexpr std::array<LawColumn, 5> kBristleInputs{{{"stretch_x_m", "m"},
                                                   {"stretch_y_m", "m"},
                                                   {"displacement_x_m", "m"},
                                                   {"displacement_y_m", "m"},
                                                   {"normal_force_N", "N"}}};
constexpr std::array<LawColumn, 6> kBristleOutputs{{{"fx_N", "N"},
                                                    {"fy_N", "N"},
                                                    {"stretch_x_m", "m"},
                                                    {"stretch_y_m", "m"},
                                                    {"energy_J", "J"},
                                                    {"slips", "1"}}};
constexpr std::array<LawParameter, 2> kBristleParameters{
    {{"mu", "1", 0.3, 0.0, 5.0}, {"bristle_stiffness_N_per_m", "N/m", 1000.0, 1.0, 100000.0}}};

/// Two updates without a limit bring the bristle to the given stretch; the third makes the row's step, with
/// its limit.
void evaluateBristle(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const double normalForce = in[4] > 0.0 ? in[4] : 0.0; // a surface does not pull
    const core::Vec3 before(in[0], in[1], 0.0);
    const core::Vec3 wanted = before + core::Vec3(in[2], in[3], 0.0);
    const double loose = 2.0 * p[1] * (before.norm() + wanted.norm() + 1.0);
    BristleFriction bristle;
    bristle.update(core::Vec3::Zero(), core::Vec3::UnitZ(), loose, 1.0, p[1]);
    bristle.update(before, core::Vec3::UnitZ(), loose, 1.0, p[1]);
    const core::Vec3 f = bristle.update(wanted, core::Vec3::UnitZ(), normalForce, p[0], p[1]);
    out[0] = 0.0 + f.x();
    out[1] = 0.0 + f.y();
    out[2] = 0.0 + bristle.stretch().x();
    out[3] = 0.0 + bristle.stretch().y();
    out[4] = 0.5 * p[1] * bristle.stretch().squaredNorm();
    out[5] = wanted.norm() * p[1] > p[0] * normalForce ? 1.0 : 0.0;
}

} // namespace

core::LawDescription roughnessLaw() noexcept {
    return {"roughness",
            "pseudo-random micro-height h of a plane, white up to 1/wavelength, and the force of U = k (d + "
            "h)^2/2; conservative",
            "P2, Roughness; models.md §2.2",
            kRoughnessInputs,
            kRoughnessOutputs,
            kRoughnessParameters,
            &evaluateRoughness};
}

core::LawDescription bristleFrictionLaw() noexcept {
    return {"bristle-friction",
            "one step of the clipped bristle: stretch before (0 at first contact) and displacement to force "
            "and stretch after; "
            "not conservative",
            "models.md §2.2",
            kBristleInputs,
            kBristleOutputs,
            kBristleParameters,
            &evaluateBristle};
}

} // namespace chiron::simulation
