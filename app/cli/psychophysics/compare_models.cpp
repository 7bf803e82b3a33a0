// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/psychophysics/fit_data.h"
#include "cli/psychophysics/handlers.h"
#include "cli/text_table.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/fits/model_comparison.h"

#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

namespace chiron::cli {

namespace {

using namespace psychophysics;

constexpr std::size_t kMostCompared = 50; ///< because one of the models has the parameters of all groups

core::Result<SharedParameters> readParameters(const Arguments& arguments, const QString& option,
                                              const QString& fallback) {
    const auto list = arguments.has(option)
                          ? arguments.list(option)
                          : core::Result<QStringList>(fallback.split(u',', Qt::SkipEmptyParts));
    CHIRON_TRY(list);
    SharedParameters shared;
    for (const QString& word : *list) {
        bool* at = word == u"threshold" ? &shared.threshold
                   : word == u"width"   ? &shared.width
                   : word == u"lapse"   ? &shared.lapse
                   : word == u"guess"   ? &shared.guess
                                        : nullptr;
        if (at)
            *at = true;
        else if (word != u"none" || list->size() > 1)
            return wrongUse(QStringLiteral("--%1: %2: expected threshold, width, lapse, guess%3")
                                .arg(option, quoted(word),
                                     option == u"shared" ? QStringLiteral(", or none") : QString()));
    }
    return shared;
}

QJsonArray namesOf(const SharedParameters& shared) {
    QJsonArray names;
    for (const auto& [name, is] : {std::pair("threshold", shared.threshold), std::pair("width", shared.width),
                                   std::pair("lapse", shared.lapse), std::pair("guess", shared.guess)})
        if (is)
            names.append(name);
    return names;
}

/// Refuses to test a fixed parameter, because it is the same in all groups.
core::Result<void> check(const FitOptions& options, const SharedParameters& tested) {
    const auto fixed = [](const Asymptote& of) { return of.rule == Asymptote::Rule::fixed; };
    if (tested.lapse && fixed(options.lapse))
        return wrongUse(
            QStringLiteral("--test lapse: expected --lapse free; a lapse that is given is everybody's"));
    if (tested.guess && options.guess.rule != Asymptote::Rule::free)
        return wrongUse(QStringLiteral("--test guess: expected --guess free; a guess that is given, or that "
                                       "is the lapse, is not fitted by itself"));
    if (!tested.threshold && !tested.width && !tested.lapse && !tested.guess)
        return wrongUse(QStringLiteral("--test: expected at least one of threshold, width, lapse, guess"));
    return {};
}

QJsonObject curveJson(const CurveParameters& at, StimulusScale scale) {
    return {{"threshold", fromScale(at.threshold, scale)},
            {"width", at.width},
            {"lapse", at.lapse},
            {"guess", at.guess}};
}

QJsonObject modelJson(const ConditionsFit& fit) {
    return {{"fitted", fit.fitted},
            {"log_likelihood", fit.logLikelihood},
            {"free_parameters", fit.freeParameters},
            {"aic", fit.aic}};
}

QJsonObject testJson(const ModelComparison& of) {
    QJsonObject json{{"likelihood_ratio", of.likelihoodRatio},
                     {"degrees_of_freedom", of.freedom},
                     {"p_value", of.pValue},
                     {"p_chi_square", of.chiSquareP},
                     {"aic_difference", of.aicDifference}};
    if (of.simulated > 0)
        json.insert("simulated", of.simulated);
    return json;
}

/// Compares every two groups, with Holm's correction over all of these tests.
QJsonArray pairsJson(const AnswerTable& answers, const FitOptions& options, const SharedParameters& shared,
                     const SharedParameters& tested) {
    struct Pair {
        std::size_t first, second;
        ModelComparison models;
        double holm = kNotKnown;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < answers.groups.size(); ++i)
        for (std::size_t j = i + 1; j < answers.groups.size(); ++j)
            pairs.push_back({i, j,
                             compareConditions({answers.groups[i].data, answers.groups[j].data}, options,
                                               shared, tested)});
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (std::isfinite(pairs[i].models.pValue))
            order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return pairs[a].models.pValue < pairs[b].models.pValue;
    });
    double largest = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i)
        pairs[order[i]].holm = largest = std::max(
            largest, std::min(1.0, pairs[order[i]].models.pValue * static_cast<double>(order.size() - i)));
    QJsonArray json;
    for (const Pair& pair : pairs) {
        QJsonObject one = testJson(pair.models);
        one.insert("group_a", groupJson(answers.by, answers.groups[pair.first].group));
        one.insert("group_b", groupJson(answers.by, answers.groups[pair.second].group));
        one.insert("p_holm", pair.holm);
        json.append(one);
    }
    return json;
}

QString nameOf(const QJsonObject& group) {
    QStringList values;
    for (const QJsonValue& value : group)
        values << value.toString();
    return values.join(QStringLiteral(", "));
}

QString shown(const QJsonValue& value) {
    return shortNumber(value.toDouble(std::nan("")));
}

QString wordsOf(const QJsonArray& names) {
    QStringList words;
    for (const QJsonValue& name : names)
        words << name.toString();
    return words.isEmpty() ? QStringLiteral("nothing") : words.join(QStringLiteral(", "));
}

