// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the scene. It may allocate, so it is kept apart from the code of the tick.
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_scene.h"
#include "simulation/scene_parameters.h"

#include <cmath>

namespace chiron::simulation {

namespace {

constexpr double kCheckedWall_m = 0.002;

} // namespace

UrethraInsertionScene::UrethraInsertionScene(const UrethraInsertionParameters& parameters)
    : m_forces(parameters.anatomy, parameters.endoscope, parameters.forces), m_pose(parameters.pose),
      m_gate(parameters.meatus_m, parameters.endoscope.beak_m), m_yield(parameters.yield),
      m_bladderCentre_A(bladderCentre_A(parameters.anatomy, m_forces.centreline())),
      m_bladderReach_m(parameters.anatomy.bladderRadius_m + kCheckedWall_m), m_drawn(parameters),
      m_sight(parameters), m_tracker(procedurePlan(parameters)),
      m_course(1, ticksOf(parameters.trialLimit_s), 1),
      m_cosHalfView(std::cos(0.5 * parameters.endoscope.fieldOfView_rad)),
      m_showsPicture(hasCue(parameters.cues, "object")),
      m_showsGuidance(m_showsPicture && hasCue(parameters.cues, "guidance")) {}

UrethraInsertionScene::~UrethraInsertionScene() = default;

} // namespace chiron::simulation
