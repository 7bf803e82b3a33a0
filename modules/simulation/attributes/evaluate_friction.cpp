// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/attributes/evaluate_friction.h"

#include "simulation/attributes/coulomb_friction.h"

#include <array>

namespace chiron::simulation {

namespace {

using core::LawColumn;
using core::LawParameter;

constexpr std::array<LawColumn, 2> kFrictionInputs{{{"normal_force_N", "N"}, {"velocity_m_per_s", "m/s"}}};
constexpr std::array<LawColumn, 2> kFrictionOutputs{
    {{"friction_force_N", "N"}, {"regularisation_velocity_m_per_s", "m/s"}}};
/// A regularisation velocity of 0 selects the rule of models.md §0.
constexpr std::array<LawParameter, 4> kFrictionParameters{{
    {"mu", "1", 0.3, 0.0, 5.0},
    {"regularisation_velocity_m_per_s", "m/s", 0.0, 0.0, 1.0},
    {"count_m", "m", 0.0, 0.0, 0.001},
    {"maximum_damping_Ns_per_m", "N·s/m", CoulombFriction::kMaximumDamping_Ns_per_m, 0.1, 1000.0},
}};

void evaluateFriction(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const double normalForce = in[0] > 0.0 ? in[0] : 0.0; // a surface does not pull
    const double v0 =
        p[1] > 0.0 ? p[1] : CoulombFriction::regularisationVelocity(p[0], normalForce, p[2], p[3]);
    out[0] = CoulombFriction::force(p[0], normalForce, in[1], v0);
    out[1] = v0;
}

} // namespace

core::LawDescription frictionLaw() noexcept {
    return {"friction",
            "Coulomb friction regularised by velocity, F = -mu N V / sqrt(V^2 + V0^2)",
            "P1 eq. 1; models.md §0 and §1.2",
            kFrictionInputs,
            kFrictionOutputs,
            kFrictionParameters,
            &evaluateFriction};
}

} // namespace chiron::simulation
