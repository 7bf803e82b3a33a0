// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_parts.h"

#include "psychophysics/measures/instrument_score.h"

#include <QRegularExpression>
#include <algorithm>

namespace chiron::catalogue {

using psychophysics::Questionnaire;
using psychophysics::QuestionnaireItem;
using psychophysics::StudyText;

namespace {

constexpr int kLongestText = 20000;

template <class Owner, std::size_t n>
void readNumbers(const ObjectReader& json, const NumberKey<Owner> (&keys)[n], Owner& out,
                 std::vector<QString>& known) {
    for (const NumberKey<Owner>& key : keys) {
        known.push_back(QLatin1String(key.name));
        out.*key.member = readNumber(json, key.name, key.lowest, key.highest, out.*key.member);
    }
}

template <class Owner, std::size_t n>
void readWholes(const ObjectReader& json, const WholeKey<Owner> (&keys)[n], Owner& out,
                std::vector<QString>& known) {
    for (const WholeKey<Owner>& key : keys) {
        known.push_back(QLatin1String(key.name));
        out.*key.member = readWhole(json, key.name, key.lowest, key.highest, out.*key.member);
    }
}

void readChoices(const ObjectReader& json, QuestionnaireItem& item) {
    const QJsonArray array = json.json()["choices"].toArray();
    if (array.size() < 2 || array.size() > 50)
        addProblem(json, "choices", QString::number(array.size()),
                   QStringLiteral("an array of 2 to 50 texts"));
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QString at = elementPath(memberPath(json.path(), "choices"), i);
        const ObjectReader one(QJsonObject{{"text", array[i]}}, at, json.problems());
        item.choices.push_back(readStudyText(one, "text", true));
    }
}

QuestionnaireItem readItem(const ObjectReader& json) {
    QuestionnaireItem item;
    item.id = readIdentifier(json, "id");
    item.text = readStudyText(json, "text", true);
    item.kind = readWord(json, "kind", kItemKinds, QuestionnaireItem::Kind::likert);
    item.required = readSwitch(json, "required", true);
    std::vector<QString> known{"id", "text", "kind", "construct", "required"};
    if (json.has("construct") && !json.text("construct").empty())
        item.construct = readIdentifier(json, "construct");
    if (item.kind == QuestionnaireItem::Kind::likert) {
        item.scale = readWhole(json, "scale", 2, 21, item.scale);
        item.low = readStudyText(json, "low", false);
        item.high = readStudyText(json, "high", false);
        known.insert(known.end(), {"scale", "low", "high"});
    } else if (item.kind == QuestionnaireItem::Kind::number) {
        item.lowest = readNumber(json, "lowest", -1e9, 1e9, 0.0);
        item.highest = readNumber(json, "highest", -1e9, 1e9, 0.0);
        known.insert(known.end(), {"lowest", "highest"});
        if (item.lowest >= item.highest)
            addProblem(json, "highest", QString::number(item.highest), QStringLiteral("more than lowest"));
    } else if (item.kind == QuestionnaireItem::Kind::choice) {
        readChoices(json, item);
        known.push_back("choices");
    }
    refuseUnknownKeys(json, known, QStringLiteral("a key of such a question"));
    return item;
}

} // namespace

void addProblem(const ObjectReader& json, const char* key, const QString& found, const QString& expected) {
    json.problems().push_back({memberPath(json.path(), QLatin1String(key)), found, expected});
}

double readNumber(const ObjectReader& json, const char* key, double lowest, double highest,
                  double otherwise) {
    if (!json.has(QLatin1String(key)))
        return otherwise;
    const double value = json.number(QLatin1String(key));
    if (!(value >= lowest && value <= highest))
        addProblem(json, key, QString::number(value), QStringLiteral("%1 to %2").arg(lowest).arg(highest));
    return value;
}

int readWhole(const ObjectReader& json, const char* key, int lowest, int highest, int otherwise) {
    if (!json.has(QLatin1String(key)))
        return otherwise;
    const int value = json.integer(QLatin1String(key));
    if (value < lowest || value > highest)
        addProblem(json, key, QString::number(value),
                   QStringLiteral("a whole number, %1 to %2").arg(lowest).arg(highest));
    return value;
}

bool readSwitch(const ObjectReader& json, const char* key, bool otherwise) {
    return json.has(QLatin1String(key)) ? json.boolean(QLatin1String(key)) : otherwise;
}

