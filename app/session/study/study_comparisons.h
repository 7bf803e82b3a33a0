// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/group_estimate.h"
#include "psychophysics/study/study_design.h"

#include <cstddef>
#include <vector>

namespace chiron::session {

struct StudyAnalysis;

/// Two conditions of a study beside each other.
struct ComparedConditions {
    std::size_t first = 0, second = 0; ///< places in StudyAnalysis::conditions
    psychophysics::ConditionComparison weber;
    /// Of none where the same people did not do both, tasks differ, or answers decided what came next: an adaptive run hardly tells the slope, and with it
    /// free the likelihood ratio is far from chi-square.
    psychophysics::ThresholdModels models;
};

/// Whether answers decide which difference comes next.
bool adapts(const psychophysics::Condition& condition);

/// Whether any of them could test separate thresholds: of adaptive procedures none does.
bool testsThresholds(const std::vector<ComparedConditions>& compared);

/// Every two conditions whose groups give a Weber fraction, of those people whom the groups' values use (Presence::used): paired by participant where at
/// least two have a value in both, else as two groups of those who have one in only one of them. A participant with several runs of a condition counts once: the geometric mean of what they say. None while the
/// study is blinded: a difference that is watched as it grows is not a test any more.
std::vector<ComparedConditions> compareAll(const StudyAnalysis& study, std::uint64_t seed);

} // namespace chiron::session
