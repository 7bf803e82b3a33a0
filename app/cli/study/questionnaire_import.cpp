// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_reader.h"
#include "cli/input_file.h"
#include "cli/messages.h"
#include "cli/study/questionnaire_sheet.h"
#include "cli/study/study_access.h"
#include "database/repositories/study_repository.h"

#include <QJsonDocument>
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace chiron::cli {

namespace {

using database::QuestionnaireAnswer;
/// Participant, questionnaire, item.
using Asked = std::tuple<database::ParticipantNumber, std::string, std::string>;

/// A code as it is compared: case and "-" do not matter.
QString plainCode(const QString& code) { return code.toUpper().remove(u'-'); }

/// What a sheet's rows come to against what is stored.
class Matching {
public:
    Matching(const std::vector<database::Participant>& participants, const std::vector<QuestionnaireAnswer>& stored, bool incomplete, SheetFaults& faults)
        : m_incomplete(incomplete), m_faults(faults) {
        for (const database::Participant& each : participants)
            m_participants[plainCode(QString::fromStdString(each.code))] = &each;
        for (const QuestionnaireAnswer& each : stored)
            m_stored[{each.participant, each.questionnaire, each.item}] = &each;
    }

    void take(const SheetRow& row) {
        const auto found = m_participants.find(plainCode(row.code));
        if (found == m_participants.end()) {
            if (!row.code.isEmpty())
                m_faults.add(row.place, QStringLiteral("participant %1").arg(quoted(row.code)), QStringLiteral("the code of somebody who takes part in this study"));
            return;
        }
        const database::Participant& who = *found->second;
        const std::size_t before = m_new.size();
        for (const SheetAnswer& answer : row.answers)
            if (answer.given())
                takeAnswer(who, answer);
        if (m_new.size() > before && who.state == database::ParticipantState::withdrawn)
            m_faults.add(row.place, QStringLiteral("participant %1 has withdrawn").arg(row.code), QStringLiteral("somebody who still takes part"));
        if (!m_incomplete)
            findMissing(who, row);
    }

    const std::vector<QuestionnaireAnswer>& fresh() const { return m_new; }
    int unchanged() const { return m_unchanged; }
    int participants() const { return static_cast<int>(m_people.size()); }

private:
    void takeAnswer(const database::Participant& who, const SheetAnswer& answer) {
        const Asked asked{who.id, answer.questionnaire->id, answer.item->id};
        const auto [first, isFirst] = m_seen.emplace(asked, answer.place);
        if (!isFirst) {
            m_faults.add(answer.place, QStringLiteral("answered already at %1").arg(first->second), QStringLiteral("each answer once"));
            return;
        }
        const QuestionnaireAnswer given{who.id, answer.questionnaire->id, answer.item->id, answer.number, answer.text.toStdString(), {}};
        const auto stored = m_stored.find(asked);
        if (stored == m_stored.end() || who.erased) {
            m_new.push_back(given);
            m_people.insert(who.id);
        } else if (stored->second->number == given.number && stored->second->text == given.text) {
            ++m_unchanged;
        } else {
            m_faults.add(answer.place, QStringLiteral("another answer is stored"), QStringLiteral("the stored one or an empty cell, since answers are never changed"));
        }
    }

    void findMissing(const database::Participant& who, const SheetRow& row) {
        std::set<const psychophysics::Questionnaire*> begun;
        for (const SheetAnswer& answer : row.answers)
            if (answer.given())
                begun.insert(answer.questionnaire);
        for (const SheetAnswer& answer : row.answers)
            if (!answer.given() && !answer.faulty && answer.item->required && begun.count(answer.questionnaire) > 0 &&
                !isKnown({who.id, answer.questionnaire->id, answer.item->id}))
                m_faults.add(answer.place, QStringLiteral("empty"), QStringLiteral("an answer, since it must be given, or --incomplete"));
    }

    bool isKnown(const Asked& asked) const { return m_stored.count(asked) > 0 || m_seen.count(asked) > 0; }

    bool m_incomplete;
    SheetFaults& m_faults;
    std::map<QString, const database::Participant*> m_participants;
    std::map<Asked, const QuestionnaireAnswer*> m_stored;
    std::map<Asked, QString> m_seen; ///< where
    std::vector<QuestionnaireAnswer> m_new;
    std::set<database::ParticipantNumber> m_people;
    int m_unchanged = 0;
};

} // namespace

core::Result<CommandOutput> importQuestionnaire(const Arguments& arguments) {
    constexpr qint64 kLargest = 16 << 20;
    const auto bytes = readInputFile(arguments.operand(1), kLargest);
    if (!bytes)
        return tl::unexpected(bytes.error());
    auto study = openStudy(arguments, Opening::forWriting);
    const auto design = study ? catalogue::readStudy(QByteArray::fromStdString(study->record.designJson), study->record.summary.key) : tl::unexpected(study.error());
    if (!design)
        return tl::unexpected(design.error());
    const auto participants = study->reader().participants(study->number());
    const auto stored = study->reader().questionnaireAnswers(study->number());
    if (!participants || !stored)
        return tl::unexpected(participants ? stored.error() : participants.error());
    SheetFaults faults;
    const bool incomplete = arguments.has(QStringLiteral("incomplete"));
    const auto rows = readSheet(*bytes, arguments.operand(1), *design, QString::fromStdString(study->record.summary.sha256), incomplete, faults);
    if (!rows)
        return tl::unexpected(rows.error());
    Matching matching(*participants, *stored, incomplete, faults);
    for (const SheetRow& row : *rows)
        matching.take(row);
    if (!faults.none())
        return tl::unexpected(faults.error());
    auto done = study->site.database->write([&](database::WriteContext& context) -> core::Result<void> { // one transaction: all of them or none
        return database::StudyRepository(context.connection(), study->site.actor).storeQuestionnaireAnswers(matching.fresh());
    });
    if (!done)
        return tl::unexpected(done.error());
    const int count = static_cast<int>(matching.fresh().size());
    const QJsonObject json{{"study", QString::fromStdString(study->record.summary.key)}, {"stored", count}, {"unchanged", matching.unchanged()}, {"participants", matching.participants()}};
    return CommandOutput{QJsonDocument(json), QStringLiteral("%1 answers of %2 participants stored; %3 were stored already\n").arg(count).arg(matching.participants()).arg(matching.unchanged()), 0};
}

} // namespace chiron::cli
