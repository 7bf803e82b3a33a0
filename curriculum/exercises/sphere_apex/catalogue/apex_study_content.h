// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "psychophysics/study/study_design.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

#include <string>

namespace chiron::catalogue {

/// The number of a study's level of "sphere_apex": none of the exercise's own, so that no list of a level's sessions holds one.
inline constexpr int kApexStudyLevel = 1000;
/// What a session holds at most, as the exercise does.
inline constexpr int kApexTrialsAtMost = 32;

/// The hidden sphere of a condition: its reference is the radius, its fixed attributes are what it is made of; the place is drawn
/// anew in each trial. Failure: badInput (another attribute; a radius that leaves no room for other places; a fixed key that a
/// sphere does not have: it has stiffness_N_per_m, damping_Ns_per_m, friction, bristle_stiffness_N_per_m).
core::Result<simulation::SphereApexParameters> apexOf(const psychophysics::Condition& condition,
                                                      const psychophysics::TrialRules& trial, int trials);

/// The level that a sitting of such a condition is recorded under: the exercise's metrics, no gates, no help.
ExerciseLevel apexLevel(const simulation::SphereApexParameters& parameters, const std::string& study, const std::string& condition);

} // namespace chiron::catalogue
