// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"
#include "psychophysics/study/study_design.h"
#include "simulation/attributes/object_attributes.h"
#include "simulation/comparison/comparison_parameters.h"

#include <map>
#include <string>

namespace chiron::catalogue {

/// Reads simulation::ComparisonParameters from what a session of a study stored. Only comparisonLevel()
/// writes them: a study has no file in content/exercises, so that no list of exercises shows it.
/// Unit: SI throughout.
ExerciseParameters readComparison(const ObjectReader& parameters, const std::vector<std::string>& cues);
/// Checks what the range of a single key cannot express: values for every candidate, and arrangements that
/// name only existing positions.
void checkComparison(const ExerciseParameters& parameters, const QString& path, Problems& problems);

/// Returns the objects of a condition before any device limits them: value [candidate][m] = reference · 10^(m
/// D), the task's arrangements, the fixed attributes and the trial rules.
/// Errors: badInput for an attribute that is not rendered here or an unknown fixed key.
core::Result<simulation::ComparisonParameters> comparisonOf(const psychophysics::Condition& condition,
                                                            const psychophysics::TrialRules& trial);
/// Returns the names that StimulusDesign::fixed may use: stiffness_N_per_m, stiffening_per_m, mass_kg,
/// recovery_s, recovery_share, roughness_m, roughness_wavelength_m, friction, bristle_stiffness_N_per_m,
/// viscosity_Ns_per_m, damping_Ns_per_m.
/// Unit: SI.
std::vector<std::string> fixedAttributeNames();
/// Errors: badInput naming the unknown key.
core::Result<simulation::ObjectAttributes> attributesOf(const std::map<std::string, double>& fixed);

/// Returns the level under which a session of a study is recorded: exercise "comparison", number 1, without
/// metrics or gates.
ExerciseLevel comparisonLevel(const simulation::ComparisonParameters& parameters, const std::string& study,
                              const std::string& condition);

} // namespace chiron::catalogue
