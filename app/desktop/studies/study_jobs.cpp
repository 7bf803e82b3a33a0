// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/study_jobs.h"

#include "desktop/studies/study_words.h"
#include "session/study/presentation_order.h"
#include "session/study/study_analysis.h"
#include "session/study/study_store.h"

#include <algorithm>

namespace chiron::desktop {

namespace {

bool counts(const database::StudyTrial& trial) {
    return !trial.practice && !trial.undone && trial.spoiled.empty() && (trial.answer >= 0 || trial.value);
}

core::Result<std::vector<LeftRun>> leftRuns(database::StudyReader& reader, const OpenStudy& study,
                                            const std::vector<database::StudyRun>& runs) {
    std::vector<LeftRun> all;
    for (const database::StudyRun& run : runs) {
        if (run.state != database::StudyRunState::open)
            continue;
        const auto trials = reader.studyTrials(run.id);
        CHIRON_TRY(trials);
        const psychophysics::Condition* condition =
            session::analysedBy(study.design, study.blinding, run.condition);
        all.push_back({run.id, static_cast<int>(std::count_if(trials->begin(), trials->end(), counts)),
                       condition ? session::trialsAtMost(*condition) : 0,
                       trials->empty() ? run.startedUtc : trials->back().utc});
    }
    return all;
}

core::Result<void> addTrials(database::StudyReader& reader, PilotRow& row) {
    const auto participants = reader.participants(row.summary.id);
    CHIRON_TRY(participants);
    double seconds = 0.0;
    for (const database::Participant& participant : *participants) {
        const auto runs = reader.runs(participant.id);
        CHIRON_TRY(runs);
        for (const database::StudyRun& run : *runs) {
            const auto trials = reader.studyTrials(run.id);
            CHIRON_TRY(trials);
            for (const database::StudyTrial& trial : *trials) {
                row.spoiled += database::isRepeated(trial) ? 1 : 0;
                row.scored += counts(trial) ? 1 : 0;
                seconds += counts(trial) ? trial.exploration_s + std::max(0.0, trial.answer_s) : 0.0;
            }
        }
    }
    row.secondsPerTrial = row.scored > 0 ? seconds / row.scored : 0.0;
    return {};
}

core::Result<std::vector<PilotRow>> pilotRows(database::StudyReader& reader, const std::string& key) {
    auto summaries = reader.listPilots(key);
    CHIRON_TRY(summaries);
    std::vector<PilotRow> rows;
    for (database::StudySummary& summary : *summaries) {
        PilotRow row;
        row.summary = std::move(summary);
        CHIRON_TRY(addTrials(reader, row));
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace

int pilotsTried(const OpenStudy& study) {
    return static_cast<int>(std::count_if(study.pilots.begin(), study.pilots.end(),
                                          [](const PilotRow& pilot) { return pilot.scored > 0; }));
}

core::Result<OpenStudy> openStudy(database::StudyReader& reader, database::StudyNumber study) {
    auto record = reader.study(study);
    CHIRON_TRY(record);
    auto design = catalogue::readStudy(QByteArray::fromStdString(record->designJson), record->summary.key);
    CHIRON_TRY(design);
    OpenStudy open{std::move(record->summary), std::move(*design), {}, {}, {}, {},
                   record->blinding,           record->masked,     {}};
    auto sealed = reader.conditionCodes(study);
    CHIRON_TRY(sealed);
    open.sealed = std::move(*sealed);
    auto participants = reader.participants(study);
    CHIRON_TRY(participants);
    for (database::Participant& participant : *participants) {
        auto runs = reader.runs(participant.id);
        CHIRON_TRY(runs);
        auto left = leftRuns(reader, open, *runs);
        CHIRON_TRY(left);
        open.participants.push_back({std::move(participant), std::move(*runs), std::move(*left)});
    }
    auto answers = reader.questionnaireAnswers(study);
    CHIRON_TRY(answers);
    for (const database::QuestionnaireAnswer& answer : *answers) {
        open.answered.emplace(answer.participant, answer.questionnaire);
        if (answer.run != 0)
            open.answeredAfter.emplace(answer.run, answer.questionnaire);
    }
    auto pilots = pilotRows(reader, open.summary.key);
    CHIRON_TRY(pilots);
    open.pilots = std::move(*pilots);
    return open;
}

QString conditionName(const OpenStudy& study, const std::string& label, const QString& language) {
    for (const psychophysics::Condition& each : study.design.conditions)
        if (!study.blind() && each.id == label)
            return study_words::text(each.title, language);
    return QString::fromStdString(label);
}

std::vector<std::string> conditionLabels(const OpenStudy& study) {
    std::vector<std::string> labels;
    if (study.blind())
        for (const database::SealedCondition& each : study.sealed)
            labels.push_back(session::labelOf(each));
    else
        for (const psychophysics::Condition& each : study.design.conditions)
            labels.push_back(each.id);
    return labels;
}

} // namespace chiron::desktop
