// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/apex_analysis.h"

#include <algorithm>
#include <map>

namespace chiron::session {

namespace {

using psychophysics::WarningKind;

bool counts(const database::StudyTrial& trial) {
    return !trial.practice && !trial.undone && trial.spoiled.empty() && trial.outcome >= 0;
}

void warnOfMarks(psychophysics::ApexSummary& summary, const std::vector<const AnalysedRun*>& runs) {
    int planned = 0, untouched = 0;
    for (const AnalysedRun* run : runs)
        for (const database::StudyTrial& trial : run->trials)
            if (const auto mark = counts(trial) ? apexMarkOf(trial.fidelityJson) : std::nullopt) {
                planned += mark->planned ? 1 : 0;
                untouched += !mark->planned && !mark->inContact ? 1 : 0;
            }
    if (planned > 0)
        summary.warnings.push_back({WarningKind::plannedMarks, planned});
    if (untouched > 0)
        summary.warnings.push_back({WarningKind::untouchedMarks, untouched});
}

/// The rows of the runs that the group contains: the members of GroupEstimate, without their estimates.
std::vector<std::size_t> membersOf(const AnalysedCondition& condition) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < condition.runs.size(); ++i)
        if (condition.runs[i].pooled)
            rows.push_back(i);
    return rows;
}

} // namespace

std::vector<psychophysics::ApexTrial> apexTrials(const std::vector<database::StudyTrial>& trials,
                                                 int participant) {
    std::vector<psychophysics::ApexTrial> out;
    for (const database::StudyTrial& trial : trials)
        if (const auto mark = counts(trial) ? apexMarkOf(trial.fidelityJson) : std::nullopt)
            out.push_back({participant, mark->errorX_m, mark->errorY_m});
    return out;
}

psychophysics::ApexSummary apexOfRun(const AnalysedRun& run, double radius_m, std::uint64_t seed) {
    auto summary = psychophysics::summariseApex(apexTrials(run.trials, 0), radius_m, seed);
    std::erase_if(summary.warnings, [](const psychophysics::Warning& warning) {
        return warning.kind == WarningKind::fewMarkers;
    });
    warnOfMarks(summary, {&run});
    return summary;
}

void poolApex(AnalysedCondition& condition, double radius_m, std::uint64_t seed) {
    std::map<database::ParticipantNumber, int> numbers;
    std::vector<psychophysics::ApexTrial> trials;
    std::vector<const AnalysedRun*> runs;
    for (const std::size_t row : membersOf(condition)) {
        const AnalysedRun& run = condition.runs[row];
        const int number = numbers.try_emplace(run.participant.id, static_cast<int>(row)).first->second;
        const auto own = apexTrials(run.trials, number);
        trials.insert(trials.end(), own.begin(), own.end());
        runs.push_back(&run);
    }
    condition.apex = psychophysics::summariseApex(trials, radius_m, seed);
    warnOfMarks(*condition.apex, runs);
    // It has no value of its own here, because nothing was compared.
    psychophysics::GroupEstimate& group = condition.group;
    std::vector<psychophysics::Warning> who;
    for (const psychophysics::Warning& warning : group.warnings)
        for (const WarningKind kind :
             {WarningKind::withdrawn, WarningKind::simulatedLeftOut, WarningKind::simulatedOnly,
              WarningKind::shownLeftOut, WarningKind::shownInGroup})
            if (warning.kind == kind)
                who.push_back(warning);
    group.warnings = who;
    group.participants = condition.apex->participants;
    condition.apex->warnings.insert(condition.apex->warnings.end(), who.begin(), who.end());
}

} // namespace chiron::session
