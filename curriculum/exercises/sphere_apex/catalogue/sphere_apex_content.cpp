// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/sphere_apex/catalogue/sphere_apex_content.h"

#include "catalogue/yield_content.h"
#include "core/units.h"
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"
#include "simulation/geometry/mesh/make_mesh.h"

#include <algorithm>
#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::SphereApexParameters;
using Row = ParameterRow<Parameters>;
using simulation::ApexSurface;

/// The parameters of a level, in the order of the schema.
const std::vector<Row>& rows() {
    static const std::vector<Row> kRows{
        Row::number("radius_mm", units::kMm, {5, 50}, &Parameters::radius_m, "Of the hemisphere."),
        Row::number("plane_height_mm", units::kMm, {-100, 100}, &Parameters::planeHeight_m,
                    "Height of the plane in the world frame."),
        Row::number("centre_disc_radius_mm", units::kMm, {0, 150}, &Parameters::centreDiscRadius_m,
                    "Centres are drawn uniformly in this disc round the workspace's centre."),
        Row::number("workspace_radius_mm", units::kMm, {10, 200}, &Parameters::workspaceRadius_m,
                    "All of the sphere lies in this disc, seen from above."),
        Row::number("stiffness_low_N_per_m", units::kN_per_m, {50, 2000}, &Parameters::stiffnessLow_N_per_m,
                    "Each trial draws its stiffness uniformly between low and high."),
        Row::number("stiffness_high_N_per_m", units::kN_per_m, {50, 2000}, &Parameters::stiffnessHigh_N_per_m,
                    "Upper end of a trial's stiffness."),
        Row::number(
            "stiffness_variation", units::kPure, {0, 0.8}, &Parameters::stiffnessVariation,
            "a in k(x,y) = k(1 + a g(x,y)) with |g| at most 1: how much stiffness varies over the surface."),
        Row::number("stiffness_wavelength_mm", units::kMm, {5, 100}, &Parameters::stiffnessWavelength_m,
                    "Shortest wavelength of that variation."),
        Row::number("damping_N_s_per_m", units::kNs_per_m, {0, 20}, &Parameters::damping_Ns_per_m,
                    "Along the surface normal, faded in over the first 0.5 mm."),
        Row::number("friction_low", units::kPure, {0, 1}, &Parameters::frictionLow,
                    "Each trial draws its Coulomb coefficient uniformly between low and high."),
        Row::number("friction_high", units::kPure, {0, 1}, &Parameters::frictionHigh,
                    "Upper end of a trial's friction coefficient."),
        Row::number("bristle_stiffness_N_per_m", units::kN_per_m, {100, 2000},
                    &Parameters::bristleStiffness_N_per_m,
                    "Of the clipped bristle that friction is made of."),
        Row::number("dimple_depth_mm", units::kMm, {0, 5}, &Parameters::dimpleDepth_m,
                    "Of a decoy dimple on the ball; 0 for none."),
        Row::number("dimple_radius_mm", units::kMm, {1, 20}, &Parameters::dimpleRadius_m,
                    "Of the dimple, seen from above."),
        Row::number("dimple_offset_mm", units::kMm, {0, 40}, &Parameters::dimpleOffset_m,
                    "Distance of its centre from the apex, seen from above; its direction follows the seed."),
        Row::choice<ApexSurface>(
            "surface",
            {{"exact", ApexSurface::exact}, {"mesh", ApexSurface::mesh}, {"organ", ApexSurface::organ}},
            &Parameters::surface,
            "Ball and plane as formulas, as a bumpy mesh with friction and roughness, or as that mesh "
            "deformable at two rates; stiffness_* is then that of the local model."),
        Row::number("mesh_edge_mm", units::kMm, {0.5, 5}, &Parameters::meshEdge_m,
                    "Mean length of the mesh's edges."),
        Row::number(
            "bump_height_mm", units::kMm, {0, 2}, &Parameters::bumpHeight_m,
            "Amplitude of smooth bumps on the mesh; none at the apex, which stays the highest point."),
        Row::number("bump_wavelength_mm", units::kMm, {3, 50}, &Parameters::bumpWavelength_m,
                    "Shortest wavelength of the bumps."),
        Row::whole<std::uint64_t>("bump_seed", {1, 1000000}, &Parameters::bumpSeed,
                                  "Of the bumps' pattern; each trial turns it by an angle of its own."),
        Row::number("roughness_mm", units::kMm, {0, 0.2}, &Parameters::roughness_m,
                    "Root mean square of the mesh's micro-height."),
        Row::number("roughness_wavelength_mm", units::kMm, {1, 20}, &Parameters::roughnessWavelength_m,
                    "Shortest wavelength of the roughness."),
        Row::number("organ_stiffness_N_per_m", units::kN_per_m, {50, 5000},
                    &Parameters::organStiffness_N_per_m,
                    "K of the organ: a lasting press feels k K / (k + K), a quick one k."),
        Row::number("organ_spread_mm", units::kMm, {1, 30}, &Parameters::organSpread_m,
                    "How far a dent reaches round a press."),
        Row::number("organ_mass_g", units::kG, {1, 500}, &Parameters::organMass_kg, "Of what moves."),
        Row::number("organ_recovery_time_s", units::kS, {0, 2}, &Parameters::organRecoveryTime_s,
                    "How long the organ takes to give way and to come back."),
        Row::number("organ_volume_keeping", units::kPure, {0, 0.95}, &Parameters::organVolumeKeeping,
                    "Share of the volume pressed in that bulges out elsewhere."),
        Row::number("organ_deepest_mm", units::kMm, {1, 20}, &Parameters::organDeepest_m,
                    "A press moves its place by no more than this."),
        Row::whole("slow_period_ms", {20, 50}, &Parameters::slowPeriod_ms,
                   "Between two questions to the slow model, and its step.", "ms"),
        Row::whole("slow_latency_ms", {20, 50}, &Parameters::slowLatency_ms,
                   "From a question to the tick at which its answer takes effect, and how long it is blended "
                   "in: at most slow_period_ms.",
                   "ms"),
        Row::whole("trials", {1, 32}, &Parameters::trials, "In a set."),
        Row::number("trial_limit_s", units::kS, {5, 600}, &Parameters::trialLimit_s,
                    "After it an unmarked trial ends and counts as a miss."),
        Row::number("between_trials_s", units::kS, {0, 30}, &Parameters::betweenTrials_s,
                    "From a mark to the next sphere."),
        Row::number(
            "maximum_force_N", units::kN, {0.5, 10}, &Parameters::maximumForce_N,
            "The exercise's force cap for the supervisor, and the limit of the over-the-limit metrics."),
        yieldForceRow<Parameters>(),
        yieldFallRow<Parameters>()};
    return kRows;
}

