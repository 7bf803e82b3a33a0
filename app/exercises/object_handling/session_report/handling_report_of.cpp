// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/session_report/handling_report_of.h"

#include "curriculum/exercises/object_handling/scoring/handling_samples.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "session_report/trial_values.h"

#include <string>

namespace chiron::session_report {

namespace {

/// Adds the position of the trial's object at the end of the trial.
void addPlace(const scoring::TrialTrace& trial, const scoring::HandlingTruth& truth,
              report::HandlingTrialRow& row) {
    scoring::PreparedTrial prepared; // the answer reads only quantities and truth from it
    prepared.trial = &trial;
    prepared.tool = &trial.tools.front();
    const auto answer = scoring::answerOf(prepared);
    if (!answer || !truth.targetX_m || !truth.targetY_m)
        return;
    const std::string body = "body_" + std::to_string(answer->number);
    const std::vector<double>* bodyX = quantityIn(trial, (body + "_x_m").c_str());
    const std::vector<double>* bodyY = quantityIn(trial, (body + "_y_m").c_str());
    if (bodyX == nullptr || bodyY == nullptr || bodyX->empty())
        return;
    row.taken = answer->taken;
    row.x_mm = 1e3 * (bodyX->back() - *truth.targetX_m);
    row.y_mm = 1e3 * (bodyY->back() - *truth.targetY_m);
    row.fromTarget_mm = 1e3 * answer->fromTarget_m;
    if (truth.task == static_cast<int>(simulation::HandlingTask::weigh) && truth.heaviest && trial.completed)
        row.heaviest = answer->number == *truth.heaviest;
}

} // namespace

report::HandlingReport handlingReportOf(const scoring::SessionTrace& trace,
                                        const catalogue::ExerciseLevel& level) {
    report::HandlingReport handling;
    const TrialScores scores(trace, level, {"squeeze_max", "squeeze_time_over_limit"});
    for (std::size_t i = 0; i < trace.trials.size(); ++i) {
        const scoring::TrialTrace& trial = trace.trials[i];
        if (trial.tools.empty() || trial.tools.front().t_s.empty())
            continue;
        report::HandlingTrialRow row;
        row.trial = trial.trial;
        row.outcome = outcomeOf(trial);
        row.squeezeMax_N = scores.of(i, "squeeze_max");
        row.overLimit_s = scores.of(i, "squeeze_time_over_limit");
        const scoring::HandlingTruth truth = scoring::handlingTruthIn(trial);
        addPlace(trial, truth, row);
        handling.squeezeLimit_N = truth.squeezeLimit_N.value_or(0.0);
        handling.targetRadius_mm = 1e3 * truth.targetRadius_m.value_or(0.0);
        handling.rows.push_back(row);
    }
    return handling;
}

} // namespace chiron::session_report
