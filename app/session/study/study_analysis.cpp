// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_analysis.h"

#include "catalogue/study_json.h"
#include "core/random.h"
#include "session/study/apex_analysis.h"
#include "session/study/mark_sessions.h"
#include "session/study/rendered_run.h"
#include "session/study/study_setup.h"
#include "session/study/study_store.h"

#include <algorithm>
#include <limits>

namespace chiron::session {

namespace {

using psychophysics::Warning;
using psychophysics::WarningKind;

/// Trials of a rendered run have a session. A person's trials can lack one only if the study was imported.
bool wasNotRendered(const database::Participant& participant,
                    const std::vector<database::StudyTrial>& trials) {
    return participant.simulated &&
           std::any_of(trials.begin(), trials.end(), [](const auto& trial) { return trial.session == 0; });
}

/// True if three objects are ranked in a condition.
bool ranks(const psychophysics::Condition& condition) {
    return psychophysics::ranksThree(condition.task) &&
           condition.stimulus.attribute != psychophysics::Attribute::apex;
}

/// Repeats the choices by the condition that the run is analysed by; empty if there is none, or the run's
/// procedures are sealed.
core::Result<ReplayedChoices> rerun(const StudyAnalysis& study, const psychophysics::Condition* condition,
                                    database::StudyRun run, const std::vector<database::StudyTrial>& trials) {
    if (!condition || run.procedures.empty())
        return ReplayedChoices{};
    run.condition = condition->id;
    return rerunChoices(study.design, run, trials);
}

core::Result<AnalysedRun> analyseRun(database::StudyReader& reader, const StudyAnalysis& study,
                                     const psychophysics::Condition* condition,
                                     const database::Participant& participant, const database::StudyRun& run,
                                     std::uint64_t seed) {
    AnalysedRun out;
    out.participant = participant;
    out.run = run;
    auto trials = reader.studyTrials(run.id);
    CHIRON_TRY(trials);
    out.trials = std::move(*trials);
    for (const database::StudyTrial& trial : out.trials) {
        if (trial.practice)
            ++out.practice;
        else if (!trial.spoiled.empty())
            out.spoiled += database::isRepeated(trial) ? 1 : 0;
        else
            ++out.scored;
    }
    const auto scored =
        condition ? scoredTrials(*condition, out.trials) : std::vector<psychophysics::ScoredTrial>{};
    out.estimate = estimateOf(condition, scored, study.blinding,
                              core::Random::mix(seed, "run " + participant.code + " " + labelOf(run)));
    if (!condition)
        out.estimate.trials = out.scored;
    warnNotRendered(out.estimate, participant, out.trials);
    warnShown(out.estimate, out.trials);
    for (const database::StudyTrial& trial : out.trials)
        if (trial.felt)
            out.felt = out.felt.value_or(true) && *trial.felt;
    if (condition && ranks(*condition))
        out.ranking = psychophysics::summariseRankings(psychophysics::saidRanks(scored), adapts(*condition));
    if (condition && looksForApex(*condition))
        out.apex = apexOfRun(out, condition->stimulus.reference,
                             core::Random::mix(seed, "apex " + participant.code + " " + labelOf(run)));
    if (out.apex)
        for (const Warning& warning : out.estimate.warnings)
            if (warning.kind == WarningKind::shownRun)
                out.apex->warnings.push_back(warning);
    auto replayed = rerun(study, condition, run, out.trials);
    CHIRON_TRY(replayed);
    out.replayed = *replayed;
    return out;
}

bool wasShown(const AnalysedRun& run) {
    return run.felt && !*run.felt;
}

/// In a study of the apex the marks count, since there is no Weber fraction.
Presence presenceIn(const AnalysedRun& run) {
    if (!run.apex)
        return presenceOf(run.estimate, run.run.state == database::StudyRunState::completed);
    return run.apex->trials > 0 ? Presence::used : Presence::noAnswers;
}

/// Computes the group's estimate: of people who have not withdrawn, or of simulated participants if there are
/// no people.
void pool(AnalysedCondition& condition, const psychophysics::Condition* designed, std::uint64_t seed,
          const AnalysisChoices& choices) {
    const auto takesPart = [](const AnalysedRun& run) {
        return run.participant.state != database::ParticipantState::withdrawn;
    };
    const bool real = std::any_of(condition.runs.begin(), condition.runs.end(), [&](const AnalysedRun& run) {
        return takesPart(run) && !run.participant.simulated;
    });
    std::vector<psychophysics::RunEstimate> estimates;
    std::vector<int> rows;
    std::vector<std::vector<psychophysics::SaidRanks>> rankings;
    int withdrawn = 0, simulated = 0, notRendered = 0, shown = 0;
    for (std::size_t i = 0; i < condition.runs.size(); ++i) {
        AnalysedRun& run = condition.runs[i];
        run.pooled = false;
        withdrawn += takesPart(run) ? 0 : 1;
        simulated += takesPart(run) && run.participant.simulated ? 1 : 0;
        run.presence = takesPart(run) ? Presence::simulated : Presence::withdrawn;
        if (!takesPart(run) || run.participant.simulated == real)
            continue;
        shown += wasShown(run) ? 1 : 0;
        run.presence = Presence::shown;
        if (wasShown(run) && !choices.withShown)
            continue;
        run.pooled = true;
        run.presence = presenceIn(run);
        if (designed)
            run.remedy = remedyFor(run.estimate, run.presence, designed->stimulus.differences);
        estimates.push_back(run.estimate);
        rows.push_back(static_cast<int>(i));
        notRendered += wasNotRendered(run.participant, run.trials) ? 1 : 0;
        if (designed && ranks(*designed))
            rankings.push_back(psychophysics::saidRanks(scoredTrials(*designed, run.trials)));
    }
    condition.ranking = psychophysics::summariseGroupRankings(rankings);
    condition.group = psychophysics::estimateGroup(estimates, seed);
    for (psychophysics::GroupMember& member : condition.group.members)
        member.index = rows[static_cast<std::size_t>(member.index)];
    auto& warnings = condition.group.warnings;
    if (withdrawn > 0)
        warnings.push_back({WarningKind::withdrawn, withdrawn});
    if (simulated > 0)
        warnings.push_back(real ? Warning{WarningKind::simulatedLeftOut, simulated}
                                : Warning{WarningKind::simulatedOnly});
    if (notRendered > 0)
        warnings.push_back({WarningKind::notRenderedOfGroup, notRendered});
    if (shown > 0)
        warnings.push_back(
            {choices.withShown ? WarningKind::shownInGroup : WarningKind::shownLeftOut, shown});
}

/// The labels of the conditions, in the design's order; ordered by code while blinded.
core::Result<std::vector<std::string>> labelsOf(database::StudyReader& reader, const StudyAnalysis& study) {
    std::vector<std::string> labels;
    if (!study.blind()) {
        for (const psychophysics::Condition& condition : study.design.conditions)
            labels.push_back(condition.id);
        return labels;
    }
    auto codes = reader.conditionCodes(study.record.summary.id);
    CHIRON_TRY(codes);
    for (const database::SealedCondition& each : *codes)
        labels.push_back(labelOf(each));
    return labels;
}

} // namespace

void warnNotRendered(psychophysics::RunEstimate& estimate, const database::Participant& participant,
                     const std::vector<database::StudyTrial>& trials) {
    if (wasNotRendered(participant, trials))
        estimate.warnings.push_back({psychophysics::WarningKind::notRenderedRun});
}

void warnShown(psychophysics::RunEstimate& estimate, const std::vector<database::StudyTrial>& trials) {
    const auto shown = std::count_if(trials.begin(), trials.end(),
                                     [](const auto& trial) { return trial.felt && !*trial.felt; });
    if (shown > 0)
        estimate.warnings.push_back({psychophysics::WarningKind::shownRun, static_cast<int>(shown)});
}

const psychophysics::Condition* StudyAnalysis::designed(std::size_t at) const {
    return analysedBy(design, blinding, conditions[at].condition);
}

const psychophysics::Condition* analysedBy(const psychophysics::StudyDesign& design,
                                           const database::Blinding& blinding, const std::string& condition) {
    if (blinding.on)
        return blinding.analysable() ? &design.conditions.front() : nullptr;
    return conditionOf(design, condition);
}

psychophysics::RunEstimate estimateOf(const psychophysics::Condition* condition,
                                      const std::vector<psychophysics::ScoredTrial>& trials,
                                      const database::Blinding& blinding, std::uint64_t seed) {
    psychophysics::RunEstimate estimate;
    if (!condition) {
        estimate.warnings.push_back({psychophysics::WarningKind::sealed});
        return estimate;
    }
    estimate = psychophysics::estimateRun(*condition, trials, seed);
    // These values are relative to another condition's reference.
    if (blinding.on) {
        estimate.jnd = estimate.pse = std::numeric_limits<double>::quiet_NaN();
        estimate.pse95 = {};
        estimate.unit.clear();
    }
    return estimate;
}

namespace {

/// The study before its analysis: the design, and its conditions without runs.
core::Result<StudyAnalysis> opened(database::StudyReader& reader, database::StudyNumber number) {
    StudyAnalysis study;
    auto record = reader.study(number);
    CHIRON_TRY(record);
    study.record = std::move(*record);
    auto design = catalogue::readStudy(QByteArray::fromStdString(study.record.designJson),
                                       "study " + std::to_string(number));
    CHIRON_TRY(design);
    study.design = std::move(*design);
    study.blinding = study.record.blinding;
    const auto labels = labelsOf(reader, study);
    CHIRON_TRY(labels);
    for (const std::string& label : *labels)
        study.conditions.push_back({label, {}, {}, {}, {}, {}});
    return study;
}

core::Result<void> addRuns(database::StudyReader& reader, StudyAnalysis& study,
                           const database::Participant& participant, std::uint64_t seed) {
    auto runs = reader.runs(participant.id);
    CHIRON_TRY(runs);
    for (const database::StudyRun& run : *runs) {
        const auto at = std::find_if(study.conditions.begin(), study.conditions.end(),
                                     [&](const auto& each) { return each.condition == labelOf(run); });
        if (at == study.conditions.end() || run.state == database::StudyRunState::stopped)
            continue;
        auto analysed = analyseRun(reader, study, analysedBy(study.design, study.blinding, run.condition),
                                   participant, run, seed);
        CHIRON_TRY(analysed);
        if (!analysed->trials.empty() || study.sealed())
            at->runs.push_back(std::move(*analysed));
    }
    return {};
}

} // namespace

core::Result<StudyAnalysis> analyseStudy(database::StudyReader& reader, database::StudyNumber number,
                                         std::uint64_t seed, const AnalysisChoices& choices) {
    auto study = opened(reader, number);
    CHIRON_TRY(study);
    auto participants = reader.participants(number);
    CHIRON_TRY(participants);
    for (const database::Participant& participant : *participants)
        CHIRON_TRY(addRuns(reader, *study, participant, seed));
    auto quality = reader.trialQuality(number);
    CHIRON_TRY(quality);
    study->quality = std::move(*quality);
    for (const database::Participant& participant : *participants)
        study->codes[participant.id] = participant.code;
    for (std::size_t i = 0; i < study->conditions.size(); ++i) {
        AnalysedCondition& condition = study->conditions[i];
        const psychophysics::Condition* designed = study->designed(i);
        pool(condition, designed, core::Random::mix(seed, "group " + condition.condition), choices);
        // Runs that are withdrawn or simulated do not show it for any condition either.
        if (study->sealed())
            for (AnalysedRun& run : condition.runs)
                run.presence = Presence::sealed;
        condition.roll = groupRoll(*participants, condition.runs,
                                   study->record.summary.state != database::StudyState::frozen,
                                   study->design.participantsPlanned);
        if (study->sealed())
            for (RolledPerson& person : condition.roll.people)
                person = {person.code, Presence::sealed};
        if (designed && looksForApex(*designed))
            poolApex(condition, designed->stimulus.reference,
                     core::Random::mix(seed, "apex " + condition.condition));
    }
    study->comparisons = compareAll(*study, seed);
    return study;
}

} // namespace chiron::session
