// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/canonical_json.h"
#include "catalogue/procedure_reader.h"
#include "catalogue/study_json.h"
#include "catalogue/study_parts.h"

#include <QJsonArray>
#include <utility>

namespace chiron::catalogue {

using psychophysics::Condition;
using psychophysics::Questionnaire;
using psychophysics::QuestionnaireItem;
using psychophysics::StimulusDesign;
using psychophysics::StudyDesign;
using psychophysics::StudyText;

namespace {

QString text(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

template <std::size_t n, class Word> QString wordOf(const std::array<const char*, n>& words, Word word) {
    return QLatin1String(words[static_cast<std::size_t>(word)]);
}

QJsonObject textJson(const StudyText& texts) {
    QJsonObject json;
    for (const auto& [language, words] : texts)
        json[text(language)] = text(words);
    return json;
}

QJsonArray numbersJson(const std::vector<double>& numbers) {
    QJsonArray array;
    for (const double number : numbers)
        array.append(number);
    return array;
}

template <class Owner, std::size_t n>
void write(QJsonObject& json, const NumberKey<Owner> (&keys)[n], const Owner& from) {
    for (const NumberKey<Owner>& key : keys)
        json[QLatin1String(key.name)] = from.*key.member;
}
template <class Owner, std::size_t n>
void write(QJsonObject& json, const WholeKey<Owner> (&keys)[n], const Owner& from) {
    for (const WholeKey<Owner>& key : keys)
        json[QLatin1String(key.name)] = from.*key.member;
}
template <class Owner, std::size_t n>
void write(QJsonObject& json, const SwitchKey<Owner> (&keys)[n], const Owner& from) {
    for (const SwitchKey<Owner>& key : keys)
        json[QLatin1String(key.name)] = from.*key.member;
}

QJsonObject stimulusJson(const StimulusDesign& stimulus) {
    QJsonObject fixed;
    for (const auto& [key, value] : stimulus.fixed)
        fixed[text(key)] = value;
    return {{"attribute", text(psychophysics::token(stimulus.attribute))},
            {"reference", stimulus.reference},
            {"differences", numbersJson(stimulus.differences)},
            {"fixed", fixed}};
}

QJsonObject conditionJson(const Condition& condition) {
    QJsonArray procedures;
    for (const psychophysics::ProcedureSpec& spec : condition.procedures)
        procedures.append(writeProcedure(spec));
    QJsonObject json{{"id", text(condition.id)},
                     {"title", textJson(condition.title)},
                     {"stimulus", stimulusJson(condition.stimulus)},
                     {"task", text(psychophysics::token(condition.task))},
                     {"scale", wordOf(kScales, condition.scale)},
                     {"criterion", condition.criterion},
                     {"procedures", procedures}};
    if (!condition.instructions.empty()) // designs without instructions keep their digest
        json["instructions"] = textJson(condition.instructions);
    return json;
}

QJsonObject itemJson(const QuestionnaireItem& item) {
    QJsonObject json{{"id", text(item.id)},
                     {"text", textJson(item.text)},
                     {"kind", wordOf(kItemKinds, item.kind)},
                     {"construct", text(item.construct)},
                     {"required", item.required}};
    if (item.kind == QuestionnaireItem::Kind::likert) {
        json["scale"] = item.scale;
        if (!item.low.empty())
            json["low"] = textJson(item.low);
        if (!item.high.empty())
            json["high"] = textJson(item.high);
    } else if (item.kind == QuestionnaireItem::Kind::number) {
        json["lowest"] = item.lowest;
        json["highest"] = item.highest;
    } else if (item.kind == QuestionnaireItem::Kind::choice) {
        QJsonArray choices;
        for (const StudyText& choice : item.choices)
            choices.append(textJson(choice));
        json["choices"] = choices;
    }
    return json;
}

QJsonObject questionnaireJson(const Questionnaire& questionnaire) {
    QJsonArray items;
    for (const QuestionnaireItem& item : questionnaire.items)
        items.append(itemJson(item));
    QJsonObject json{{"id", text(questionnaire.id)},
                     {"title", textJson(questionnaire.title)},
                     {"when", wordOf(kWhens, questionnaire.when)},
                     {"items", items}};
    if (!questionnaire.score.empty()) // designs without a score keep their digest
        json["score"] = text(questionnaire.score);
    return json;
}

} // namespace

QByteArray studyJson(const StudyDesign& design) {
    QJsonArray conditions;
    for (const Condition& condition : design.conditions)
        conditions.append(conditionJson(condition));
    QJsonArray questionnaires;
    for (const Questionnaire& questionnaire : design.questionnaires)
        questionnaires.append(questionnaireJson(questionnaire));
    QJsonObject trial;
    write(trial, kTrialNumbers, design.trial);
    write(trial, kTrialWholes, design.trial);
    write(trial, kTrialSwitches, design.trial);
    if (design.trial.probeAtLeast_N > 0.0)
        write(trial, kProbe, design.trial);
    QJsonObject fidelity;
    write(fidelity, kFidelityNumbers, design.fidelity);
    write(fidelity, kFidelityWholes, design.fidelity);
    QJsonObject json{{"id", text(design.id)},
                     {"title", textJson(design.title)},
                     {"objective", textJson(design.objective)},
                     {"instructions", textJson(design.instructions)},
                     {"consent", textJson(design.consent)},
                     {"conditions", conditions},
                     {"order", wordOf(kOrders, design.order)},
                     {"trial", trial},
                     {"fidelity", fidelity},
                     {"questionnaires", questionnaires},
                     {"participants_planned", design.participantsPlanned},
                     {"blind_participant", design.blindParticipant},
                     {"blind_experimenter", design.blindExperimenter},
                     {"seed", static_cast<double>(design.seed)}};
    // These keys are written only if they hold something. Designs of earlier versions lack them and so keep
    // their bytes and their SHA-256.
    if (design.ownInstructions)
        json["own_instructions"] = textJson(*design.ownInstructions);
    for (const auto& [key, words] : {std::pair{"source", &design.source}, std::pair{"ethics", &design.ethics},
                                     std::pair{"pilot_of", &design.pilotOf}})
        if (!words->empty())
            json[QLatin1String(key)] = text(*words);
    return QByteArray::fromStdString(canonicalJson(json));
}

} // namespace chiron::catalogue
