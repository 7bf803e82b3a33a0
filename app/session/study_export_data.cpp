// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study_export_data.h"

#include "catalogue/study_json.h"
#include "session/study/questionnaire_replies.h"
#include "session/study/study_analysis.h"
#include "session/study/study_store.h"

#include <algorithm>
#include <map>

namespace chiron::session {

namespace {

using database::StudyTrial;

/// Codes are random, so that the tables reveal neither the order of enrolment nor that of the runs.
void sortByCodes(StudyExportData& data) {
    std::sort(data.participants.begin(), data.participants.end(),
              [](const auto& a, const auto& b) { return a.participant.code < b.participant.code; });
    std::map<database::ParticipantNumber, std::string> codes;
    for (const ExportedParticipant& each : data.participants)
        codes[each.participant.id] = each.participant.code;
    const auto key = [&](const database::QuestionnaireAnswer& answer) {
        return std::pair(codes[answer.participant], labelOf(answer));
    };
    std::stable_sort(data.answers.begin(), data.answers.end(),
                     [&](const auto& a, const auto& b) { return key(a) < key(b); });
    for (ExportedParticipant& each : data.participants)
        std::stable_sort(each.runs.begin(), each.runs.end(),
                         [](const auto& a, const auto& b) { return a.label < b.label; });
}

core::Result<void> addRuns(database::StudyReader& reader, const StudyExportData& data,
                           ExportedParticipant& participant) {
    auto runs = reader.runs(participant.participant.id);
    CHIRON_TRY(runs);
    std::map<std::string, int> counts;
    for (database::StudyRun& run : *runs) {
        const psychophysics::Condition* condition = analysedBy(*data.design, data.blinding, run.condition);
        if (!condition && !data.blinded)
            return core::fail(core::ErrorCode::badInput, "run " + std::to_string(run.id) +
                                                             ": its condition is not in the frozen design");
        auto trials = reader.studyTrials(run.id);
        CHIRON_TRY(trials);
        ExportedRun exported;
        exported.condition = condition ? condition : &data.design->conditions.front();
        exported.label = QString::fromStdString(labelOf(run));
        exported.index = ++counts[labelOf(run)];
        const auto scored = scoredTrialsOf(*trials);
        exported.estimate = estimateOf(condition, scored, data.blinding, run.seed);
        warnNotRendered(exported.estimate, participant.participant, *trials);
        warnShown(exported.estimate, *trials);
        exported.trials = std::move(*trials);
        exported.run = std::move(run);
        participant.runs.push_back(std::move(exported));
    }
    return {};
}

} // namespace

QString english(const psychophysics::StudyText& words) {
    const auto found = words.find("en");
    return found == words.end() ? QString() : QString::fromStdString(found->second);
}

std::vector<psychophysics::ScoredTrial> scoredTrialsOf(const std::vector<StudyTrial>& trials) {
    std::vector<psychophysics::ScoredTrial> scored;
    for (const StudyTrial& trial : trials) {
        if (trial.practice || trial.undone || !trial.spoiled.empty() || (trial.answer < 0 && !trial.value))
            continue;
        scored.push_back(
            {trial.procedure, trial.arrangement, trial.answer, trial.outcome, trial.difference, trial.value});
    }
    return scored;
}

core::Result<StudyExportData> gatherStudy(database::StudyReader& reader, database::StudyNumber study) {
    StudyExportData data;
    auto record = reader.study(study);
    CHIRON_TRY(record);
    data.record = std::move(*record);
    if (data.record.summary.state == database::StudyState::draft || data.record.summary.sha256.empty())
        return core::fail(core::ErrorCode::wrongUse, "study \"" + data.record.summary.key +
                                                         "\": a draft has no data; expected a frozen study");
    auto design =
        catalogue::readStudy(QByteArray::fromStdString(data.record.designJson), data.record.summary.key);
    CHIRON_TRY(design);
    data.design = std::make_unique<psychophysics::StudyDesign>(std::move(*design));
    data.blinding = data.record.blinding;
    data.blinded = data.blinding.on;
    data.sealed = data.blinding.seals();
    data.oneTask = data.blinding.oneTask;
    data.oneTable = data.blinding.oneTable;
    auto participants = reader.participants(study);
    auto answers = reader.questionnaireAnswers(study);
    auto quality = reader.trialQuality(study);
    CHIRON_TRY(participants);
    CHIRON_TRY(answers);
    CHIRON_TRY(quality);
    data.answers = std::move(*answers);
    data.quality = std::move(*quality);
    for (database::Participant& participant : *participants) {
        ExportedParticipant exported{std::move(participant), {}};
        CHIRON_TRY(addRuns(reader, data, exported));
        data.participants.push_back(std::move(exported));
    }
    if (data.blinded)
        sortByCodes(data);
    return data;
}

} // namespace chiron::session
