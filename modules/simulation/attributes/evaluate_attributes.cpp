// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/attributes/evaluate_attributes.h"

#include "simulation/attributes/deformation.h"
#include "simulation/attributes/elasticity.h"
#include "simulation/attributes/mass.h"
#include "simulation/attributes/viscosity.h"

#include <algorithm>
#include <array>

namespace chiron::simulation {

namespace {

using core::LawColumn;
using core::LawParameter;

constexpr LawParameter kStiffness{"stiffness_N_per_m", "N/m", 500.0, 0.0, 100000.0};

constexpr std::array<LawColumn, 1> kExtension{{{"x_m", "m"}}};
constexpr std::array<LawColumn, 3> kSpring{{{"force_N", "N"}, {"energy_J", "J"}, {"slope_N_per_m", "N/m"}}};
constexpr std::array<LawParameter, 1> kElasticityParameters{{kStiffness}};
constexpr std::array<LawParameter, 2> kStiffeningParameters{
    {kStiffness, {"stiffening_per_m", "1/m", 60.0, 0.0, 10000.0}}};

void writeSpring(const ElasticLaw& law, double x_m, std::span<double> out) noexcept {
    out[0] = 0.0 - law.tension(x_m); // not -0 at rest
    out[1] = law.energy(x_m);
    out[2] = law.slope(x_m);
}

void evaluateElasticity(std::span<const double> p, std::span<const double> in,
                        std::span<double> out) noexcept {
    writeSpring({p[0], 0.0}, in[0], out);
}

void evaluateStiffening(std::span<const double> p, std::span<const double> in,
                        std::span<double> out) noexcept {
    writeSpring({p[0], p[1]}, in[0], out);
}

constexpr std::array<LawColumn, 4> kMassInputs{
    {{"height_m", "m"}, {"ax_m_per_s2", "m/s²"}, {"ay_m_per_s2", "m/s²"}, {"az_m_per_s2", "m/s²"}}};
constexpr std::array<LawColumn, 7> kMassOutputs{{{"weight_x_N", "N"},
                                                 {"weight_y_N", "N"},
                                                 {"weight_z_N", "N"},
                                                 {"energy_J", "J"},
                                                 {"with_inertia_x_N", "N"},
                                                 {"with_inertia_y_N", "N"},
                                                 {"with_inertia_z_N", "N"}}};
constexpr std::array<LawParameter, 1> kMassParameters{{{"mass_kg", "kg", 0.010, 0.0, 10.0}}};

void evaluateMass(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const core::Vec3 weight = Mass::weight(p[0]);
    const core::Vec3 all = weight + Mass::inertia(p[0], core::Vec3(in[1], in[2], in[3]));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out[axis] = weight[static_cast<Eigen::Index>(axis)];
        out[4 + axis] = all[static_cast<Eigen::Index>(axis)];
    }
    out[3] = Mass::energy(p[0], in[0]);
}

constexpr std::array<LawColumn, 3> kDeformationInputs{
    {{"depth_m", "m"}, {"held_s", "s"}, {"released_s", "s"}}};
constexpr std::array<LawColumn, 6> kDeformationOutputs{{{"force_at_once_N", "N"},
                                                        {"force_N", "N"},
                                                        {"force_steady_N", "N"},
                                                        {"energy_J", "J"},
                                                        {"surface_m", "m"},
                                                        {"energy_released_J", "J"}}};
constexpr std::array<LawParameter, 4> kDeformationParameters{{kStiffness,
                                                              {"stiffening_per_m", "1/m", 0.0, 0.0, 10000.0},
                                                              {"recovery_share", "1", 0.5, 0.0, 10.0},
                                                              {"recovery_s", "s", 0.3, 0.0, 100.0}}};

std::string deformationProblem(std::span<const double>, std::span<const double> in) {
    if (in.empty())
        return {};
    if (in[1] < 0.0)
        return core::lawProblem("held_s", in[1], "at least 0");
    return in[2] < 0.0 ? core::lawProblem("released_s", in[2], "at least 0") : std::string();
}

/// Presses to depth_m at time 0 and holds it until held_s (force_N). The tool then stays away for released_s,
/// after which the surface lies at surface_m.
void evaluateDeformation(std::span<const double> p, std::span<const double> in,
                         std::span<double> out) noexcept {
    const Deformation::Parameters law{{p[0], p[1]}, p[2] * p[0], p[3]};
    Deformation dent;
    out[0] = dent.press(law, in[0], 0.0).force_N;
    const DeformationResponse held = dent.press(law, in[0], std::max(0.0, in[1]));
    out[1] = held.force_N;
    out[2] = law.elastic.tension(std::max(0.0, in[0]));
    out[3] = held.energy_J;
    dent.press(law, 0.0, 0.0); // the tool leaves
    const DeformationResponse left = dent.press(law, 0.0, std::max(0.0, in[2]));
    out[4] = left.surface_m;
    out[5] = left.energy_J;
}

constexpr std::array<LawColumn, 4> kViscosityInputs{
    {{"depth_m", "m"}, {"vx_m_per_s", "m/s"}, {"vy_m_per_s", "m/s"}, {"vz_m_per_s", "m/s"}}};
constexpr std::array<LawColumn, 4> kViscosityOutputs{
    {{"fx_N", "N"}, {"fy_N", "N"}, {"fz_N", "N"}, {"power_W", "W"}}};
constexpr std::array<LawParameter, 1> kViscosityParameters{
    {{"viscosity_Ns_per_m", "N·s/m", 1.0, 0.0, 100.0}}};

void evaluateViscosity(std::span<const double> p, std::span<const double> in,
                       std::span<double> out) noexcept {
    const core::Vec3 v(in[1], in[2], in[3]);
    const core::Vec3 f = Viscosity::force(p[0], in[0], v);
    for (std::size_t axis = 0; axis < 3; ++axis)
        out[axis] = 0.0 + f[static_cast<Eigen::Index>(axis)]; // not -0 at rest
    out[3] = 0.0 + f.dot(v);
}

constexpr std::array<LawColumn, 1> kTubeInputs{{{"length_m", "m"}}};
constexpr std::array<LawColumn, 4> kTubeOutputs{
    {{"stretch_m", "m"}, {"tension_N", "N"}, {"energy_J", "J"}, {"slope_N_per_m", "N/m"}}};
constexpr std::array<LawParameter, 4> kTubeParameters{{{"rest_length_m", "m", 0.045, 0.001, 1.0},
                                                       {"stiffness_N_per_m", "N/m", 60.0, 0.0, 100000.0},
                                                       {"stiffening_per_m", "1/m", 0.0, 0.0, 10000.0},
                                                       {"segment_share", "1", 1.0, 0.001, 1.0}}};

std::string tubeProblem(std::span<const double>, std::span<const double> in) {
    return !in.empty() && in[0] < 0.0 ? core::lawProblem("length_m", in[0], "at least 0") : std::string();
}

/// A segment of rest length l = share · L0, taut at `length_m`. All parts of the tube are strained equally,
/// so the whole tube would be stretched by x = (length − l)/share. T = F(x), U = share · U_F(x); both are 0
/// when slack.
void evaluateTube(std::span<const double> p, std::span<const double> in, std::span<double> out) noexcept {
    const ElasticLaw law{p[1], p[2]};
    const double stretch = in[0] - p[3] * p[0];
    const bool taut = stretch > 0.0;
    const double x = taut ? stretch / p[3] : 0.0;
    out[0] = taut ? stretch : 0.0;
    out[1] = law.tension(x);
    out[2] = p[3] * law.energy(x);
    out[3] = taut ? law.slope(x) / p[3] : 0.0;
}

} // namespace