QString mm(double length_m) {
    return QString::number(core::mmFromM(length_m)) + QStringLiteral(" mm");
}

void checkOrder(double low, double high, const QString& path, const char* key, Problems& problems) {
    if (low > high)
        problems.push_back({memberPath(path, key), QString::number(low),
                            QStringLiteral("at most the high end, %1").arg(high)});
}

void checkNone(double value, const char* key, const QString& path, Problems& problems) {
    if (value > 0.0)
        problems.push_back(
            {memberPath(path, key), QString::number(value),
             QStringLiteral("0: a surface of triangles has it from bumps and roughness instead")});
}

/// Checks that the mesh can be made, is fine enough to have a ball, and is coarse enough for its organ model.
void checkMesh(const Parameters& p, const QString& path, Problems& problems) {
    checkNone(p.dimpleDepth_m, "dimple_depth_mm", path, problems);
    checkNone(p.stiffnessVariation, "stiffness_variation", path, problems);
    const auto shape = simulation::makeMeshShape(simulation::apexDomeSource(p));
    if (!shape) {
        problems.push_back({memberPath(path, "surface"), QStringLiteral("a mesh that cannot be made"),
                            QString::fromStdString(shape.error().message)});
        return;
    }
    const auto ball = std::count_if(shape->vertices.begin(), shape->vertices.end(),
                                    [&](const core::Vec3& v) { return v.z() > 0.0; });
    constexpr auto kMost = static_cast<std::ptrdiff_t>(simulation::SpringNetwork::kMostFree);
    if (p.surface == simulation::ApexSurface::organ && ball > kMost)
        problems.push_back(
            {memberPath(path, "mesh_edge_mm"), mm(p.meshEdge_m),
             QStringLiteral("so long that the ball has at most %1 vertices, not %2").arg(kMost).arg(ball)});
    // Builds the real dome: surface, springs and clock.
    else if (const auto dome = simulation::TouchedDome::make(p, {}); !dome)
        problems.push_back({memberPath(path, "surface"), QStringLiteral("a dome that cannot be made"),
                            QString::fromStdString(dome.error().message)});
}

} // namespace

