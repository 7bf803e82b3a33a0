// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the dome. This allocates, so it is kept apart from the code of the tick.
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"

#include "simulation/geometry/mesh/make_mesh.h"

#include <cmath>

namespace chiron::simulation {

namespace {

/// How far the plate extends beyond the ball; its outermost part blends into the plane.
constexpr double kPlate_m = 0.016;
/// As thick as any press is deep, so that the plate's lower side is never the nearer one.
constexpr double kPlateThickness_m = 0.015;
constexpr double kBlend_m = 0.003;

ObjectAttributes attributesOf(const SphereApexParameters& p, const SphereApexTrial& trial) {
    ObjectAttributes a;
    a.stiffness_N_per_m = trial.stiffness_N_per_m;
    a.damping_Ns_per_m = p.damping_Ns_per_m;
    a.friction = trial.friction;
    a.bristleStiffness_N_per_m = p.bristleStiffness_N_per_m;
    a.roughness_m = p.roughness_m;
    a.roughnessWavelength_m = p.roughnessWavelength_m;
    a.roughnessSeed = trial.roughnessSeed;
    return a;
}

DeformableOrgan::Settings organSettings(const SphereApexParameters& p) {
    DeformableOrgan::Settings settings;
    settings.network.stiffness_N_per_m = p.organStiffness_N_per_m;
    settings.network.spread_m = p.organSpread_m;
    settings.network.mass_kg = p.organMass_kg;
    settings.network.recoveryTime_s = p.organRecoveryTime_s;
    settings.network.volumeKeeping = p.organVolumeKeeping;
    settings.network.deepest_m = p.organDeepest_m;
    settings.network.step_s = 1e-3 * p.slowPeriod_ms;
    settings.timing.period_ticks = static_cast<std::uint64_t>(std::max(1, p.slowPeriod_ms));
    settings.timing.latency_ticks = static_cast<std::uint64_t>(std::max(1, p.slowLatency_ms));
    settings.blend_ticks = settings.timing.latency_ticks;
    return settings;
}

core::Result<std::unique_ptr<DeformableOrgan>> makeOrgan(const TriangleMesh& mesh,
                                                         const SphereApexParameters& p) {
    // The ball is free and anchored to the plate under it; the stiffness refers to the apex.
    constexpr double kFoot_m = 1e-4;
    std::vector<bool> anchored;
    std::uint32_t highest = 0;
    for (std::uint32_t i = 0; i < mesh.vertices().size(); ++i) {
        const core::Vec3& at = mesh.position(i);
        anchored.push_back(at.z() < kFoot_m || std::hypot(at.x(), at.y()) >= p.radius_m - 1e-9);
        if (at.z() > mesh.position(highest).z())
            highest = i;
    }
    return DeformableOrgan::create(mesh, anchored, highest, organSettings(p));
}

} // namespace

MeshSource apexDomeSource(const SphereApexParameters& parameters) {
    MeshSource source;
    source.shape = MeshSource::Shape::dome;
    source.id = "apex_dome";
    source.halfAxisX_m = source.halfAxisY_m = source.halfAxisZ_m = parameters.radius_m;
    source.plateRadius_m = parameters.radius_m + kPlate_m;
    source.plateThickness_m = kPlateThickness_m;
    source.edge_m = parameters.meshEdge_m;
    source.bumpHeight_m = parameters.bumpHeight_m;
    source.bumpWavelength_m = parameters.bumpWavelength_m;
    source.seed = parameters.bumpSeed;
    return source;
}

core::Result<std::unique_ptr<TouchedDome>> TouchedDome::make(const SphereApexParameters& parameters,
                                                             const std::vector<SphereApexTrial>& trials) {
    const MeshSource source = apexDomeSource(parameters);
    auto mesh = makeMesh(source);
    CHIRON_TRY(mesh);
    std::unique_ptr<TouchedDome> dome(new TouchedDome);
    dome->m_mesh = std::move(*mesh);
    if (parameters.surface == ApexSurface::organ) {
        auto organ = makeOrgan(dome->m_mesh, parameters);
        CHIRON_TRY(organ);
        dome->m_organ = std::move(*organ);
    }
    // The rim's vertices lean outwards, so only the plane is left from two edges before the rim.
    dome->m_blendTo_m = source.plateRadius_m - 2.0 * source.edge_m;
    dome->m_blendFrom_m = dome->m_blendTo_m - kBlend_m;
    dome->m_planeHeight_m = parameters.planeHeight_m;
    dome->m_yield = parameters.yield;
    dome->m_radius_m = parameters.radius_m;
    dome->m_deepest_m = kDeepestShare * parameters.radius_m;
    for (const SphereApexTrial& trial : trials) {
        Place place;
        place.centre_m = trial.centre_m;
        place.cosine = std::cos(trial.turn_rad);
        place.sine = std::sin(trial.turn_rad);
        place.contact = ObjectContact(attributesOf(parameters, trial));
        dome->m_places.push_back(place);
    }
    return dome;
}

TouchedDome::~TouchedDome() = default;

} // namespace chiron::simulation
