// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact_law.h"

#include "core/units.h"
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"

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

/// Where the stiffness changes so steeply that −∇U would pull, the contact lets go instead, and loops create
/// energy.
std::string hemisphereProblem(std::span<const double> p, std::span<const double> in) {
    if (in.empty() || !(p[4] > 0.0))
        return {};
    const ContactResponse still =
        hemisphereFrom(p, 0.0).respond(core::Vec3(in[0], in[1], in[2]), core::Vec3::Zero());
    if (!still.inContact || still.normalForce_N > 0.0)
        return {};
    return core::lawProblem("depth_m", still.depth_m,
                            "a shallower contact, a smaller stiffness_variation or a longer "
                            "stiffness_wavelength_m: the stiffness changes so "
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

} // namespace

core::LawDescription hemisphereLaw() noexcept {
    return {"hemisphere",
            "hemisphere on a plane: elastic and damped contact of the sphere-apex exercise",
            "models.md §0 and §2.3",
            kHemisphereInputs,
            kHemisphereOutputs,
            kHemisphereParameters,
            &evaluateHemisphere,
            &hemisphereProblem};
}

} // namespace chiron::simulation