QString comparisonText(const QJsonObject& json) {
    QString words = QStringLiteral("Do the groups differ in %1? In both models %2 in common.\n")
                        .arg(wordsOf(json["tested"].toArray()),
                             json["shared"].toArray().isEmpty()
                                 ? QStringLiteral("they have nothing")
                                 : QStringLiteral("they have ") + wordsOf(json["shared"].toArray()));
    TextTable table(
        {"group", ">threshold alike", ">width alike", ">threshold own", ">width own", ">lapse own"});
    for (const QJsonValue& value : json["groups"].toArray()) {
        const QJsonValue alike = value["smaller"], own = value["larger"];
        table.add({nameOf(value["group"].toObject()), shown(alike["threshold"]), shown(alike["width"]),
                   shown(own["threshold"]), shown(own["width"]), shown(own["lapse"])});
    }
    words += table.toText();
    words +=
        QStringLiteral(
            "2 ln L ratio %1, degrees of freedom %2, p %3 (%4), AIC difference %5 (above 0: they differ)\n")
            .arg(shown(json["likelihood_ratio"]))
            .arg(json["degrees_of_freedom"].toInt())
            .arg(shown(json["p_value"]),
                 json.contains("simulated") ? QStringLiteral("of %1 simulated").arg(json["simulated"].toInt())
                                            : QStringLiteral("chi-square"),
                 shown(json["aic_difference"]));
    if (json.contains("pairs")) {
        TextTable pairs({"group A", "group B", ">2 ln L ratio", ">p", ">p (Holm)", ">AIC difference"});
        for (const QJsonValue& value : json["pairs"].toArray())
            pairs.add({nameOf(value["group_a"].toObject()), nameOf(value["group_b"].toObject()),
                       shown(value["likelihood_ratio"]), shown(value["p_value"]), shown(value["p_holm"]),
                       shown(value["aic_difference"])});
        words += pairs.toText();
    }
    for (const QJsonValue& warning : json["warnings"].toArray())
        words += QStringLiteral("! %1\n").arg(warning.toString());
    return words;
}

/// The models' warnings name conditions by number; here they get the names of the groups.
QJsonArray warningsOf(const ModelComparison& of, const AnswerTable& answers) {
    QJsonArray warnings;
    for (const std::string& warning : of.larger.warnings) {
        QString words = QString::fromStdString(warning);
        for (std::size_t i = answers.groups.size(); i-- > 0;)
            words.replace(QStringLiteral("condition %1 has").arg(i + 1),
                          QStringLiteral("group %1 has")
                              .arg(quoted(answers.groups[i].group.join(QStringLiteral(", ")))));
        warnings.append(words);
    }
    for (const AnswersOf& group : answers.groups)
        if (!group.leftOut.isEmpty())
            warnings.append(QStringLiteral("unusable_rows: rows were left out (%1)").arg(group.leftOut));
    return warnings;
}

} // namespace

core::Result<CommandOutput> compareModels(const Arguments& arguments) {
    auto options = readCurve(arguments);
    const auto tested = readParameters(arguments, QStringLiteral("test"), QStringLiteral("threshold"));
    const auto shared = readParameters(arguments, QStringLiteral("shared"), QStringLiteral("lapse,guess"));
    const auto monteCarlo = arguments.integer(QStringLiteral("monte-carlo"), 0, 100'000, 0);
    const auto seed = arguments.seed(QStringLiteral("seed"), 1);
    CHIRON_TRY(options);
    CHIRON_TRY(tested);
    CHIRON_TRY(shared);
    CHIRON_TRY(monteCarlo);
    CHIRON_TRY(seed);
    CHIRON_TRY(check(*options, *tested));
    options->monteCarlo = static_cast<int>(*monteCarlo);
    options->seed = *seed;
    options->scale = options->scale.value_or(ownScale(options->function));
    const auto answers = readAnswers(arguments);
    CHIRON_TRY(answers);
    if (answers->groups.size() < 2 || answers->groups.size() > kMostCompared)
        return badInput(QStringLiteral("%1: %2 groups by %3; expected 2 to %4")
                            .arg(arguments.operand(0))
                            .arg(answers->groups.size())
                            .arg(answers->by.join(u','))
                            .arg(kMostCompared));
    std::vector<PsychometricData> data;
    for (const AnswersOf& group : answers->groups)
        data.push_back(group.data);
    const SharedParameters common{shared->threshold && !tested->threshold, shared->width && !tested->width,
                                  shared->lapse && !tested->lapse, shared->guess && !tested->guess};
    const ModelComparison models = compareConditions(data, *options, common, *tested);
    QJsonArray groups;
    for (std::size_t i = 0; i < data.size(); ++i) {
        QJsonObject group{{"group", groupJson(answers->by, answers->groups[i].group)}};
        group.insert("smaller", models.smaller.fitted
                                    ? curveJson(models.smaller.conditions[i], *options->scale)
                                    : QJsonValue());
        group.insert("larger", models.larger.fitted ? curveJson(models.larger.conditions[i], *options->scale)
                                                    : QJsonValue());
        groups.append(group);
    }
    QJsonObject json = testJson(models);
    json.insert("by", QJsonArray::fromStringList(answers->by));
    json.insert("tested", namesOf(*tested));
    json.insert("shared", namesOf(common));
    json.insert("scale", QString::fromStdString(std::string(token(*options->scale))));
    json.insert("function", QString::fromStdString(std::string(token(options->function))));
    json.insert("smaller", modelJson(models.smaller));
    json.insert("larger", modelJson(models.larger));
    json.insert("groups", groups);
    json.insert("warnings", warningsOf(models, *answers));
    if (data.size() > 2)
        json.insert("pairs", pairsJson(*answers, *options, common, *tested));
    return CommandOutput{QJsonDocument(json), comparisonText(json), 0};
}

} // namespace chiron::cli
