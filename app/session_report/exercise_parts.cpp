// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/exercise_parts.h"

#include "session_report/grasp_report_of.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"
#include "curriculum/exercises/sphere_apex/scoring/apex_answer.h"
#include "app/exercises/palpation/session_report/palpation_report.h"

namespace chiron::session_report {

namespace {

/// Where each trial's answer lay, % of the radius: what the scores count; without a mark, where the tool stood at the end.
std::vector<report::ApexError> apexErrorsOf(const scoring::SessionTrace& trace) {
    std::vector<report::ApexError> errors;
    for (const scoring::TrialTrace& trial : trace.trials) {
        if (trial.unfinished || !trial.apex || trial.tools.empty() || trial.tools[0].p_WT_m.empty())
            continue;
        scoring::PreparedTrial prepared; // of which the answer reads position and truth alone
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

struct PartsOf {
    const scoring::SessionTrace& trace;
    const catalogue::ExerciseLevel& level;
    report::ExerciseParts& parts;

    void operator()(const simulation::SphereApexParameters&) const { parts.apexErrors = apexErrorsOf(trace); }
    void operator()(const simulation::UrethraInsertionParameters&) const { parts.insertion = insertionProfileOf(trace); }
    void operator()(const simulation::ElasticTubeParameters&) const { parts.tube = tubeReportOf(trace, level); }
    void operator()(const simulation::ObjectHandlingParameters&) const { parts.handling = handlingReportOf(trace, level); }
    void operator()(const simulation::PalpationParameters&) const { parts.palpation = palpationReportOf(trace, level); }
    void operator()(const simulation::ComparisonParameters&) const {} // of studies, which have reports of their own
};

} // namespace

report::ExerciseParts exercisePartsOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level) {
    report::ExerciseParts parts;
    std::visit(PartsOf{trace, level, parts}, level.parameters);
    return parts;
}

} // namespace chiron::session_report
