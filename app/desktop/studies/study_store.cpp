// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/study_store.h"

#include "desktop/studies/study_words.h"
#include "psychophysics/designs/latin_square.h"

namespace chiron::desktop {

core::Result<OpenStudy> openStudy(database::StudyReader& reader, database::StudyNumber study) {
    auto record = reader.study(study);
    if (!record)
        return tl::unexpected(record.error());
    auto design = catalogue::readStudy(QByteArray::fromStdString(record->designJson), record->summary.key);
    if (!design)
        return tl::unexpected(design.error());
    OpenStudy open{std::move(record->summary), std::move(*design), {}, {}, {}};
    auto sealed = reader.sealedConditions(study);
    if (!sealed)
        return tl::unexpected(sealed.error());
    open.sealed = std::move(*sealed);
    auto participants = reader.participants(study);
    if (!participants)
        return tl::unexpected(participants.error());
    for (database::Participant& participant : *participants) {
        auto runs = reader.runs(participant.id);
        if (!runs)
            return tl::unexpected(runs.error());
        open.participants.push_back({std::move(participant), std::move(*runs)});
    }
    auto answers = reader.questionnaireAnswers(study);
    if (!answers)
        return tl::unexpected(answers.error());
    for (const database::QuestionnaireAnswer& answer : *answers)
        open.answered.emplace(answer.participant, answer.questionnaire);
    return open;
}

QString conditionName(const OpenStudy& study, const std::string& condition, const QString& language) {
    if (study.blind())
        for (const database::SealedCondition& sealed : study.sealed)
            if (sealed.condition == condition)
                return QString::fromStdString(sealed.sealedCode);
    for (const psychophysics::Condition& each : study.design.conditions)
        if (each.id == condition)
            return study_words::text(each.title, language);
    return QString::fromStdString(condition);
}

std::vector<int> conditionOrder(const psychophysics::StudyDesign& design, int row) {
    return psychophysics::orderFor(design.order, static_cast<int>(design.conditions.size()), row, design.seed);
}

} // namespace chiron::desktop
