// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/sphere_apex/scoring/apex_answer.h"

#include "curriculum/exercises/sphere_apex/scoring/apex_reasons.h"

#include <cmath>

namespace chiron::scoring {

std::optional<ApexAnswer> apexAnswer(const PreparedTrial& trial) {
    if (!trial.trial->target || !(trial.trial->target->radius_m > 0.0))
        return std::nullopt;
    if (!trial.trial->marked && trial.tool == nullptr)
        return std::nullopt;
    const TargetTruth& truth = *trial.trial->target;
    const core::Vec3 p = trial.trial->marked ? trial.trial->p_WMark_m : trial.tool->p_WT_m.back();
    const double dx = p.x() - truth.x_m;
    const double dy = p.y() - truth.y_m;
    ApexAnswer answer;
    answer.errorX_percent = 100.0 * dx / truth.radius_m;
    answer.errorY_percent = 100.0 * dy / truth.radius_m;
    answer.miss = (trial.trial->timedOut && !trial.trial->marked) || !trial.trial->markInContact ||
                  std::hypot(dx, dy) > truth.radius_m;
    return answer;
}

ApexAnswers apexAnswers(std::span<const PreparedTrial> trials) {
    ApexAnswers all;
    for (const PreparedTrial& trial : trials) {
        const std::optional<ApexAnswer> answer = apexAnswer(trial);
        if (!answer) {
            all.undefined =
                Measurement::undefined(trial.trial->target ? reasons::kNoPosition : reasons::kApexUnknown);
            return all;
        }
        all.answers.push_back(*answer);
    }
    if (all.answers.empty())
        all.undefined = Measurement::undefined(reasons::kNoTrials);
    return all;
}

} // namespace chiron::scoring
