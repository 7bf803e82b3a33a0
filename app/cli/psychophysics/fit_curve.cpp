// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/psychophysics/fit_data.h"
#include "cli/psychophysics/handlers.h"
#include "cli/text_table.h"
#include "psychophysics/fits/fit.h"

#include <QJsonArray>
#include <QJsonObject>
#include <cmath>

namespace chiron::cli {

namespace {

using namespace psychophysics;

/// Draws from the posterior, for the interval of a threshold at another proportion.
constexpr int kDrawsOfDerived = 2000;

QString text(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

core::Result<void> readSimulations(const Arguments& arguments, FitOptions& options) {
    constexpr qint64 kMost = 1'000'000;
    const auto bootstrap = arguments.integer(QStringLiteral("bootstrap"), 0, kMost, 0);
    const auto monteCarlo = arguments.integer(QStringLiteral("monte-carlo"), 0, kMost, 0);
    const auto curve = arguments.integer(QStringLiteral("curve"), 0, 10'000, 0);
    const auto confidence = arguments.number(QStringLiteral("confidence"), 0.5, 0.999, 0.95);
    const auto seed = arguments.seed(QStringLiteral("seed"), 1);
    for (const auto* whole : {&bootstrap, &monteCarlo, &curve})
        CHIRON_TRY(*whole);
    CHIRON_TRY(confidence);
    CHIRON_TRY(seed);
    if (*bootstrap > 0) {
        options.bootstrap =
            arguments.has(QStringLiteral("nonparametric")) ? Bootstrap::nonparametric : Bootstrap::parametric;
        options.bootstrapSamples = static_cast<int>(*bootstrap);
    }
    options.monteCarlo = static_cast<int>(*monteCarlo);
    options.curvePoints = static_cast<int>(*curve);
    options.confidence = *confidence;
    options.seed = *seed;
    return {};
}

core::Result<FitOptions> readOptions(const Arguments& arguments) {
    auto read = readCurve(arguments);
    CHIRON_TRY(read);
    FitOptions options = *read;
    const auto prior =
        arguments.choice(QStringLiteral("prior"), {"auto", "psignifit", "open_below", "open_above", "wide"},
                         QStringLiteral("auto"));
    CHIRON_TRY(prior);
    options.widthPrior = *widthPriorFromToken(prior->toStdString());
    CHIRON_TRY(readSimulations(arguments, options));
    if (arguments.has(QStringLiteral("threshold-at")))
        options.draws = kDrawsOfDerived;
    return options;
}

QJsonArray pair(const FitInterval& interval) {
    return {interval.low, interval.high};
}

QJsonObject intervals(const ParameterIntervals& ci) {
    return {{"threshold", pair(ci.threshold)},
            {"width", pair(ci.width)},
            {"lapse", pair(ci.lapse)},
            {"guess", pair(ci.guess)},
            {"eta", pair(ci.eta)}};
}

QJsonObject parameters(const CurveParameters& at, StimulusScale scale) {
    return {{"threshold", fromScale(at.threshold, scale)},
            {"width", at.width},
            {"lapse", at.lapse},
            {"guess", at.guess},
            {"eta", at.eta}};
}

/// Standard errors, or the posterior's standard deviations for a Bayesian fit. All are on the fitted axis.
QJsonObject parameterErrors(const FitResult& fit) {
    return {{"threshold", fit.error.threshold},
            {"width", fit.error.width},
            {"lapse", fit.error.lapse},
            {"guess", fit.error.guess},
            {"eta", fit.error.eta}};
}

/// The ratio of the posterior's spread to the prior's; null if a parameter is fixed.
QJsonObject influenceJson(const CurveParameters& of) {
    return {{"threshold", of.threshold},
            {"width", of.width},
            {"lapse", of.lapse},
            {"guess", of.guess},
            {"eta", of.eta}};
}

QJsonArray levelsJson(const FitResult& fit) {
    QJsonArray levels;
    for (const FittedLevel& level : fit.levels)
        levels.append(QJsonObject{{"intensity", level.x},
                                  {"n_correct", level.right},
                                  {"n_total", level.of},
                                  {"fitted", level.fitted},
                                  {"residual", level.residual}});
    return levels;
}

QJsonObject fitJson(const FitResult& fit) {
    QJsonArray warnings;
    for (const std::string& warning : fit.warnings)
        warnings.append(text(warning));
    QJsonObject json{{"fitted", fit.fitted},
                     {"function", text(token(fit.function))},
                     {"method", fit.method == FitMethod::bayesian ? "bayes" : "ml"},
                     {"scale", text(token(fit.scale))},
                     {"threshold", fit.threshold},
                     {"width", fit.width},
                     {"lapse", fit.lapse},
                     {"guess", fit.guess},
                     {"eta", fit.eta},
                     {"confidence", fit.confidence},
                     {"ci", intervals(fit.ci)},
                     {"deviance", fit.deviance},
                     {"degrees_of_freedom", fit.degreesOfFreedom},
                     {"p_value", fit.pValue},
                     {"error", parameterErrors(fit)},
                     {"log_likelihood", fit.logLikelihood},
                     {"aic", fit.aic},
                     {"levels", levelsJson(fit)},
                     {"warnings", warnings}};
    if (fit.method == FitMethod::bayesian) {
        json.insert("mean", parameters(fit.mean, fit.scale));
        json.insert("interval_prior", QLatin1String(widthPriorToken(fit.intervalPrior)));
        json.insert("prior_influence", influenceJson(fit.priorInfluence));
    }
    if (!fit.curve.empty()) {
        QJsonArray curve;
        for (const CurveSample& sample : fit.curve)
            curve.append(QJsonObject{{"intensity", sample.x},
                                     {"fitted", sample.fitted},
                                     {"low", sample.low},
                                     {"high", sample.high}});
        json.insert("curve", curve);
    }
    return json;
}

void warn(QJsonObject& json, const QString& warning) {
    QJsonArray warnings = json["warnings"].toArray();
    warnings.append(warning);
    json.insert("warnings", warnings);
}

/// Adds the derived values that were requested: the threshold at another proportion, and PSE, JND and Weber
/// fraction at a reference.
core::Result<void> addDerived(const Arguments& arguments, const FitResult& fit, QJsonObject& json) {
    const bool unscaled = arguments.has(QStringLiteral("unscaled"));
    if (arguments.has(QStringLiteral("threshold-at"))) {
        const auto proportion = arguments.number(QStringLiteral("threshold-at"), 0.001, 0.999, 0.75);
        CHIRON_TRY(proportion);
        const double p = *proportion;
        const FitInterval interval =
            intervalOf(fit, [&](const CurveParameters& at) { return thresholdAt(fit, at, p, unscaled); });
        if (const double value = thresholdAt(fit, p, unscaled); fit.fitted && std::isnan(value))
            warn(json, QStringLiteral(
                           "never_reached: the curve does not take the proportion %1 (guess %2, lapse %3)")
                           .arg(p)
                           .arg(fit.guess)
                           .arg(fit.lapse));
        json.insert("threshold_at", QJsonObject{{"proportion", p},
                                                {"unscaled", unscaled},
                                                {"value", thresholdAt(fit, p, unscaled)},
                                                {"ci", pair(interval)}});
    }
    json.insert("pse", pse(fit));
    json.insert("jnd", jnd(fit));
    if (arguments.has(QStringLiteral("reference"))) {
        const auto reference = arguments.number(QStringLiteral("reference"), -1e12, 1e12, 0.0);
        CHIRON_TRY(reference);
        json.insert("reference", *reference);
        if (*reference == 0.0)
            warn(json, QStringLiteral("no_reference: a Weber fraction at 0 has no value"));
        json.insert("weber", weberFraction(fit, *reference));
    }
    return {};
}

/// The requested derived values, one line or table each.
QString derivedText(const QJsonObject& json) {
    const auto shown = [](const QJsonValue& value) { return shortNumber(value.toDouble(std::nan(""))); };
    QString words;
    if (json.contains("threshold_at")) {
        const QJsonObject at = json["threshold_at"].toObject();
        const QJsonArray ci = at["ci"].toArray();
        words += QStringLiteral("threshold at %1%2: %3 (%4 to %5)\n")
                     .arg(shown(at["proportion"]),
                          at["unscaled"].toBool() ? QStringLiteral(" of the curve without guess and lapse")
                                                  : QString(),
                          shown(at["value"]), shown(ci[0]), shown(ci[1]));
    }
    if (json.contains("weber"))
        words +=
            QStringLiteral("Weber fraction at %1: %2\n").arg(shown(json["reference"]), shown(json["weber"]));
    if (json.contains("curve")) {
        TextTable table({">intensity", ">fitted", ">low", ">high"});
        for (const QJsonValue& sample : json["curve"].toArray())
            table.add({shown(sample["intensity"]), shown(sample["fitted"]), shown(sample["low"]),
                       shown(sample["high"])});
        words += table.toText();
    }
    return words;
}

QString fitText(const QJsonObject& json) {
    const bool bayes = json.contains("prior_influence");
    QStringList headings{"parameter", ">value", ">low", ">high"};
    if (bayes)
        headings << QStringLiteral(">prior's part");
    TextTable table(headings);
    for (const char* name : {"threshold", "width", "lapse", "guess", "eta"}) {
        const QJsonArray ci = json["ci"][QLatin1String(name)].toArray();
        const auto shown = [](const QJsonValue& value) { return shortNumber(value.toDouble(std::nan(""))); };
        QStringList row{name, shown(json[QLatin1String(name)]), shown(ci[0]), shown(ci[1])};
        if (bayes)
            row << shown(json["prior_influence"][QLatin1String(name)]);
        table.add(row);
    }
    const auto number = [&](const char* key) {
        return shortNumber(json[QLatin1String(key)].toDouble(std::nan("")));
    };
    QString words = QStringLiteral("%1, %2, fitted on a %3 axis, %4 % intervals\n")
                        .arg(json["function"].toString(), json["method"].toString(), json["scale"].toString())
                        .arg(100.0 * json["confidence"].toDouble());
    words += table.toText();
    if (bayes)
        words += QStringLiteral("prior's part: spread after the answers over spread before them, 0 the "
                                "answers decide, 1 the prior does; intervals of the %1 prior\n")
                     .arg(json["interval_prior"].toString());
    words += QStringLiteral("deviance %1 (p %2), log-likelihood %3\nPSE %4, JND %5\n")
                 .arg(number("deviance"), number("p_value"), number("log_likelihood"), number("pse"),
                      number("jnd"));
    words += derivedText(json);
    for (const QJsonValue& warning : json["warnings"].toArray())
        words += QStringLiteral("! %1\n").arg(warning.toString());
    return words;
}

/// The JSON of the fit of one group.
core::Result<QJsonObject> fitOf(const Arguments& arguments, bool likelihood, const AnswersOf& answers,
                                const FitOptions& options) {
    FitResult fit =
        likelihood ? fitMaximumLikelihood(answers.data, options) : fitBayesian(answers.data, options);
    for (std::string& warning : fit.warnings)
        if (warning.starts_with("unusable_rows"))
            warning += " (" + answers.leftOut.toStdString() + ")";
    if (fit.fitted && likelihood && options.bootstrap == Bootstrap::none &&
        (options.curvePoints > 1 || arguments.has(QStringLiteral("threshold-at"))))
        fit.warnings.emplace_back("no_interval: a curve and a threshold at another proportion have intervals "
                                  "with --bootstrap only, by this method");
    QJsonObject json = fitJson(fit);
    CHIRON_TRY(addDerived(arguments, fit, json));
    return json;
}

/// A table with one row per group, followed by the warnings of each group.
QString groupsText(const QStringList& by, const QJsonArray& groups) {
    QStringList headings = by;
    headings << ">threshold"
             << ">low"
             << ">high"
             << ">width"
             << ">low"
             << ">high"
             << ">lapse"
             << ">p"
             << ">warnings";
    TextTable table(headings);
    QString words;
    const auto shown = [](const QJsonValue& value) { return shortNumber(value.toDouble(std::nan(""))); };
    for (const QJsonValue& value : groups) {
        const QJsonObject group = value.toObject(), ci = group["ci"].toObject();
        QStringList row;
        for (const QString& column : by)
            row << group["group"][column].toString();
        const QString name = row.join(QStringLiteral(", "));
        for (const char* parameter : {"threshold", "width"})
            row << shown(group[QLatin1String(parameter)]) << shown(ci[QLatin1String(parameter)][0])
                << shown(ci[QLatin1String(parameter)][1]);
        const QJsonArray warnings = group["warnings"].toArray();
        table.add(row << shown(group["lapse"]) << shown(group["p_value"])
                      << QString::number(warnings.size()));
        for (const QJsonValue& warning : warnings)
            words += QStringLiteral("! %1: %2\n").arg(name, warning.toString());
    }
    return table.toText() + words;
}

} // namespace

core::Result<CommandOutput> fitCurve(const Arguments& arguments) {
    const auto method = arguments.choice(QStringLiteral("method"), {"bayes", "ml"}, QStringLiteral("bayes"));
    CHIRON_TRY(method);
    const auto options = readOptions(arguments);
    CHIRON_TRY(options);
    if (*method == u"ml" && arguments.has(QStringLiteral("prior")))
        return wrongUse(QStringLiteral("--prior: expected with --method bayes; maximum likelihood has none"));
    if (*method == u"bayes" && options->bootstrap != Bootstrap::none)
        return wrongUse(
            QStringLiteral("--bootstrap: expected with --method ml; a Bayesian fit has credible intervals"));
    const auto answers = readAnswers(arguments);
    CHIRON_TRY(answers);
    QJsonArray groups;
    for (const AnswersOf& group : answers->groups) {
        auto json = fitOf(arguments, *method == u"ml", group, *options);
        CHIRON_TRY(json);
        if (answers->by.isEmpty())
            return CommandOutput{QJsonDocument(*json), fitText(*json), 0};
        json->insert("group", groupJson(answers->by, group.group));
        groups.append(*json);
    }
    return CommandOutput{
        QJsonDocument(QJsonObject{{"by", QJsonArray::fromStringList(answers->by)}, {"groups", groups}}),
        groupsText(answers->by, groups), 0};
}

} // namespace chiron::cli
