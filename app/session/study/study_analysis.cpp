// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_analysis.h"

#include "catalogue/study_reader.h"
#include "core/random.h"
#include "session/study/apex_analysis.h"
#include "session/study/apex_sitting.h"
#include "session/study/rendered_run.h"

#include <algorithm>

namespace chiron::session {

namespace {

/// Trials of a rendered run have a session; a person's may lack one only where the study was brought in from elsewhere.
bool wasNotRendered(const database::Participant& participant, const std::vector<database::StudyTrial>& trials) {
    return participant.simulated && std::any_of(trials.begin(), trials.end(), [](const auto& trial) { return trial.session == 0; });
}

/// Whether three objects are ranked in a condition.
bool ranks(const psychophysics::Condition& condition) {
    return condition.task == psychophysics::Task::rank3 && condition.stimulus.attribute != psychophysics::Attribute::apex;
}

core::Result<AnalysedRun> analyseRun(database::StudyReader& reader, const StudyAnalysis& study, const psychophysics::Condition& condition,
                                     const database::Participant& participant, const database::StudyRun& run, std::uint64_t seed) {
    AnalysedRun out;
    out.participant = participant;
    out.run = run;
    auto trials = reader.studyTrials(run.id);
    if (!trials)
        return tl::unexpected(trials.error());
    out.trials = std::move(*trials);
    for (const database::StudyTrial& trial : out.trials) {
        if (trial.practice)
            ++out.practice;
        else if (!trial.spoiled.empty())
            ++out.spoiled;
        else
            ++out.scored;
    }
    const std::vector<psychophysics::ScoredTrial> scored = scoredTrials(condition, out.trials);
    out.estimate = psychophysics::estimateRun(condition, scored, core::Random::mix(seed, "run " + participant.code + " " + condition.id));
    warnNotRendered(out.estimate, participant, out.trials);
    if (ranks(condition))
        out.ranking = psychophysics::summariseRankings(psychophysics::saidRanks(scored));
    if (looksForApex(condition))
        out.apex = apexOfRun(out, condition.stimulus.reference, core::Random::mix(seed, "apex " + participant.code + " " + condition.id));
    auto replayed = rerunChoices(study.design, run, out.trials);
    if (!replayed)
        return tl::unexpected(replayed.error());
    out.replayed = *replayed;
    return out;
}

std::string people(int n) { return n == 1 ? "1 participant" : std::to_string(n) + " participants"; }

/// The group's estimate: of people who still take part; of simulated participants where there is nobody else.
void pool(AnalysedCondition& condition, const psychophysics::Condition& designed, std::uint64_t seed) {
    const auto takesPart = [](const AnalysedRun& run) { return run.participant.state != database::ParticipantState::withdrawn; };
    const bool real = std::any_of(condition.runs.begin(), condition.runs.end(),
                                  [&](const AnalysedRun& run) { return takesPart(run) && !run.participant.simulated; });
    std::vector<psychophysics::RunEstimate> estimates;
    std::vector<int> rows;
    std::vector<std::vector<psychophysics::SaidRanks>> rankings;
    int withdrawn = 0, simulated = 0, notRendered = 0;
    for (std::size_t i = 0; i < condition.runs.size(); ++i) {
        const AnalysedRun& run = condition.runs[i];
        withdrawn += takesPart(run) ? 0 : 1;
        simulated += takesPart(run) && run.participant.simulated ? 1 : 0;
        if (!takesPart(run) || run.participant.simulated == real)
            continue;
        estimates.push_back(run.estimate);
        rows.push_back(static_cast<int>(i));
        notRendered += wasNotRendered(run.participant, run.trials) ? 1 : 0;
        if (ranks(designed))
            rankings.push_back(psychophysics::saidRanks(scoredTrials(designed, run.trials)));
    }
    condition.ranking = psychophysics::summariseGroupRankings(rankings);
    condition.group = psychophysics::estimateGroup(estimates, seed);
    for (psychophysics::GroupMember& member : condition.group.members)
        member.index = rows[static_cast<std::size_t>(member.index)];
    auto& warnings = condition.group.warnings;
    if (withdrawn > 0)
        warnings.push_back("withdrawn: " + people(withdrawn) + " who withdrew left out");
    if (simulated > 0)
        warnings.push_back(real ? "simulated_left_out: " + people(simulated) + " simulated left out: the group is of people"
                                : "simulated: the group is of simulated participants alone");
    if (notRendered > 0)
        warnings.push_back("not_rendered: " + people(notRendered) + " of the group without rendering: told the values, nothing was felt");
}

} // namespace

void warnNotRendered(psychophysics::RunEstimate& estimate, const database::Participant& participant, const std::vector<database::StudyTrial>& trials) {
    if (wasNotRendered(participant, trials))
        estimate.warnings.emplace_back("not_rendered: a quick simulation without rendering: the observer was told the values");
}

core::Result<StudyAnalysis> analyseStudy(database::StudyReader& reader, database::StudyNumber number, std::uint64_t seed) {
    StudyAnalysis study;
    auto record = reader.study(number);
    if (!record)
        return tl::unexpected(record.error());
    study.record = std::move(*record);
    auto design = catalogue::readStudy(QByteArray::fromStdString(study.record.designJson), "study " + std::to_string(number));
    if (!design)
        return tl::unexpected(design.error());
    study.design = std::move(*design);
    for (const psychophysics::Condition& condition : study.design.conditions)
        study.conditions.push_back({condition.id, {}, {}, {}, {}});
    auto participants = reader.participants(number);
    if (!participants)
        return tl::unexpected(participants.error());
    for (const database::Participant& participant : *participants) {
        auto runs = reader.runs(participant.id);
        if (!runs)
            return tl::unexpected(runs.error());
        for (const database::StudyRun& run : *runs) {
            const auto at = std::find_if(study.design.conditions.begin(), study.design.conditions.end(),
                                         [&](const psychophysics::Condition& c) { return c.id == run.condition; });
            if (at == study.design.conditions.end() || run.state == database::StudyRunState::stopped)
                continue;
            auto analysed = analyseRun(reader, study, *at, participant, run, seed);
            if (!analysed)
                return tl::unexpected(analysed.error());
            if (!analysed->trials.empty())
                study.conditions[static_cast<std::size_t>(at - study.design.conditions.begin())].runs.push_back(std::move(*analysed));
        }
    }
    for (std::size_t i = 0; i < study.conditions.size(); ++i) {
        AnalysedCondition& condition = study.conditions[i];
        pool(condition, study.design.conditions[i], core::Random::mix(seed, "group " + condition.condition));
        if (looksForApex(study.design.conditions[i]))
            poolApex(condition, study.design.conditions[i].stimulus.reference, core::Random::mix(seed, "apex " + condition.condition));
    }
    return study;
}

} // namespace chiron::session
