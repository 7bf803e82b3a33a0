// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the world and its task. It is kept apart from the code of the tick, because copying the
// parameters allocates.
#include "modules/exercises/object_handling/simulation/handling_progress.h"
#include "modules/exercises/object_handling/simulation/handling_world.h"
#include "simulation/scene_parameters.h"

namespace chiron::simulation {

namespace {

/// A body's ball (11 mm) spans many peaks of a rough bed and has lain on it for long, so it rests on their
/// mean.
ObjectContact underBody(ObjectAttributes bed) noexcept {
    bed.roughness_m = 0.0;
    bed.recoveryShare = 0.0;
    return ObjectContact(bed);
}

} // namespace

HandlingWorld::HandlingWorld(const ObjectHandlingParameters& parameters, SoftBed* soft) noexcept
    : m_parameters(parameters), m_object(parameters.object), m_bed(parameters.bed),
      m_bodyBed(underBody(parameters.bed)), m_soft(soft) {}

HandlingProgress::HandlingProgress(const ObjectHandlingParameters& parameters) noexcept
    : m_parameters(parameters), m_holdTicks(ticksOf(parameters.hold_s)) {}

} // namespace chiron::simulation
