// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "core/units.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

std::uint64_t ticks(double seconds) {
    return static_cast<std::uint64_t>(std::llround(std::max(0.0, seconds) / core::kTickSeconds));
}

} // namespace

SphereApexScene::SphereApexScene(const SphereApexParameters& parameters, std::uint64_t seed)
    : m_parameters(parameters), m_trials(planSphereApexTrials(parameters, seed)),
      m_limitTicks(std::max<std::uint64_t>(1, ticks(parameters.trialLimit_s))),
      m_betweenTicks(std::max<std::uint64_t>(1, ticks(parameters.betweenTrials_s))),
      m_showsObject(std::find(parameters.cues.begin(), parameters.cues.end(), "object") !=
                    parameters.cues.end()) {
    if (parameters.surface == ApexSurface::exact)
        return;
    // Content was checked by making its dome (sphere_apex_content.cpp). For unchecked parameters that make no
    // dome, nothing is rendered and the trials run out.
    if (auto dome = TouchedDome::make(parameters, m_trials))
        m_dome = std::move(*dome);
}

SphereApexScene::~SphereApexScene() = default;

} // namespace chiron::simulation
