// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/csv_table.h"
#include "cli/messages.h"
#include "cli/psychophysics/handlers.h"
#include "cli/text_table.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/fits/prepared_levels.h"

#include <QJsonArray>
#include <QJsonObject>
#include <cmath>

namespace chiron::cli {

namespace {

using namespace psychophysics;

constexpr int kDrawsOfDerived = 2000; ///< of the posterior, for the interval of a threshold at another proportion

QString text(std::string_view words) { return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size())); }

QStringList sigmoidNames() {
    QStringList names;
    for (int i = 0; i < kSigmoids; ++i)
        names << text(token(static_cast<Sigmoid>(i)));
    return names;
}

struct ReadLevels {
    PsychometricData data;
    QString leftOut; ///< where the rows are that cannot be used; empty: all can
};

/// "DATA.csv: lines 3, 7": a few of them, since a column of another kind makes all of them so.
QString placesOf(const CsvTable& table, const std::vector<std::size_t>& rows) {
    constexpr std::size_t kMostNamed = 5;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(rows.size(), kMostNamed); ++i)
        lines << QString::number(table.lines[rows[i]]);
    return rows.empty() ? QString()
                        : QStringLiteral("%1: %2 %3%4").arg(table.name, rows.size() == 1 ? QStringLiteral("line") : QStringLiteral("lines"), lines.join(QStringLiteral(", ")),
                                                           rows.size() > kMostNamed ? QStringLiteral(" ...") : QString());
}

core::Result<ReadLevels> readLevels(const QString& path) {
    const auto table = readCsvTable(path);
    if (!table)
        return tl::unexpected(table.error());
    std::array<int, 3> columns{};
    const std::array<QString, 3> names{QStringLiteral("intensity"), QStringLiteral("n_correct"), QStringLiteral("n_total")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        columns[i] = table->column(names[i]);
        if (columns[i] < 0)
            return badInput(QStringLiteral("%1:1: column %2 is missing; expected intensity,n_correct,n_total").arg(path, names[i]));
    }
    ReadLevels read;
    double trials = 0.0;
    std::vector<std::size_t> unusable;
    for (std::size_t row = 0; row < table->rows.size(); ++row) {
        std::array<double, 3> values{};
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto value = table->number(row, columns[i]);
            if (!value)
                return tl::unexpected(value.error());
            values[i] = *value;
        }
        constexpr double kMostTrials = 1e9; // of a level: beyond, a posterior is narrower than any grid
        if (std::isfinite(values[2]) && values[2] > kMostTrials)
            return table->fault(row, columns[2], QStringLiteral("at most 1e9"));
        trials += values[2] > 0.0 ? values[2] : 0.0;
        if (trials > kMostTrials) // of all levels together, or the grid takes all memory
            return table->fault(row, columns[2], QStringLiteral("at most 1e9 of all rows together"));
        read.data.x.push_back(values[0]);
        read.data.k.push_back(values[1]);
        read.data.n.push_back(values[2]);
        if (!isUsableRow(values[0], values[1], values[2]))
            unusable.push_back(row);
    }
    read.leftOut = placesOf(*table, unusable);
    return read;
}

/// A proportion, "free", or (where `equal` may be) "equal".
core::Result<Asymptote> asymptote(const Arguments& arguments, const QString& option, bool equal, Asymptote fallback) {
    if (!arguments.has(option))
        return fallback;
    const QString given = arguments.value(option);
    if (given == u"free")
        return Asymptote::fitted();
    if (equal && given == u"equal")
        return Asymptote::equalToLapse();
    bool ok = false;
    const double value = given.toDouble(&ok);
    if (!ok || !(value >= 0.0 && value < 1.0))
        return wrongUse(QStringLiteral("--%1: %2: expected a proportion from 0 to below 1%3 or free")
                            .arg(option, quoted(given), equal ? QStringLiteral(", equal") : QString()));
    return Asymptote::fixedAt(value);
}