core::LawDescription elasticityLaw() noexcept {
    return {"elasticity",
            "linear elasticity along a line, f = -k x, U = k x^2/2; conservative",
            "models.md §2.2",
            kExtension,
            kSpring,
            kElasticityParameters,
            &evaluateElasticity};
}

core::LawDescription strainStiffeningLaw() noexcept {
    return {"strain-stiffening",
            "elasticity that stiffens, f = -(k/b)(exp(bx) - 1), U = (k/b^2)(exp(bx) - 1 - bx), straight "
            "beyond bx = 20; conservative",
            "models.md §2.2; P2, Elastic Tube Model",
            kExtension,
            kSpring,
            kStiffeningParameters,
            &evaluateStiffening};
}

core::LawDescription massLaw() noexcept {
    return {"mass",
            "weight of what is lifted, f = (0, 0, -m g) in W, and with -m a; polar_weight has it by heading, "
            "pitch and depth",
            "P2, Mass Model; models.md §2.1",
            kMassInputs,
            kMassOutputs,
            kMassParameters,
            &evaluateMass};
}

core::LawDescription deformationLaw() noexcept {
    return {"deformation",
            "a surface as a standard linear solid, f = k d + k1 (d - q), q' = (d - q)/tau; not conservative",
            "P2, Deformation Model; models.md §2.2",
            kDeformationInputs,
            kDeformationOutputs,
            kDeformationParameters,
            &evaluateDeformation,
            &deformationProblem};
}

core::LawDescription viscosityLaw() noexcept {
    return {"viscosity",
            "viscosity inside an object, f = -b min(1, d/0.5 mm) v; not conservative",
            "P2, Viscosity; models.md §0 and §2.2",
            kViscosityInputs,
            kViscosityOutputs,
            kViscosityParameters,
            &evaluateViscosity};
}

core::LawDescription elasticTubeLaw() noexcept {
    return {"elastic-tube",
            "tension and energy of a massless tube, or a segment of it, from its length; slack below its "
            "rest length; conservative",
            "P2, Elastic Tube Model; models.md §2.4",
            kTubeInputs,
            kTubeOutputs,
            kTubeParameters,
            &evaluateTube,
            &tubeProblem};
}

} // namespace chiron::simulation
