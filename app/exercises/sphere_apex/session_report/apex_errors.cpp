// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/session_report/apex_errors.h"

#include "curriculum/exercises/sphere_apex/scoring/apex_answer.h"

namespace chiron::session_report {

std::vector<report::ApexError> apexErrorsOf(const scoring::SessionTrace& trace) {
    std::vector<report::ApexError> errors;
    for (const scoring::TrialTrace& trial : trace.trials) {
        if (trial.unfinished || !trial.target || trial.tools.empty() || trial.tools[0].p_WT_m.empty())
            continue;
        scoring::PreparedTrial prepared; // the answer reads only position and truth from it
        prepared.trial = &trial;
        prepared.tool = &trial.tools.front();
        const auto answer = scoring::apexAnswer(prepared);
        if (!answer)
            continue;
        report::ApexError error;
        error.trial = trial.trial;
        error.timedOut = !trial.marked;
        error.x_percent = answer->errorX_percent;
        error.y_percent = answer->errorY_percent;
        error.miss = trial.marked && answer->miss;
        errors.push_back(error);
    }
    return errors;
}

} // namespace chiron::session_report
