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

struct Key {
    const char* name;
    double Parameters::*member;
    double perUnit; ///< content units per SI unit
};

constexpr double kMm = 1000.0;

constexpr Key kKeys[] = {
    {"radius_mm", &Parameters::radius_m, kMm},
    {"plane_height_mm", &Parameters::planeHeight_m, kMm},
    {"centre_disc_radius_mm", &Parameters::centreDiscRadius_m, kMm},
    {"workspace_radius_mm", &Parameters::workspaceRadius_m, kMm},
    {"stiffness_low_N_per_m", &Parameters::stiffnessLow_N_per_m, 1.0},
    {"stiffness_high_N_per_m", &Parameters::stiffnessHigh_N_per_m, 1.0},
    {"stiffness_variation", &Parameters::stiffnessVariation, 1.0},
    {"stiffness_wavelength_mm", &Parameters::stiffnessWavelength_m, kMm},
    {"damping_N_s_per_m", &Parameters::damping_Ns_per_m, 1.0},
    {"friction_low", &Parameters::frictionLow, 1.0},
    {"friction_high", &Parameters::frictionHigh, 1.0},
    {"bristle_stiffness_N_per_m", &Parameters::bristleStiffness_N_per_m, 1.0},
    {"dimple_depth_mm", &Parameters::dimpleDepth_m, kMm},
    {"dimple_radius_mm", &Parameters::dimpleRadius_m, kMm},
    {"dimple_offset_mm", &Parameters::dimpleOffset_m, kMm},
    {"mesh_edge_mm", &Parameters::meshEdge_m, kMm},
    {"bump_height_mm", &Parameters::bumpHeight_m, kMm},
    {"bump_wavelength_mm", &Parameters::bumpWavelength_m, kMm},
    {"roughness_mm", &Parameters::roughness_m, kMm},
    {"roughness_wavelength_mm", &Parameters::roughnessWavelength_m, kMm},
    {"organ_stiffness_N_per_m", &Parameters::organStiffness_N_per_m, 1.0},
    {"organ_spread_mm", &Parameters::organSpread_m, kMm},
    {"organ_mass_g", &Parameters::organMass_kg, 1000.0},
    {"organ_recovery_time_s", &Parameters::organRecoveryTime_s, 1.0},
    {"organ_volume_keeping", &Parameters::organVolumeKeeping, 1.0},
    {"organ_deepest_mm", &Parameters::organDeepest_m, kMm},
    {"trial_limit_s", &Parameters::trialLimit_s, 1.0},
    {"between_trials_s", &Parameters::betweenTrials_s, 1.0},
    {"maximum_force_N", &Parameters::maximumForce_N, 1.0},
};

/// Whole numbers, `trials` among them.
constexpr struct {
    const char* name;
    int Parameters::*member;
} kWholeKeys[] = {{"trials", &Parameters::trials},
                  {"slow_period_ms", &Parameters::slowPeriod_ms},
                  {"slow_latency_ms", &Parameters::slowLatency_ms}};

constexpr struct {
    const char* name;
    simulation::ApexSurface surface;
} kSurfaces[] = {{"exact", simulation::ApexSurface::exact},
                 {"mesh", simulation::ApexSurface::mesh},
                 {"organ", simulation::ApexSurface::organ}};

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

ExerciseParameters readSphereApex(const ObjectReader& parameters, const std::vector<std::string>& cues) {
    Parameters p;
    std::vector<QString> known{QStringLiteral("surface"), QStringLiteral("bump_seed"),
                               QLatin1String(kYieldKeys[0]), QLatin1String(kYieldKeys[1])};
    readYield(parameters, p.yield);
    for (const Key& key : kKeys) {
        known.push_back(QLatin1String(key.name));
        if (parameters.has(known.back()))
            p.*key.member = parameters.number(known.back()) / key.perUnit;
    }
    for (const auto& key : kWholeKeys) {
        known.push_back(QLatin1String(key.name));
        if (parameters.has(known.back()))
            p.*key.member = parameters.integer(known.back());
    }
    if (parameters.has("bump_seed"))
        p.bumpSeed = static_cast<std::uint64_t>(parameters.integer("bump_seed"));
    if (parameters.has("surface"))
        for (const auto& [name, surface] : kSurfaces)
            if (parameters.text("surface") == name)
                p.surface = surface;
    for (const QString& key : parameters.json().keys())
        if (std::find(known.begin(), known.end(), key) == known.end())
            parameters.problems().push_back(
                {memberPath(parameters.path(), key), QStringLiteral("unknown key"),
                 QStringLiteral("a parameter of sphere_apex") + didYouMean(key, known)});
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
