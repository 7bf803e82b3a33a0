// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "psychophysics/planning/study_plan.h"

#include <functional>
#include <string>
#include <vector>

namespace chiron::desktop {

/// What runs that end after so many trials may be expected to say: half of them say less than `weber`, a tenth less than `low` and a tenth more than `high` (Weber fractions).
struct PreviewPoint {
    double trials = 0.0;
    double weber = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// What simulated observers make of a condition.
struct PreviewResult {
    std::string condition;
    psychophysics::ConditionPlan plan;
    std::vector<PreviewPoint> curve;
};

/// Plans one condition with `runs` simulated runs, then again with shorter and longer ones for the curve. `progress` hears how far it is (0..1)
/// and says whether to go on. Blocking: a worker's task. Failure: cancelled.
core::Result<PreviewResult> previewCondition(const psychophysics::StudyDesign& design, std::size_t condition, const psychophysics::ObserverSpec& observer,
                                             int runs, const std::function<bool(double)>& progress);

} // namespace chiron::desktop
