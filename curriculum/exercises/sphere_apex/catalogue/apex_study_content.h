// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "psychophysics/study/study_design.h"

#include <string>

namespace chiron::catalogue {

/// The level number of "sphere_apex" that studies use. The exercise itself has no such level, so that no list
/// of a level's sessions contains a study's sessions.
inline constexpr int kApexStudyLevel = 1000;
/// Largest number of trials per session, as in the exercise.
inline constexpr int kApexTrialsAtMost = 32;

/// Returns the hidden sphere of a condition: the condition's reference is the radius, and its fixed
/// attributes are the material (stiffness_N_per_m, damping_Ns_per_m, friction, bristle_stiffness_N_per_m).
/// The position is drawn anew in each trial.
/// Errors: badInput for another attribute, a radius that leaves no room for other positions, or a fixed key
/// that a sphere does not have.
core::Result<simulation::SphereApexParameters> apexOf(const psychophysics::Condition& condition,
                                                      const psychophysics::TrialRules& trial, int trials);

/// Returns the level under which a session of such a condition is recorded: with the exercise's metrics,
/// without gates or help.
ExerciseLevel apexLevel(const simulation::SphereApexParameters& parameters, const std::string& study,
                        const std::string& condition);

} // namespace chiron::catalogue
