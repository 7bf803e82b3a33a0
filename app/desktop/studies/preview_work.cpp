// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/preview_work.h"

#include <array>
#include <cmath>

namespace chiron::desktop {

using namespace psychophysics;

namespace {

constexpr std::array kShares{0.25, 0.5, 0.75, 1.0, 1.5}; // shares of the design's own number of trials

} // namespace

core::Result<PreviewResult> previewCondition(const StudyDesign& design, std::size_t index,
                                             const ObserverSpec& observer, int runs,
                                             const std::function<bool(double)>& progress) {
    const Condition& condition = design.conditions[index];
    constexpr double kParts = 3.0 + kShares.size();
    if (!progress(0.0))
        return core::fail(core::ErrorCode::cancelled, "preview");
    PreviewResult result;
    result.condition = condition.id;
    if (condition.stimulus.attribute == Attribute::apex)
        return result; // nothing is compared, so the expectation follows from its numbers alone
    result.plan = planCondition(condition, design.trial, observer, runs, design.seed);
    if (!progress(2.0 / kParts))
        return core::fail(core::ErrorCode::cancelled, "preview");
    examineLength(result.plan, condition, observer, design.seed);
    const double trials = result.plan.meanTrials;
    for (std::size_t i = 0; i < kShares.size() && trials >= 4.0; ++i) {
        if (!progress((3.0 + static_cast<double>(i)) / kParts))
            return core::fail(core::ErrorCode::cancelled, "preview");
        const auto of = withTrials(condition, static_cast<int>(std::lround(trials * kShares[i])));
        if (!of)
            break;
        const ConditionPlan plan = planCondition(*of, design.trial, observer, runs, design.seed);
        if (!std::isfinite(plan.biasLog10) || !std::isfinite(plan.sdLog10))
            continue;
        result.curve.push_back({plan.meanTrials, plan.weber50, plan.weber10, plan.weber90, plan.weber50Error,
                                plan.weber10Error, plan.weber90Error});
    }
    return result;
}

} // namespace chiron::desktop