QByteArray sphereApexSchema() {
    return parametersSchema({"Parameters of sphere_apex",
                             "A hemisphere on a plane, its apex to be found and marked (models.md §2.3)."},
                            rows());
}

ExerciseParameters readSphereApex(const ObjectReader& parameters, const std::vector<std::string>& cues) {
    Parameters p;
    readParameters(rows(), parameters, QStringLiteral("a parameter of sphere_apex"), p);
    p.cues = cues;
    return ExerciseParameters(std::move(p));
}

void checkSphereApex(const ExerciseParameters& parameters, const QString& path, Problems& problems) {
    const auto& p = parameters.as<Parameters>();
    checkOrder(p.stiffnessLow_N_per_m, p.stiffnessHigh_N_per_m, path, "stiffness_low_N_per_m", problems);
    checkOrder(p.frictionLow, p.frictionHigh, path, "friction_low", problems);
    checkYield(p.yield, p.maximumForce_N, path, problems);
    // models.md §2.3: the whole sphere lies inside the workspace. One micrometre is allowed for decimals that
    // have no exact double.
    if (p.centreDiscRadius_m + p.radius_m > p.workspaceRadius_m + 1e-6)
        problems.push_back({memberPath(path, "centre_disc_radius_mm"), mm(p.centreDiscRadius_m),
                            QStringLiteral("at most workspace_radius_mm - radius_mm = ") +
                                mm(p.workspaceRadius_m - p.radius_m)});
    if (p.surface != simulation::ApexSurface::exact) {
        checkMesh(p, path, problems);
        // A question to the organ model waits for the previous answer, so a longer latency would slow down
        // the organ's own time.
        if (p.surface == simulation::ApexSurface::organ && p.slowLatency_ms > p.slowPeriod_ms)
            problems.push_back(
                {memberPath(path, "slow_latency_ms"), QString::number(p.slowLatency_ms),
                 QStringLiteral(
                     "at most slow_period_ms = %1, so that a step of the organ lasts as long as it says")
                     .arg(p.slowPeriod_ms)});
        return;
    }
    if (p.dimpleDepth_m <= 0.0)
        return;
    if (p.dimpleOffset_m < p.dimpleRadius_m)
        problems.push_back({memberPath(path, "dimple_offset_mm"), mm(p.dimpleOffset_m),
                            QStringLiteral("at least dimple_radius_mm = %1, so that the apex stays whole")
                                .arg(mm(p.dimpleRadius_m))});
    if (p.dimpleOffset_m + p.dimpleRadius_m > p.radius_m)
        problems.push_back(
            {memberPath(path, "dimple_radius_mm"), mm(p.dimpleRadius_m),
             QStringLiteral("at most radius_mm - dimple_offset_mm = %1, so that it lies on the ball")
                 .arg(mm(p.radius_m - p.dimpleOffset_m))});
}

} // namespace chiron::catalogue
