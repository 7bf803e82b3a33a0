// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/evaluate_laws.h"

#include "core/units.h"
#include "simulation/attributes/coulomb_friction.h"
#include "simulation/attributes/evaluate_attributes.h"
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_law.h"
#include "simulation/geometry/mesh/evaluate_mesh.h"
#include "simulation/geometry/urethra/evaluate_urethra_geometry.h"
#include "simulation/palpation/evaluate_palpation.h"

#include <array>

namespace chiron::simulation {

namespace {

using core::LawColumn;
using core::LawParameter;

constexpr std::array<LawColumn, 6> kHemisphereInputs{{{"px_m", "m"},
                                                      {"py_m", "m"},
                                                      {"pz_m", "m"},
                                                      {"vx_m_per_s", "m/s"},
                                                      {"vy_m_per_s", "m/s"},
                                                      {"vz_m_per_s", "m/s"}}};
constexpr std::array<LawColumn, 8> kHemisphereOutputs{{{"fx_N", "N"},
                                                       {"fy_N", "N"},
                                                       {"fz_N", "N"},
                                                       {"depth_m", "m"},
                                                       {"nx", "1"},
                                                       {"ny", "1"},
                                                       {"nz", "1"},
                                                       {"energy_J", "J"}}};
constexpr std::array<LawParameter, 14> kHemisphereParameters{{
    {"radius_m", "m", 0.020, 0.001, 0.2},
    {"plane_height_m", "m", 0.0, -1.0, 1.0},
    {"centre_x_m", "m", 0.0, -1.0, 1.0},
    {"centre_y_m", "m", 0.0, -1.0, 1.0},
    {"stiffness_N_per_m", "N/m", 500.0, 0.0, 10000.0},
    {"stiffness_variation", "1", 0.0, 0.0, 0.99},
    {"stiffness_wavelength_m", "m", 0.030, 0.001, 1.0},
    {"stiffness_phase_x_rad", "rad", 0.0, -2.0 * core::kPi, 2.0 * core::kPi},
    {"stiffness_phase_y_rad", "rad", 0.0, -2.0 * core::kPi, 2.0 * core::kPi},
    {"damping_Ns_per_m", "N·s/m", 1.0, 0.0, 100.0},
    {"dimple_depth_m", "m", 0.0, 0.0, 0.01},
    {"dimple_radius_m", "m", 0.006, 0.0005, 0.1},
    {"dimple_x_m", "m", 0.010, -1.0, 1.0},
    {"dimple_y_m", "m", 0.0, -1.0, 1.0},
}};

HemisphereContact hemisphereFrom(std::span<const double> p, double damping_Ns_per_m) noexcept {
    HemisphereContact::Parameters law;
    law.surface = {p[0], p[1], core::Vec2(p[2], p[3])};
    law.stiffness = {p[4], p[5], p[6], core::Vec2(p[7], p[8])};
    law.damping_Ns_per_m = damping_Ns_per_m;
    law.dimple = {p[10], p[11], core::Vec2(p[12], p[13])};
    return HemisphereContact(law);
}

/// Where the stiffness changes so steeply that −∇U would pull, the contact lets go instead and loops make energy.
std::string hemisphereProblem(std::span<const double> p, std::span<const double> in) {
    if (in.empty() || !(p[4] > 0.0))
        return {};
    const ContactResponse still = hemisphereFrom(p, 0.0).respond(core::Vec3(in[0], in[1], in[2]), core::Vec3::Zero());
    if (!still.inContact || still.normalForce_N > 0.0)
        return {};
    return core::lawProblem("depth_m", still.depth_m,
                            "a shallower contact, a smaller stiffness_variation or a longer stiffness_wavelength_m: the stiffness changes so "
                            "steeply here that the surface would pull");
}

void evaluateHemisphere(std::span<const double> p, std::span<const double> in,
                        std::span<double> out) noexcept {
    const ContactResponse response =
        hemisphereFrom(p, p[9]).respond(core::Vec3(in[0], in[1], in[2]), core::Vec3(in[3], in[4], in[5]));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out[axis] = response.force[static_cast<Eigen::Index>(axis)];
        out[4 + axis] = response.normal[static_cast<Eigen::Index>(axis)];
    }
    out[3] = response.depth_m;
    out[7] = response.energy_J;
}

constexpr std::array<LawColumn, 2> kFrictionInputs{{{"normal_force_N", "N"}, {"velocity_m_per_s", "m/s"}}};
constexpr std::array<LawColumn, 2> kFrictionOutputs{
    {{"friction_force_N", "N"}, {"regularisation_velocity_m_per_s", "m/s"}}};
/// A regularisation velocity of 0 asks for the rule of models.md §0.
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

/// Laws with a file of their own hand out a constant of theirs.
const std::array<core::LawDescription, 18> kLaws{{
    {"hemisphere", "hemisphere on a plane: elastic and damped contact of the sphere-apex exercise",
     "models.md §0 and §2.3", kHemisphereInputs, kHemisphereOutputs, kHemisphereParameters,
     &evaluateHemisphere, &hemisphereProblem},
    {"friction", "Coulomb friction regularised by velocity, F = -mu N V / sqrt(V^2 + V0^2)",
     "P1 eq. 1; models.md §0 and §1.2", kFrictionInputs, kFrictionOutputs, kFrictionParameters,
     &evaluateFriction},
    urethraCentrelineLaw(),
    urethraProfileLaw(),
    urethraSurfaceLaw(),
    urethraForceLaw(),
    elasticityLaw(),
    strainStiffeningLaw(),
    massLaw(),
    deformationLaw(),
    roughnessLaw(),
    bristleFrictionLaw(),
    viscosityLaw(),
    elasticTubeLaw(),
    meshContactLaw(),
    voigtLaw(),
    palpationContactLaw(),
    palpationLumpLaw(),
}};

} // namespace

std::span<const core::LawDescription> evaluateLaws() noexcept {
    return kLaws;
}

} // namespace chiron::simulation
