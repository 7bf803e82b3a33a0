// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/study_analysis.h"

#include <cstdint>
#include <vector>

namespace chiron::session {

/// The scored marks among stored trials, as errors of participant number `participant`.
std::vector<psychophysics::ApexTrial> apexTrials(const std::vector<database::StudyTrial>& trials,
                                                 int participant);

/// The summary of one run's marks; `radius_m` is the condition's reference. Omits warnings about the number
/// of people, and adds those about marks that nobody felt (`planned`) or that were set without contact
/// (`out_of_contact`).
psychophysics::ApexSummary apexOfRun(const AnalysedRun& run, double radius_m, std::uint64_t seed);

/// Computes `apex` of a condition from the runs that its group contains, and sets the values that a group has
/// in every study: the number of people, and the warnings about people who were left out.
void poolApex(AnalysedCondition& condition, double radius_m, std::uint64_t seed);

} // namespace chiron::session
