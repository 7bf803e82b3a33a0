// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"
#include "psychophysics/study/study_design.h"
#include "modules/exercises/comparison/simulation/comparison_parameters.h"
#include "simulation/attributes/object_attributes.h"

#include <map>
#include <string>

namespace chiron::catalogue {

/// simulation::ComparisonParameters from what a session of a study stored: SI throughout, made by comparisonLevel() and by nobody
/// else (a study has no file in content/exercises, so no list of exercises shows it).
ExerciseParameters readComparison(const ObjectReader& parameters, const std::vector<std::string>& cues);
/// What no single key's range can say: values for every candidate, arrangements that name only places there are.
void checkComparison(const ExerciseParameters& parameters, const QString& path, Problems& problems);

/// The objects of a condition before any device limits them: value [candidate][m] = reference · 10^(m D), the task's arrangements,
/// the fixed attributes, the trial rules. Failure: badInput (an attribute that is not rendered here, a fixed key that is unknown).
core::Result<simulation::ComparisonParameters> comparisonOf(const psychophysics::Condition& condition,
                                                            const psychophysics::TrialRules& trial);
/// The names that StimulusDesign::fixed may use, SI: stiffness_N_per_m, stiffening_per_m, mass_kg, recovery_s, recovery_share,
/// roughness_m, roughness_wavelength_m, friction, bristle_stiffness_N_per_m, viscosity_Ns_per_m, damping_Ns_per_m.
std::vector<std::string> fixedAttributeNames();
/// Failure: badInput naming the unknown key.
core::Result<simulation::ObjectAttributes> attributesOf(const std::map<std::string, double>& fixed);

/// The level that a session of a study is recorded under: exercise "comparison", number 1, no metrics and no gates.
ExerciseLevel comparisonLevel(const simulation::ComparisonParameters& parameters, const std::string& study,
                              const std::string& condition);

} // namespace chiron::catalogue
