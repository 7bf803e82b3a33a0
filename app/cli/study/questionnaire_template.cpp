// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_json.h"
#include "cli/cli_errors.h"
#include "cli/study/questionnaire_sheet.h"
#include "cli/study/study_access.h"
#include "session/study/questionnaire_replies.h"
#include "session/study/study_store.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>

namespace chiron::cli {

namespace {

using psychophysics::Questionnaire;
using psychophysics::QuestionnaireItem;

/// The contents of a template.
struct Blank {
    QString study;
    QString sha256;
    std::string language;
    std::vector<AskedQuestion> asked;
    QStringList codes; ///< participants who have not answered all of the questions yet
};

QString inLanguage(const psychophysics::StudyText& words, const std::string& language) {
    auto found = words.find(language);
    found = found == words.end() ? words.find("en") : found;
    return found == words.end() ? QString() : QString::fromStdString(found->second);
}

QString cell(QString words) {
    words.replace(u'"', QStringLiteral("\"\""));
    return QStringLiteral("\"%1\"").arg(words.simplified());
}

QByteArray csvOf(const Blank& blank) {
    QStringList notes{QStringLiteral("# Study %1, design %2. One row for each participant; a cell that is "
                                     "left empty was not answered.")
                          .arg(blank.study, blank.sha256)};
    QStringList heading{QStringLiteral("participant")};
    for (const AskedQuestion& each : blank.asked) {
        heading << each.name();
        notes << QStringLiteral("# %1: %2 %3%4")
                     .arg(heading.last(), inLanguage(each.item->text, blank.language),
                          expectedAnswer(*each.item, blank.language),
                          each.item->required ? QString() : QStringLiteral("; may be left out"));
    }
    QString csv;
    for (const QString& note : notes)
        csv += cell(note) + u'\n';
    csv += heading.join(u',') + u'\n';
    for (const QString& code : blank.codes)
        csv += code + QString(heading.size() - 1, u',') + u'\n';
    // Spreadsheets recognise UTF-8 only with a byte-order mark.
    return "\xef\xbb\xbf" + csv.toUtf8();
}

QByteArray jsonOf(const Blank& blank) {
    QJsonObject questions, empty;
    for (const AskedQuestion& each : blank.asked) {
        const QuestionnaireItem& item = *each.item;
        QJsonObject explained = questions[each.group()].toObject(), answers = empty[each.group()].toObject();
        explained.insert(QString::fromStdString(item.id),
                         QJsonObject{{"question", inLanguage(item.text, blank.language)},
                                     {"answer", expectedAnswer(item, blank.language)},
                                     {"required", item.required}});
        answers.insert(QString::fromStdString(item.id), QJsonValue::Null);
        questions.insert(each.group(), explained);
        empty.insert(each.group(), answers);
    }
    QJsonArray participants;
    for (const QString& code : blank.codes)
        participants.append(QJsonObject{{"participant", code}, {"answers", empty}});
    return QJsonDocument(QJsonObject{{"study", blank.study},
                                     {"design_sha256", blank.sha256},
                                     {"questions", questions},
                                     {"participants", participants}})
        .toJson();
}

/// Sorted by code, so that neither the order of enrolment nor anybody's order of conditions can be seen.
QStringList openCodes(const Blank& blank, const std::vector<database::Participant>& participants,
                      const std::vector<database::QuestionnaireAnswer>& answers) {
    QStringList codes;
    for (const database::Participant& each : participants) {
        // Any answer of the questionnaire counts: a question that was left out then is not asked again.
        const auto hasAnswered = [&](const AskedQuestion& asked) {
            return std::any_of(answers.begin(), answers.end(), [&](const auto& answer) {
                return answer.participant == each.id && answer.questionnaire == asked.questionnaire->id &&
                       session::labelOf(answer) == asked.label;
            });
        };
        if (each.state != database::ParticipantState::withdrawn &&
            !std::all_of(blank.asked.begin(), blank.asked.end(), hasAnswered))
            codes << QString::fromStdString(each.code);
    }
    codes.sort();
    return codes;
}

core::Result<void> writeNew(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::NewOnly))
        return QFileInfo::exists(path)
                   ? badInput(
                         QStringLiteral("--out: %1: exists already; expected a file that does not exist yet")
                             .arg(quoted(path)))
                   : core::fail(core::ErrorCode::storage, QStringLiteral("--out: %1: cannot be written: %2")
                                                              .arg(quoted(path), file.errorString())
                                                              .toStdString());
    if (file.write(bytes) == bytes.size() && file.flush())
        return {};
    file.remove();
    return core::fail(core::ErrorCode::storage, QStringLiteral("--out: %1: cannot be written: %2")
                                                    .arg(quoted(path), file.errorString())
                                                    .toStdString());
}

} // namespace

core::Result<CommandOutput> questionnaireTemplate(const Arguments& arguments) {
    const auto format = arguments.choice(QStringLiteral("format"), {"csv", "json"}, QStringLiteral("csv"));
    CHIRON_TRY(format);
    auto study = openStudy(arguments, Opening::forReading);
    CHIRON_TRY(study);
    const auto& summary = study->record.summary;
    if (summary.sha256.empty())
        return core::fail(core::ErrorCode::wrongUse,
                          "study \"" + summary.key +
                              "\": a draft has no participants; expected a frozen study");
    const auto design =
        catalogue::readStudy(QByteArray::fromStdString(study->record.designJson), summary.key);
    CHIRON_TRY(design);
    const auto questionnaires = chosenQuestionnaires(arguments, *design);
    CHIRON_TRY(questionnaires);
    const auto participants = study->reader().participants(study->number());
    const auto answers = study->reader().questionnaireAnswers(study->number());
    const auto conditions = study->reader().conditionCodes(study->number());
    CHIRON_TRY(participants);
    CHIRON_TRY(answers);
    CHIRON_TRY(conditions);
    std::vector<std::string> labels;
    for (const database::SealedCondition& each : *conditions)
        labels.push_back(session::labelOf(each));
    const QString language = arguments.has(QStringLiteral("language"))
                                 ? arguments.value(QStringLiteral("language"))
                                 : QStringLiteral("en");
    Blank blank{QString::fromStdString(summary.key),
                QString::fromStdString(summary.sha256),
                language.toStdString(),
                askedQuestions(*questionnaires, labels),
                {}};
    blank.codes = openCodes(blank, *participants, *answers);
    const QString out = QFileInfo(arguments.value(QStringLiteral("out"))).absoluteFilePath();
    CHIRON_TRY(writeNew(out, *format == u"json" ? jsonOf(blank) : csvOf(blank)));
    QJsonArray ids;
    for (const Questionnaire* each : *questionnaires)
        ids.append(QString::fromStdString(each->id));
    return CommandOutput{QJsonDocument(QJsonObject{{"study", blank.study},
                                                   {"file", out},
                                                   {"questionnaires", ids},
                                                   {"participants", blank.codes.size()}}),
                         QStringLiteral("%1: %2 participants\n").arg(out).arg(blank.codes.size()), 0};
}

} // namespace chiron::cli
