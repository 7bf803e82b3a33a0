// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/canonical_json.h"
#include "database/accounts/account_rules.h"
#include "database/repositories/study_rules.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <cmath>

namespace chiron::database {
namespace {

constexpr int kMaximumAnswerCharacters = 10000;

core::Result<void> badFact(const std::string& message) {
    return core::fail(core::ErrorCode::badInput, message);
}

// Returns the element with this id from an array of objects; empty if there is none.
QJsonObject withId(const QJsonValue& array, const std::string& id) {
    for (const QJsonValue value : array.toArray()) {
        if (value.toObject()["id"].toString().toStdString() == id) {
            return value.toObject();
        }
    }
    return {};
}

core::Result<void> checkNumber(const std::string& place, double number, double lowest, double highest,
                               bool whole) {
    const bool good = number >= lowest && number <= highest && (!whole || number == std::floor(number));
    return good ? core::Result<void>()
                : badFact(place + ": " + std::to_string(number) + ": expected a " + (whole ? "whole " : "") +
                          "number from " + std::to_string(lowest) + " to " + std::to_string(highest));
}

} // namespace

core::Result<QJsonObject> designObject(const std::string& json) {
    if (json.size() > static_cast<std::size_t>(kMaximumDesignBytes)) {
        return core::fail(core::ErrorCode::badInput, "design: expected at most 1 MiB of JSON");
    }
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(json), &error);
    if (error.error != QJsonParseError::NoError || !document.isObject()) {
        return core::fail(core::ErrorCode::badInput,
                          "design: expected a JSON object: " + error.errorString().toStdString());
    }
    return document.object();
}

std::vector<std::string> conditionIds(const QJsonObject& design) {
    std::vector<std::string> ids;
    for (const QJsonValue condition : design["conditions"].toArray()) {
        ids.push_back(condition.toObject()["id"].toString().toStdString());
    }
    return ids;
}

std::vector<std::string> consentDigests(const QJsonObject& design) {
    std::vector<std::string> digests;
    for (const QJsonValue text : design["consent"].toObject()) {
        digests.push_back(catalogue::sha256Hex(text.toString().toStdString()));
    }
    return digests;
}

bool isEnrolment(const QJsonObject& design, const std::string& questionnaire) {
    return withId(design["questionnaires"], questionnaire)["when"].toString() == QLatin1String("enrolment");
}

bool isOfConditions(const QJsonObject& design, const std::string& questionnaire) {
    return withId(design["questionnaires"], questionnaire)["when"].toString() ==
           QLatin1String("after_condition");
}

namespace {

/// Checks that the question exists in the answer's language, and that a run is named if the questionnaire is
/// asked after each condition.
core::Result<void> checkShown(const QJsonObject& design, const QuestionnaireAnswer& answer,
                              const QJsonObject& item, const std::string& place) {
    if (!answer.language.empty() &&
        !item["text"].toObject().contains(QString::fromStdString(answer.language))) {
        return badFact(place + ": language " + answer.language +
                       ": expected one that the question is written in");
    }
    const bool ofConditions = isOfConditions(design, answer.questionnaire);
    if (ofConditions == (answer.run != 0)) {
        return {};
    }
    return badFact(place + (ofConditions ? ": expected the run that it was asked after"
                                         : ": expected no run, since it is asked once"));
}

} // namespace

core::Result<void> checkAnswer(const QJsonObject& design, const QuestionnaireAnswer& answer) {
    const std::string place = "answer " + answer.questionnaire + "." + answer.item;
    const QJsonObject item =
        withId(withId(design["questionnaires"], answer.questionnaire)["items"], answer.item);
    if (item.isEmpty()) {
        return badFact(place + ": the design asks no such question");
    }
    CHIRON_TRY(checkShown(design, answer, item, place));
    const QString kind = item["kind"].toString();
    if (kind == "text") {
        return answer.number ? badFact(place + ": expected a text")
                             : checkText(place, answer.text, kMaximumAnswerCharacters);
    }
    if (!answer.number || !answer.text.empty()) {
        return badFact(place + ": expected a number");
    }
    if (kind == "number") {
        return checkNumber(place, *answer.number, item["lowest"].toDouble(), item["highest"].toDouble(),
                           false);
    }
    return kind == "choice" ? checkNumber(place, *answer.number, 0.0,
                                          static_cast<double>(item["choices"].toArray().size()) - 1.0, true)
                            : checkNumber(place, *answer.number, 1.0, item["scale"].toDouble(5.0), true);
}

} // namespace chiron::database
