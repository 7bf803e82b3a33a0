// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"
#include "simulation/scene_parameters.h"

#include <utility>

namespace chiron::simulation {

SphereApexScene::SphereApexScene(const SphereApexParameters& parameters, std::uint64_t seed)
    : m_parameters(parameters), m_trials(planSphereApexTrials(parameters, seed)),
      m_course(m_trials.size(), ticksOf(parameters.trialLimit_s), ticksOf(parameters.betweenTrials_s)),
      m_showsObject(hasCue(parameters.cues, "object")) {
    if (parameters.surface == ApexSurface::exact)
        return;
    // Content was checked by making its dome (sphere_apex_content.cpp). For unchecked parameters that make no
    // dome, nothing is rendered and the trials run out.
    if (auto dome = TouchedDome::make(parameters, m_trials))
        m_dome = std::move(*dome);
}

SphereApexScene::~SphereApexScene() = default;

} // namespace chiron::simulation