std::string readIdentifier(const ObjectReader& json, const char* key) {
    static const QRegularExpression kIdentifier(QStringLiteral("^[a-z][a-z0-9_]{0,63}$"));
    const std::string id = json.text(QLatin1String(key));
    if (!kIdentifier.match(QString::fromStdString(id)).hasMatch() &&
        json.json()[QLatin1String(key)].isString())
        addProblem(json, key, quoted(QString::fromStdString(id)),
                   QStringLiteral("lower-case letters, digits and _, a letter first, at most 64"));
    return id;
}

StudyText readStudyText(const ObjectReader& json, const char* key, bool required) {
    static const QRegularExpression kLanguage(QStringLiteral("^[a-z]{2,3}(_[A-Z]{2})?$"));
    const QString name = QLatin1String(key);
    if (!required && (!json.has(name) || json.json()[name].toObject().isEmpty()) &&
        (json.json()[name].isObject() || !json.has(name)))
        return {};
    StudyText out = json.translated(name);
    const QString path = memberPath(json.path(), name);
    for (const auto& [language, text] : out) {
        const QString at = memberPath(path, QString::fromStdString(language));
        if (!kLanguage.match(QString::fromStdString(language)).hasMatch())
            json.problems().push_back(
                {at, QStringLiteral("unknown key"), QStringLiteral("a language, such as \"de\"")});
        const qsizetype length = QString::fromStdString(text).size();
        if (length < 1 || length > kLongestText)
            json.problems().push_back({at, QStringLiteral("%1 characters").arg(length),
                                       QStringLiteral("1 to %1").arg(kLongestText)});
    }
    return out;
}

void refuseTwice(const ObjectReader& json, const char* key, const std::string& id,
                 std::vector<std::string>& seen) {
    if (std::find(seen.begin(), seen.end(), id) != seen.end())
        addProblem(json, key, quoted(QString::fromStdString(id)),
                   QStringLiteral("an id that is not given twice"));
    seen.push_back(id);
}

TrialRules readTrialRules(const ObjectReader& json) {
    TrialRules out;
    std::vector<QString> known;
    readNumbers(json, kTrialNumbers, out, known);
    readNumbers(json, kProbe, out, known);
    readWholes(json, kTrialWholes, out, known);
    for (const SwitchKey<TrialRules>& key : kTrialSwitches) {
        known.push_back(QLatin1String(key.name));
        out.*key.member = readSwitch(json, key.name, out.*key.member);
    }
    refuseUnknownKeys(json, known, QStringLiteral("a rule of trials"));
    return out;
}

FidelityLimits readFidelityLimits(const ObjectReader& json) {
    FidelityLimits out;
    std::vector<QString> known;
    readNumbers(json, kFidelityNumbers, out, known);
    readWholes(json, kFidelityWholes, out, known);
    refuseUnknownKeys(json, known, QStringLiteral("a limit of fidelity"));
    return out;
}

Questionnaire readQuestionnaire(const ObjectReader& json) {
    Questionnaire out;
    out.id = readIdentifier(json, "id");
    out.title = readStudyText(json, "title", true);
    out.when = readWord(json, "when", kWhens, Questionnaire::When::after);
    if (json.has("score"))
        out.score = json.text("score");
    refuseUnknownKeys(json, {"id", "title", "when", "score", "items"},
                      QStringLiteral("a key of a questionnaire"));
    std::vector<std::string> seen;
    json.eachObject("items", [&](const ObjectReader& one) {
        out.items.push_back(readItem(one));
        refuseTwice(one, "id", out.items.back().id, seen);
    });
    if (out.items.empty() || out.items.size() > 200)
        addProblem(json, "items", QString::number(out.items.size()), QStringLiteral("1 to 200 questions"));
    if (const std::string fault = psychophysics::scoreFault(out); !fault.empty())
        addProblem(json, "score", quoted(QString::fromStdString(out.score)), QString::fromStdString(fault));
    return out;
}

std::vector<Questionnaire> readQuestionnaires(const ObjectReader& study) {
    std::vector<Questionnaire> out;
    std::vector<std::string> seen;
    study.eachObject("questionnaires", [&](const ObjectReader& one) {
        out.push_back(readQuestionnaire(one));
        refuseTwice(one, "id", out.back().id, seen);
    });
    return out;
}

} // namespace chiron::catalogue
