// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "psychophysics/planning/study_plan.h"

#include <functional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// The expected results of runs with this number of trials, as Weber fractions: half of the runs estimate
/// less than `weber`, a tenth less than `low` and a tenth more than `high`. Each has its Monte Carlo standard
/// error.
struct PreviewPoint {
    double trials = 0.0;
    double weber = 0.0;
    double low = 0.0;
    double high = 0.0;
    double weberError = 0.0;
    double lowError = 0.0;
    double highError = 0.0;
};

/// The results of simulated observers for one condition.
struct PreviewResult {
    std::string condition;
    psychophysics::ConditionPlan plan;
    std::vector<PreviewPoint> curve;
};

/// Plans one condition with `runs` simulated runs, then again with shorter and longer runs for the curve.
/// `progress` receives the progress (0..1) and returns whether to continue.
/// Thread: worker; blocks.
/// Errors: cancelled.
core::Result<PreviewResult> previewCondition(const psychophysics::StudyDesign& design, std::size_t condition,
                                             const psychophysics::ObserverSpec& observer, int runs,
                                             const std::function<bool(double)>& progress);

} // namespace chiron::desktop
