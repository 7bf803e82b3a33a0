// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_json.h"
#include "cli/cli_errors.h"
#include "cli/study/questionnaire_sheet.h"
#include "cli/study/study_access.h"
#include "cli/text_table.h"
#include "session/study/questionnaire_replies.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <cmath>

namespace chiron::cli {

namespace {

using psychophysics::Questionnaire;
using psychophysics::QuestionnaireSummary;

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

QJsonValue number(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}

template <class T> QJsonArray list(const std::vector<T>& values, QJsonValue (*each)(const T&)) {
    QJsonArray array;
    for (const T& value : values)
        array.append(each(value));
    return array;
}

QJsonArray counts(const std::vector<int>& values) {
    return list<int>(values, [](const int& value) { return QJsonValue(value); });
}

QJsonArray strings(const std::vector<std::string>& values) {
    return list<std::string>(values, [](const std::string& value) { return QJsonValue(text(value)); });
}

QJsonObject correlationJson(const psychophysics::RankCorrelation& tau) {
    return {{"tau", number(tau.tau)}, {"p_value", number(tau.pValue)}, {"pairs", tau.pairs}};
}

QJsonObject likertJson(const psychophysics::LikertSummary& s) {
    return {{"item", text(s.item)},
            {"construct", text(s.construct)},
            {"scale", s.scale},
            {"counts", counts(s.counts)},
            {"answered", s.answered},
            {"missing", s.missing},
            {"median", number(s.median)},
            {"lower_quartile", number(s.lowerQuartile)},
            {"upper_quartile", number(s.upperQuartile)},
            {"agreement", number(s.agreement)},
            {"agreement_ci", QJsonArray{number(s.agreementLow), number(s.agreementHigh)}},
            {"content_validity_index", number(s.contentValidityIndex)},
            {"content_validity_kappa", number(s.contentValidityKappa)},
            {"performance", correlationJson(s.withPerformance)},
            {"warnings", strings(s.warnings)}};
}

QJsonObject constructJson(const psychophysics::ConstructSummary& s) {
    return {{"construct", text(s.construct)},
            {"items", s.items},
            {"answers", s.answers},
            {"median", number(s.median)},
            {"agreement", number(s.agreement)},
            {"agreement_ci", QJsonArray{number(s.agreementLow), number(s.agreementHigh)}},
            {"content_validity_average", number(s.contentValidityAverage)},
            {"content_validity_universal", number(s.contentValidityUniversal)}};
}

QJsonObject numberJson(const psychophysics::NumberSummary& s) {
    QJsonObject json{{"item", text(s.item)}, {"answered", s.answered}};
    if (!s.choiceCounts.empty()) {
        json.insert("choice_counts", counts(s.choiceCounts));
        return json;
    }
    json.insert("mean", number(s.mean));
    json.insert("sd", number(s.sd));
    json.insert("median", number(s.median));
    json.insert("performance", correlationJson(s.withPerformance));
    return json;
}

QJsonObject summaryJson(const Questionnaire& questionnaire, const QuestionnaireSummary& s, bool withTexts) {
    QJsonArray likert, constructs, numbers, texts;
    for (const auto& each : s.likert)
        likert.append(likertJson(each));
    for (const auto& each : s.constructs)
        constructs.append(constructJson(each));
    for (const auto& each : s.numbers)
        numbers.append(numberJson(each));
    for (const auto& each : s.texts) {
        QJsonObject json{{"item", text(each.item)}, {"answered", static_cast<int>(each.answers.size())}};
        if (withTexts)
            json.insert("answers", strings(each.answers));
        texts.append(json);
    }
    return {{"id", text(questionnaire.id)},   {"replies", s.replies}, {"likert", likert},
            {"constructs", constructs},       {"numbers", numbers},   {"texts", texts},
            {"warnings", strings(s.warnings)}};
}

/// `of`: the prefix of the question's id.
void addRows(TextTable& table, const QString& of, const QuestionnaireSummary& s) {
    const auto range = [](double low, double high) {
        return std::isfinite(low) ? QStringLiteral("%1-%2").arg(shortNumber(low), shortNumber(high))
                                  : QStringLiteral("-");
    };
    for (const auto& each : s.likert)
        table.add({of + text(each.item), text(each.construct), QString::number(each.answered),
                   shortNumber(each.median), range(each.lowerQuartile, each.upperQuartile),
                   shortNumber(each.agreement), range(each.agreementLow, each.agreementHigh),
                   shortNumber(each.withPerformance.tau)});
    for (const auto& each : s.constructs)
        table.add({of + QStringLiteral("(%1)").arg(text(each.construct)),
                   text(each.construct),
                   QString::number(each.answers),
                   shortNumber(each.median),
                   {},
                   shortNumber(each.agreement),
                   range(each.agreementLow, each.agreementHigh)});
    for (const auto& each : s.numbers) {
        QStringList tally;
        for (const int count : each.choiceCounts)
            tally << QString::number(count);
        table.add({of + text(each.item),
                   {},
                   QString::number(each.answered),
                   tally.isEmpty() ? shortNumber(each.median) : tally.join(u'/'),
                   {},
                   {},
                   {},
                   shortNumber(each.withPerformance.tau)});
    }
    for (const auto& each : s.texts)
        table.add({of + text(each.item), {}, QString::number(each.answers.size())});
}

QString textsBelow(const Questionnaire& questionnaire, const QuestionnaireSummary& s) {
    QString words;
    for (const auto& each : s.texts)
        for (const std::string& answer : each.answers)
            words += QStringLiteral("%1.%2: %3\n")
                         .arg(text(questionnaire.id), text(each.item), quoted(text(answer)));
    return words;
}

} // namespace

core::Result<CommandOutput> summariseQuestionnaires(const Arguments& arguments) {
    auto study = openStudy(arguments, Opening::forReading);
    CHIRON_TRY(study);
    const auto design =
        catalogue::readStudy(QByteArray::fromStdString(study->record.designJson), study->record.summary.key);
    CHIRON_TRY(design);
    const auto questionnaires = chosenQuestionnaires(arguments, *design);
    CHIRON_TRY(questionnaires);
    database::StudyReader reader = study->reader();
    const auto answers = reader.questionnaireAnswers(study->number());
    CHIRON_TRY(answers);
    std::map<database::ParticipantNumber, double> performance;
    if (arguments.has(QStringLiteral("performance"))) {
        const auto analysis = session::analyseStudy(reader, study->number(), 1);
        CHIRON_TRY(analysis);
        performance = session::performanceOf(*analysis);
    }
    const bool withTexts = arguments.has(QStringLiteral("texts"));
    QJsonArray list;
    TextTable table(
        {"question", "construct", ">answers", ">median", ">quartiles", ">agree", ">95 %", ">tau"});
    QString texts;
    for (const Questionnaire* questionnaire : *questionnaires) {
        for (const session::AnsweredPart& part : session::answeredParts(*design, *questionnaire, *answers)) {
            const QuestionnaireSummary summary = psychophysics::summariseQuestionnaire(
                *questionnaire, session::questionnaireReplies(*questionnaire, part.answers, performance));
            QJsonObject json = summaryJson(*questionnaire, summary, withTexts);
            if (!part.label.empty())
                json.insert("condition", text(part.label));
            list.append(json);
            addRows(table,
                    text(questionnaire->id) + (part.label.empty() ? QString() : u'@' + text(part.label)) +
                        u'.',
                    summary);
            texts += withTexts ? textsBelow(*questionnaire, summary) : QString();
        }
    }
    return CommandOutput{QJsonDocument(QJsonObject{{"study", text(study->record.summary.key)},
                                                   {"sha256", text(study->record.summary.sha256)},
                                                   {"questionnaires", list}}),
                         table.toText() + texts, 0};
}

} // namespace chiron::cli
