// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "core/units.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_scene.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

constexpr double kCheckedWall_m = 0.002;

bool has(const std::vector<std::string>& cues, const char* cue) {
    return std::find(cues.begin(), cues.end(), cue) != cues.end();
}

} // namespace

UrethraInsertionScene::UrethraInsertionScene(const UrethraInsertionParameters& parameters)
    : m_forces(parameters.anatomy, parameters.endoscope, parameters.forces), m_pose(parameters.pose),
      m_gate(parameters.meatus_m, parameters.endoscope.beak_m), m_yield(parameters.yield),
      m_bladderCentre_A(bladderCentre_A(parameters.anatomy, m_forces.centreline())),
      m_bladderReach_m(parameters.anatomy.bladderRadius_m + kCheckedWall_m), m_drawn(parameters),
      m_sight(parameters), m_tracker(procedurePlan(parameters)),
      m_limitTicks(static_cast<std::uint64_t>(
          std::max<long long>(1, std::llround(std::max(0.0, parameters.trialLimit_s) / core::kTickSeconds)))),
      m_cosHalfView(std::cos(0.5 * parameters.endoscope.fieldOfView_rad)),
      m_showsPicture(has(parameters.cues, "object")),
      m_showsGuidance(m_showsPicture && has(parameters.cues, "guidance")) {}

UrethraInsertionScene::~UrethraInsertionScene() = default;

} // namespace chiron::simulation
