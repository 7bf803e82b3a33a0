// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/trial_log.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

core::Result<void> LoggedProcedure::record(int outcome, const Stimulus& presented) {
    if (outcome < 0 || outcome >= outcomes())
        return fail(ErrorCode::badInput,
                    "outcome " + std::to_string(outcome) + ": expected 0.." + std::to_string(outcomes() - 1));
    if (presented.size() != dimensions())
        return fail(ErrorCode::badInput, "stimulus of " + std::to_string(presented.size()) +
                                             " numbers: expected " + std::to_string(dimensions()));
    for (const double x : presented)
        if (!std::isfinite(x))
            return fail(ErrorCode::badInput, "stimulus that is not finite: expected finite numbers");
    RecordedTrial trial{outcome, presented};
    CHIRON_TRY(take(trial));
    m_log.push_back(std::move(trial));
    return {};
}

core::Result<void> LoggedProcedure::undo() {
    if (m_log.empty())
        return fail(ErrorCode::wrongUse, "there is no recorded outcome to take back");
    m_log.pop_back();
    restart();
    for (const RecordedTrial& trial : m_log)
        CHIRON_TRY(take(trial));
    return {};
}

bool stopped(const StopRule& rule, int trials, int reversals, std::optional<double> sd) noexcept {
    if (trials < rule.minimumTrials)
        return false;
    const bool enoughTrials = rule.trials > 0 && trials >= rule.trials;
    const bool enoughReversals = rule.reversals > 0 && reversals >= rule.reversals;
    if (rule.reversalsAndTrials)
        return (rule.trials <= 0 || enoughTrials) && (rule.reversals <= 0 || enoughReversals) &&
               (rule.trials > 0 || rule.reversals > 0);
    return enoughTrials || enoughReversals || (rule.sd > 0.0 && sd && trials > 0 && *sd <= rule.sd);
}

void warnOfGridEdges(ProcedureEstimate& estimate, std::size_t most) {
    for (std::size_t k = 0; k < std::min(most, estimate.parameters.size()); ++k) {
        const NamedEstimate& each = estimate.parameters[k];
        if (!each.cutBelow && !each.cutAbove)
            continue;
        const char* how = !each.cutAbove ? "small" : !each.cutBelow ? "large" : "small or how large";
        estimate.warnings.push_back("grid_edge: answers do not tell how " + std::string(how) + " " +
                                    each.name +
                                    " is: its estimate and interval end with the procedure's grid");
    }
}

} // namespace chiron::psychophysics
