// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/study_analysis.h"

#include <cstdint>
#include <vector>

namespace chiron::session {

/// The scored marks among stored trials, as errors of participant number `participant`.
std::vector<psychophysics::ApexTrial> apexTrials(const std::vector<database::StudyTrial>& trials, int participant);

/// What one run's marks say; `radius_m`: the condition's reference. Warnings about how many people there are are left out, and those of
/// marks that nobody felt (`planned`) or set without touching (`out_of_contact`) are added.
psychophysics::ApexSummary apexOfRun(const AnalysedRun& run, double radius_m, std::uint64_t seed);

/// Fills `apex` of a condition from the runs that its group is of, and gives the group what it shares with every study: how many people,
/// and the warnings of who was left out.
void poolApex(AnalysedCondition& condition, double radius_m, std::uint64_t seed);

} // namespace chiron::session
