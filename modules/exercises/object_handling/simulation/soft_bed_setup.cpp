// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the organ. This allocates, so it is kept apart from the code of the tick.
#include "modules/exercises/object_handling/simulation/soft_bed.h"

#include "simulation/geometry/mesh/make_mesh.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

// Properties of the organ beneath its surface (assumptions): it gives way by as much again as the surface
// does, in a dent of a finger's width, and recovers within 60 ms.
constexpr double kSpread_m = 0.008;
constexpr double kMass_kg = 0.050;
constexpr double kRecovery_s = 0.060;
constexpr double kVolumeKeeping = 0.7;
constexpr double kDeepest_m = 0.008;

DeformableOrgan::Settings settingsOf(const ObjectHandlingParameters& p) {
    DeformableOrgan::Settings settings;
    settings.network.stiffness_N_per_m = p.bed.stiffness_N_per_m;
    settings.network.spread_m = kSpread_m;
    settings.network.mass_kg = kMass_kg;
    settings.network.recoveryTime_s = kRecovery_s;
    settings.network.volumeKeeping = kVolumeKeeping;
    settings.network.deepest_m = kDeepest_m;
    settings.timing.period_ticks = SoftBed::period_ticks(p);
    settings.timing.latency_ticks = static_cast<std::uint64_t>(std::max(1, p.bedLatency_ticks));
    settings.network.step_s = 1e-3 * static_cast<double>(settings.timing.period_ticks);
    settings.blend_ticks = settings.timing.latency_ticks;
    return settings;
}

} // namespace

std::uint64_t SoftBed::period_ticks(const ObjectHandlingParameters& parameters) noexcept {
    return static_cast<std::uint64_t>(std::max(1LL, std::llround(1000.0 / parameters.bedRate_Hz)));
}

core::Result<std::unique_ptr<SoftBed>> SoftBed::make(const ObjectHandlingParameters& parameters) {
    auto mesh = makeMesh(parameters.bedMesh);
    CHIRON_TRY(mesh);
    std::vector<bool> anchored;
    std::uint32_t highest = 0;
    const double middle = 0.5 * (mesh->lowest().z() + mesh->highest().z());
    for (std::uint32_t i = 0; i < mesh->vertices().size(); ++i) {
        anchored.push_back(mesh->position(i).z() < middle);
        if (mesh->position(i).z() > mesh->position(highest).z())
            highest = i;
    }
    std::unique_ptr<SoftBed> bed(new SoftBed);
    bed->m_lift_m = mesh->position(highest).z();
    bed->m_floor_m = mesh->lowest().z() - bed->m_lift_m;
    bed->m_reach_m =
        std::min({mesh->highest().x(), mesh->highest().y(), -mesh->lowest().x(), -mesh->lowest().y()});
    auto organ = DeformableOrgan::create(*mesh, anchored, highest, settingsOf(parameters));
    CHIRON_TRY(organ);
    bed->m_organ = std::move(*organ);
    return bed;
}

} // namespace chiron::simulation