core::Result<void> readSimulations(const Arguments& arguments, FitOptions& options) {
    constexpr qint64 kMost = 1'000'000;
    const auto bootstrap = arguments.integer(QStringLiteral("bootstrap"), 0, kMost, 0);
    const auto monteCarlo = arguments.integer(QStringLiteral("monte-carlo"), 0, kMost, 0);
    const auto curve = arguments.integer(QStringLiteral("curve"), 0, 10'000, 0);
    const auto confidence = arguments.number(QStringLiteral("confidence"), 0.5, 0.999, 0.95);
    const auto seed = arguments.seed(QStringLiteral("seed"), 1);
    for (const auto* whole : {&bootstrap, &monteCarlo, &curve})
        if (!*whole)
            return tl::unexpected(whole->error());
    if (!confidence || !seed)
        return tl::unexpected(confidence ? seed.error() : confidence.error());
    if (*bootstrap > 0) {
        options.bootstrap = arguments.has(QStringLiteral("nonparametric")) ? Bootstrap::nonparametric : Bootstrap::parametric;
        options.bootstrapSamples = static_cast<int>(*bootstrap);
    }
    options.monteCarlo = static_cast<int>(*monteCarlo);
    options.curvePoints = static_cast<int>(*curve);
    options.confidence = *confidence;
    options.seed = *seed;
    return {};
}

core::Result<FitOptions> readOptions(const Arguments& arguments) {
    FitOptions options;
    const auto function = arguments.choice(QStringLiteral("function"), sigmoidNames(), QStringLiteral("gauss"));
    const auto scale = arguments.choice(QStringLiteral("scale"), {"linear", "ln", "log10", "db"}, {});
    if (!function || !scale)
        return tl::unexpected(function ? scale.error() : function.error());
    options.function = *sigmoidFromToken(function->toStdString());
    const auto prior = arguments.choice(QStringLiteral("prior"), {"auto", "psignifit", "wide"}, QStringLiteral("auto"));
    if (!prior)
        return tl::unexpected(prior.error());
    options.widthPrior = *prior == u"wide" ? WidthPrior::wide : *prior == u"psignifit" ? WidthPrior::psignifit : WidthPrior::automatic;
    if (!scale->isEmpty())
        options.scale = stimulusScaleFromToken(scale->toStdString());
    const auto guess = asymptote(arguments, QStringLiteral("guess"), true, Asymptote::fixedAt(0.5));
    const auto lapse = asymptote(arguments, QStringLiteral("lapse"), false, Asymptote::fitted());
    if (!guess || !lapse)
        return tl::unexpected(guess ? lapse.error() : guess.error());
    options.guess = *guess;
    options.lapse = *lapse;
    if (guess->rule == Asymptote::Rule::equal && lapse->rule == Asymptote::Rule::fixed && !(lapse->value < 0.5))
        return wrongUse(QStringLiteral("--guess equal, --lapse %1: expected a lapse below 0.5, which both are").arg(lapse->value));
    const bool bothFixed = guess->rule == Asymptote::Rule::fixed && lapse->rule == Asymptote::Rule::fixed;
    if (bothFixed && !(guess->value + lapse->value < 1.0))
        return wrongUse(QStringLiteral("--guess %1, --lapse %2: expected less than 1 together").arg(guess->value).arg(lapse->value));
    if (auto read = readSimulations(arguments, options); !read)
        return tl::unexpected(read.error());
    if (arguments.has(QStringLiteral("threshold-at")))
        options.draws = kDrawsOfDerived;
    return options;
}

QJsonArray pair(const FitInterval& interval) { return {interval.low, interval.high}; }

QJsonObject intervals(const ParameterIntervals& ci) {
    return {{"threshold", pair(ci.threshold)}, {"width", pair(ci.width)}, {"lapse", pair(ci.lapse)}, {"guess", pair(ci.guess)}, {"eta", pair(ci.eta)}};
}

QJsonObject parameters(const CurveParameters& at, StimulusScale scale) {
    return {{"threshold", fromScale(at.threshold, scale)}, {"width", at.width}, {"lapse", at.lapse}, {"guess", at.guess}, {"eta", at.eta}};
}

/// Standard errors; of the posterior its standard deviations. All on the fitted axis.
QJsonObject parameterErrors(const FitResult& fit) {
    return {{"threshold", fit.error.threshold}, {"width", fit.error.width}, {"lapse", fit.error.lapse}, {"guess", fit.error.guess}, {"eta", fit.error.eta}};
}

/// The posterior's spread over the prior's; null where a parameter is fixed.
QJsonObject influenceJson(const CurveParameters& of) {
    return {{"threshold", of.threshold}, {"width", of.width}, {"lapse", of.lapse}, {"guess", of.guess}, {"eta", of.eta}};
}

QJsonArray levelsJson(const FitResult& fit) {
    QJsonArray levels;
    for (const FittedLevel& level : fit.levels)
        levels.append(QJsonObject{{"intensity", level.x}, {"n_correct", level.right}, {"n_total", level.of}, {"fitted", level.fitted}, {"residual", level.residual}});
    return levels;
}

QJsonObject fitJson(const FitResult& fit) {
    QJsonArray warnings;
    for (const std::string& warning : fit.warnings)
        warnings.append(text(warning));
    QJsonObject json{{"fitted", fit.fitted}, {"function", text(token(fit.function))}, {"method", fit.method == FitMethod::bayesian ? "bayes" : "ml"},
                     {"scale", text(token(fit.scale))}, {"threshold", fit.threshold}, {"width", fit.width}, {"lapse", fit.lapse},
                     {"guess", fit.guess}, {"eta", fit.eta}, {"confidence", fit.confidence}, {"ci", intervals(fit.ci)},
                     {"deviance", fit.deviance}, {"degrees_of_freedom", fit.degreesOfFreedom}, {"p_value", fit.pValue},
                     {"error", parameterErrors(fit)}, {"log_likelihood", fit.logLikelihood}, {"aic", fit.aic}, {"levels", levelsJson(fit)}, {"warnings", warnings}};
    if (fit.method == FitMethod::bayesian) {
        json.insert("mean", parameters(fit.mean, fit.scale));
        json.insert("interval_prior", fit.intervalPrior == WidthPrior::wide ? "wide" : "psignifit");
        json.insert("prior_influence", influenceJson(fit.priorInfluence));
    }
    if (!fit.curve.empty()) {
        QJsonArray curve;
        for (const CurveSample& sample : fit.curve)
            curve.append(QJsonObject{{"intensity", sample.x}, {"fitted", sample.fitted}, {"low", sample.low}, {"high", sample.high}});
        json.insert("curve", curve);
    }
    return json;
}

void warn(QJsonObject& json, const QString& warning) {
    QJsonArray warnings = json["warnings"].toArray();
    warnings.append(warning);
    json.insert("warnings", warnings);
}

/// What was asked for beside the parameters: the threshold at another proportion, and PSE, JND and Weber fraction at a reference.
core::Result<void> addDerived(const Arguments& arguments, const FitResult& fit, QJsonObject& json) {
    const bool unscaled = arguments.has(QStringLiteral("unscaled"));
    if (arguments.has(QStringLiteral("threshold-at"))) {
        const auto proportion = arguments.number(QStringLiteral("threshold-at"), 0.001, 0.999, 0.75);
        if (!proportion)
            return tl::unexpected(proportion.error());
        const double p = *proportion;
        const FitInterval interval = intervalOf(fit, [&](const CurveParameters& at) { return thresholdAt(fit, at, p, unscaled); });
        if (const double value = thresholdAt(fit, p, unscaled); fit.fitted && std::isnan(value))
            warn(json, QStringLiteral("never_reached: the curve does not take the proportion %1 (guess %2, lapse %3)").arg(p).arg(fit.guess).arg(fit.lapse));
        json.insert("threshold_at", QJsonObject{{"proportion", p}, {"unscaled", unscaled}, {"value", thresholdAt(fit, p, unscaled)}, {"ci", pair(interval)}});
    }
    json.insert("pse", pse(fit));
    json.insert("jnd", jnd(fit));
    if (arguments.has(QStringLiteral("reference"))) {
        const auto reference = arguments.number(QStringLiteral("reference"), -1e12, 1e12, 0.0);
        if (!reference)
            return tl::unexpected(reference.error());
        json.insert("reference", *reference);
        if (*reference == 0.0)
            warn(json, QStringLiteral("no_reference: a Weber fraction at 0 has no value"));
        json.insert("weber", weberFraction(fit, *reference));
    }
    return {};
}

/// What was asked for beside the parameters, a line or a table each.
QString derivedText(const QJsonObject& json) {
    const auto shown = [](const QJsonValue& value) { return shortNumber(value.toDouble(std::nan(""))); };
    QString words;
    if (json.contains("threshold_at")) {
        const QJsonObject at = json["threshold_at"].toObject();
        const QJsonArray ci = at["ci"].toArray();
        words += QStringLiteral("threshold at %1%2: %3 (%4 to %5)\n")
                     .arg(shown(at["proportion"]), at["unscaled"].toBool() ? QStringLiteral(" of the curve without guess and lapse") : QString(), shown(at["value"]), shown(ci[0]), shown(ci[1]));
    }
    if (json.contains("weber"))
        words += QStringLiteral("Weber fraction at %1: %2\n").arg(shown(json["reference"]), shown(json["weber"]));
    if (json.contains("curve")) {
        TextTable table({">intensity", ">fitted", ">low", ">high"});
        for (const QJsonValue& sample : json["curve"].toArray())
            table.add({shown(sample["intensity"]), shown(sample["fitted"]), shown(sample["low"]), shown(sample["high"])});
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
    const auto number = [&](const char* key) { return shortNumber(json[QLatin1String(key)].toDouble(std::nan(""))); };
    QString words = QStringLiteral("%1, %2, fitted on a %3 axis, %4 % intervals\n")
                        .arg(json["function"].toString(), json["method"].toString(), json["scale"].toString())
                        .arg(100.0 * json["confidence"].toDouble());
    words += table.toText();
    if (bayes)
        words += QStringLiteral("prior's part: spread after the answers over spread before them, 0 the answers decide, 1 the prior does; intervals of the %1 prior\n")
                     .arg(json["interval_prior"].toString());
    words += QStringLiteral("deviance %1 (p %2), log-likelihood %3\nPSE %4, JND %5\n")
                 .arg(number("deviance"), number("p_value"), number("log_likelihood"), number("pse"), number("jnd"));
    words += derivedText(json);
    for (const QJsonValue& warning : json["warnings"].toArray())
        words += QStringLiteral("! %1\n").arg(warning.toString());
    return words;
}

} // namespace

core::Result<CommandOutput> fitCurve(const Arguments& arguments) {
    const auto method = arguments.choice(QStringLiteral("method"), {"bayes", "ml"}, QStringLiteral("bayes"));
    if (!method)
        return tl::unexpected(method.error());
    const auto options = readOptions(arguments);
    if (!options)
        return tl::unexpected(options.error());
    if (*method == u"ml" && arguments.has(QStringLiteral("prior")))
        return wrongUse(QStringLiteral("--prior: expected with --method bayes; maximum likelihood has none"));
    if (*method == u"bayes" && options->bootstrap != Bootstrap::none)
        return wrongUse(QStringLiteral("--bootstrap: expected with --method ml; a Bayesian fit has credible intervals"));
    const auto levels = readLevels(arguments.operand(0));
    if (!levels)
        return tl::unexpected(levels.error());
    FitResult fit = *method == u"ml" ? fitMaximumLikelihood(levels->data, *options) : fitBayesian(levels->data, *options);
    for (std::string& warning : fit.warnings)
        if (warning.starts_with("unusable_rows"))
            warning += " (" + levels->leftOut.toStdString() + ")";
    if (fit.fitted && *method == u"ml" && options->bootstrap == Bootstrap::none && (options->curvePoints > 1 || arguments.has(QStringLiteral("threshold-at"))))
        fit.warnings.emplace_back("no_interval: a curve and a threshold at another proportion have intervals with --bootstrap only, by this method");
    QJsonObject json = fitJson(fit);
    if (auto added = addDerived(arguments, fit, json); !added)
        return tl::unexpected(added.error());
    return CommandOutput{QJsonDocument(json), fitText(json), 0};
}

} // namespace chiron::cli
