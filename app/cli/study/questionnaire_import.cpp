// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_json.h"
#include "cli/cli_errors.h"
#include "cli/input_file.h"
#include "cli/study/questionnaire_sheet.h"
#include "cli/study/study_access.h"
#include "database/repositories/study_repository.h"
#include "session/study/questionnaire_replies.h"
#include "session/study/study_store.h"

#include <QJsonDocument>
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace chiron::cli {

namespace {

using database::QuestionnaireAnswer;
/// Participant, questionnaire, item, condition (empty if the question is asked once).
using Asked = std::tuple<database::ParticipantNumber, std::string, std::string, std::string>;
/// The completed run of a participant at a condition.
using DoneRuns = std::map<std::pair<database::ParticipantNumber, std::string>, database::StudyRunNumber>;

/// The normalised form in which codes are compared: case and "-" do not matter.
QString plainCode(const QString& code) {
    return code.toUpper().remove(u'-');
}

/// Compares the rows of a sheet with the stored answers.
class Matching {
public:
    /// `language`: the language of the forms; empty if not stated.
    Matching(const std::vector<database::Participant>& participants,
             const std::vector<QuestionnaireAnswer>& stored, DoneRuns runs, std::string language,
             bool incomplete, SheetFaults& faults)
        : m_incomplete(incomplete), m_faults(faults), m_runs(std::move(runs)),
          m_language(std::move(language)) {
        for (const database::Participant& each : participants)
            m_participants[plainCode(QString::fromStdString(each.code))] = &each;
        for (const QuestionnaireAnswer& each : stored)
            m_stored[{each.participant, each.questionnaire, each.item, session::labelOf(each)}] = &each;
    }

    void take(const SheetRow& row) {
        const auto found = m_participants.find(plainCode(row.code));
        if (found == m_participants.end()) {
            if (!row.code.isEmpty())
                m_faults.add(row.place, QStringLiteral("participant %1").arg(quoted(row.code)),
                             QStringLiteral("the code of somebody who takes part in this study"));
            return;
        }
        const database::Participant& who = *found->second;
        const std::size_t before = m_new.size();
        for (const SheetAnswer& answer : row.answers)
            if (answer.given())
                takeAnswer(who, answer);
        if (m_new.size() > before && who.state == database::ParticipantState::withdrawn)
            m_faults.add(row.place, QStringLiteral("participant %1 has withdrawn").arg(row.code),
                         QStringLiteral("somebody who still takes part"));
        if (!m_incomplete)
            findMissing(who, row);
    }

    const std::vector<QuestionnaireAnswer>& fresh() const { return m_new; }
    int unchanged() const { return m_unchanged; }
    int participants() const { return static_cast<int>(m_people.size()); }

private:
    static Asked askedOf(const database::Participant& who, const AskedQuestion& question) {
        return {who.id, question.questionnaire->id, question.item->id, question.label};
    }

    QuestionnaireAnswer answerOf(const database::Participant& who, const SheetAnswer& answer,
                                 database::StudyRunNumber run) const {
        QuestionnaireAnswer given{who.id,        answer.asked.questionnaire->id, answer.asked.item->id,
                                  answer.number, answer.text.toStdString(),      {}};
        given.run = run;
        // As in the template: English if the question is not written in that language.
        if (!m_language.empty())
            given.language = answer.asked.item->text.count(m_language) > 0 ? m_language : "en";
        return given;
    }

    void takeAnswer(const database::Participant& who, const SheetAnswer& answer) {
        const Asked asked = askedOf(who, answer.asked);
        const auto [first, isFirst] = m_seen.emplace(asked, answer.place);
        if (!isFirst) {
            m_faults.add(answer.place, QStringLiteral("answered already at %1").arg(first->second),
                         QStringLiteral("each answer once"));
            return;
        }
        const auto run = m_runs.find({who.id, answer.asked.label});
        if (!answer.asked.label.empty() && run == m_runs.end()) {
            m_faults.add(
                answer.place,
                QStringLiteral("condition %1 is not completed by participant %2")
                    .arg(QString::fromStdString(answer.asked.label), QString::fromStdString(who.code)),
                QStringLiteral("answers about conditions that were completed"));
            return;
        }
        const QuestionnaireAnswer given = answerOf(who, answer, answer.asked.label.empty() ? 0 : run->second);
        const auto stored = m_stored.find(asked);
        if (stored == m_stored.end() || who.erased) {
            m_new.push_back(given);
            m_people.insert(who.id);
        } else if (stored->second->withheld) {
            m_faults.add(answer.place,
                         QStringLiteral("an answer is stored, and withheld while the study is blinded"),
                         QStringLiteral("an empty cell, since answers are never changed"));
        } else if (stored->second->number == given.number && stored->second->text == given.text) {
            ++m_unchanged;
        } else {
            m_faults.add(answer.place, QStringLiteral("another answer is stored"),
                         QStringLiteral("the stored one or an empty cell, since answers are never changed"));
        }
    }

    void findMissing(const database::Participant& who, const SheetRow& row) {
        std::set<QString> begun;
        for (const SheetAnswer& answer : row.answers)
            if (answer.given())
                begun.insert(answer.asked.group());
        for (const SheetAnswer& answer : row.answers)
            if (!answer.given() && !answer.faulty && answer.asked.item->required &&
                begun.count(answer.asked.group()) > 0 && !isKnown(askedOf(who, answer.asked)))
                m_faults.add(answer.place, QStringLiteral("empty"),
                             QStringLiteral("an answer, since it must be given, or --incomplete"));
    }

    bool isKnown(const Asked& asked) const { return m_stored.count(asked) > 0 || m_seen.count(asked) > 0; }

    bool m_incomplete;
    SheetFaults& m_faults;
    DoneRuns m_runs;
    std::string m_language;
    std::map<QString, const database::Participant*> m_participants;
    std::map<Asked, const QuestionnaireAnswer*> m_stored;
    std::map<Asked, QString> m_seen; ///< the place in the sheet where each one was first found
    std::vector<QuestionnaireAnswer> m_new;
    std::set<database::ParticipantNumber> m_people;
    int m_unchanged = 0;
};

core::Result<DoneRuns> doneRuns(database::StudyReader reader,
                                const std::vector<database::Participant>& participants) {
    DoneRuns done;
    for (const database::Participant& each : participants) {
        const auto runs = reader.runs(each.id);
        CHIRON_TRY(runs);
        for (const database::StudyRun& run : *runs)
            if (run.state == database::StudyRunState::completed)
                done[{each.id, session::labelOf(run)}] = run.id;
    }
    return done;
}

/// All questions of the study.
core::Result<std::vector<AskedQuestion>> allQuestions(const StudySite& study,
                                                      const psychophysics::StudyDesign& design) {
    const auto conditions = study.reader().conditionCodes(study.number());
    CHIRON_TRY(conditions);
    std::vector<std::string> labels;
    for (const database::SealedCondition& each : *conditions)
        labels.push_back(session::labelOf(each));
    std::vector<const psychophysics::Questionnaire*> all;
    for (const psychophysics::Questionnaire& each : design.questionnaires)
        all.push_back(&each);
    return askedQuestions(all, labels);
}

/// The value of --language; empty if it is not given.
/// Errors: wrongUse if no question is written in this language.
core::Result<std::string> languageOf(const Arguments& arguments, const std::vector<AskedQuestion>& asked) {
    const std::string language = arguments.value(QStringLiteral("language")).toStdString();
    if (language.empty() || std::any_of(asked.begin(), asked.end(), [&](const AskedQuestion& each) {
            return each.item->text.count(language) > 0;
        }))
        return language;
    return wrongUse(QStringLiteral("--language: %1: no question of the study is written in it; expected a "
                                   "language of its questionnaires")
                        .arg(quoted(QString::fromStdString(language))));
}

} // namespace

core::Result<CommandOutput> importQuestionnaire(const Arguments& arguments) {
    constexpr qint64 kLargest = 16 << 20;
    const auto bytes = readInputFile(arguments.operand(1), kLargest);
    CHIRON_TRY(bytes);
    auto study = openStudy(arguments, Opening::forWriting);
    CHIRON_TRY(study);
    const auto design =
        catalogue::readStudy(QByteArray::fromStdString(study->record.designJson), study->record.summary.key);
    CHIRON_TRY(design);
    const auto participants = study->reader().participants(study->number());
    const auto stored = study->reader().questionnaireAnswers(study->number());
    CHIRON_TRY(participants);
    CHIRON_TRY(stored);
    auto runs = doneRuns(study->reader(), *participants);
    CHIRON_TRY(runs);
    const auto asked = allQuestions(*study, *design);
    CHIRON_TRY(asked);
    const auto language = languageOf(arguments, *asked);
    CHIRON_TRY(language);
    SheetFaults faults;
    const bool incomplete = arguments.has(QStringLiteral("incomplete"));
    const auto rows = readSheet(*bytes, arguments.operand(1), *asked,
                                QString::fromStdString(study->record.summary.sha256), incomplete, faults);
    CHIRON_TRY(rows);
    Matching matching(*participants, *stored, std::move(*runs), *language, incomplete, faults);
    for (const SheetRow& row : *rows)
        matching.take(row);
    if (!faults.none())
        return tl::unexpected(faults.error());
    // In one transaction, so that either all answers are stored or none.
    auto done = study->site.database->write([&](database::WriteContext& context) -> core::Result<void> {
        return database::StudyRepository(context.connection(), study->site.actor)
            .storeQuestionnaireAnswers(matching.fresh());
    });
    CHIRON_TRY(done);
    const int count = static_cast<int>(matching.fresh().size());
    const QJsonObject json{{"study", QString::fromStdString(study->record.summary.key)},
                           {"stored", count},
                           {"unchanged", matching.unchanged()},
                           {"participants", matching.participants()}};
    return CommandOutput{QJsonDocument(json),
                         QStringLiteral("%1 answers of %2 participants stored; %3 were stored already\n")
                             .arg(count)
                             .arg(matching.participants())
                             .arg(matching.unchanged()),
                         0};
}

} // namespace chiron::cli
