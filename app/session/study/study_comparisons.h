// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/group_estimate.h"
#include "psychophysics/study/study_design.h"

#include <cstddef>
#include <string>
#include <vector>

namespace chiron::session {

struct StudyAnalysis;

/// The comparison of two conditions of a study.
struct ComparedConditions {
    std::size_t first = 0, second = 0; ///< indices into StudyAnalysis::conditions
    psychophysics::ConditionComparison weber;
    /// Empty if the same people did not do both conditions, if the tasks differ, or if the answers decided
    /// what came next: an adaptive run hardly determines the slope, and with a free slope the likelihood
    /// ratio is far from chi-square.
    psychophysics::ThresholdModels models;
    /// The codes of the people whose values are compared; paired: the same people in both.
    std::vector<std::string> firstPeople{}, secondPeople{};
};

/// True if the answers decide which difference comes next.
bool adapts(const psychophysics::Condition& condition);

/// True if any of the comparisons could test separate thresholds; with adaptive procedures, none can.
bool testsThresholds(const std::vector<ComparedConditions>& compared);

/// Compares every two conditions whose groups have a Weber fraction, for the people whose values the groups
/// use (Presence::used): paired by participant if at least two have a value in both conditions, else as two
/// groups of those who have a value in only one of them. A participant with several runs of a condition
/// counts once, with the geometric mean of their values. Empty while the study is blinded: a difference that
/// is monitored while it grows is not a valid test.
std::vector<ComparedConditions> compareAll(const StudyAnalysis& study, std::uint64_t seed);

} // namespace chiron::session
