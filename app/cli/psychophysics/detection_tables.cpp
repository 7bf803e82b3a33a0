// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/csv_table.h"
#include "cli/psychophysics/handlers.h"
#include "cli/text_table.h"
#include "core/signal_detection.h"
#include "psychophysics/measures/dprime.h"

#include <QJsonArray>
#include <QJsonObject>
#include <cmath>
#include <optional>

namespace chiron::cli {

namespace {

using namespace psychophysics;

const QStringList kTasks{"yes-no", "2afc", "mafc", "same-different", "triangle", "oddity", "abx", "tetrad"};
constexpr char kChance[] = "chance: no better than guessing";
const QStringList kCounts{"hits", "misses", "false_alarms", "correct_rejections"};

/// A line to be converted to d': four counts, or the number of correct answers and of all answers (or the
/// proportion alone).
struct Row {
    std::optional<std::array<long long, 4>> counts;
    long long right = 0, of = 0;
    double proportion = std::numeric_limits<double>::quiet_NaN();
};

core::Result<DiscriminationTask> ruleOf(const Arguments& arguments, const QString& task) {
    const auto rule = arguments.choice(QStringLiteral("rule"), {"differencing", "independent"}, {});
    const auto m = arguments.integer(QStringLiteral("m"), 2, 1000, 3);
    CHIRON_TRY(rule);
    CHIRON_TRY(m);
    const bool independent = *rule == u"independent" || (rule->isEmpty() && task == u"oddity");
    if (task == u"mafc" || task == u"2afc")
        return DiscriminationTask{Discrimination::mAfc, task == u"2afc" ? 2 : static_cast<int>(*m)};
    if (task == u"triangle" || task == u"oddity")
        return DiscriminationTask{
            independent ? Discrimination::oddityIndependent : Discrimination::oddityDifferencing, 3};
    if (task == u"abx")
        return DiscriminationTask{
            independent ? Discrimination::abxIndependent : Discrimination::abxDifferencing, 2};
    return DiscriminationTask{
        task == u"tetrad" ? Discrimination::tetrad : Discrimination::sameDifferentIndependent, 2};
}

core::Result<long long> count(const CsvTable& table, std::size_t row, int column) {
    const auto value = table.number(row, column);
    CHIRON_TRY(value);
    if (!(*value >= 0.0 && *value <= 1e9) || *value != std::floor(*value))
        return table.fault(row, column, QStringLiteral("a whole number from 0 to 1e9"));
    return static_cast<long long>(*value);
}

core::Result<std::vector<Row>> readRows(const QString& path, bool fourCounts) {
    const auto table = readCsvTable(path);
    CHIRON_TRY(table);
    const QStringList wanted = fourCounts ? kCounts : QStringList{"n_correct", "n_total"};
    std::vector<int> columns;
    for (const QString& name : wanted) {
        columns.push_back(table->column(name));
        if (columns.back() < 0)
            return badInput(
                QStringLiteral("%1:1: column %2 is missing; expected %3").arg(path, name, wanted.join(u',')));
    }
    std::vector<Row> rows;
    for (std::size_t i = 0; i < table->rows.size(); ++i) {
        std::array<long long, 4> numbers{};
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const auto number = count(*table, i, columns[c]);
            CHIRON_TRY(number);
            numbers[c] = *number;
        }
        if (!fourCounts && numbers[0] > numbers[1])
            return table->fault(i, columns[0], QStringLiteral("at most n_total"));
        rows.push_back(fourCounts ? Row{numbers, 0, 0} : Row{std::nullopt, numbers[0], numbers[1]});
    }
    return rows;
}

core::Result<Row> rowOfOptions(const Arguments& arguments, bool fourCounts) {
    Row row;
    constexpr qint64 kMost = 1'000'000'000;
    const QStringList names = fourCounts ? QStringList{"hits", "misses", "false-alarms", "correct-rejections"}
                                         : QStringList{"correct", "total"};
    if (!fourCounts && arguments.has(QStringLiteral("proportion"))) {
        for (const QString& name : names)
            if (arguments.has(name))
                return wrongUse(QStringLiteral("--%1 beside --proportion: expected one of them").arg(name));
        const auto proportion = arguments.number(QStringLiteral("proportion"), 0.0, 1.0, 0.0);
        CHIRON_TRY(proportion);
        row.proportion = *proportion;
        return row;
    }
    std::array<long long, 4> numbers{};
    for (qsizetype i = 0; i < names.size(); ++i) {
        if (!arguments.has(names[i]))
            return wrongUse(QStringLiteral("--%1 is missing; expected --%2, or a table")
                                .arg(names[i], names.join(QStringLiteral(", --"))));
        const auto number = arguments.integer(names[i], 0, kMost, 0);
        CHIRON_TRY(number);
        numbers[static_cast<std::size_t>(i)] = *number;
    }
    if (fourCounts)
        row.counts = numbers;
    row.right = numbers[0];
    row.of = numbers[1];
    if (!fourCounts && row.right > row.of)
        return wrongUse(
            QStringLiteral("--correct %1: expected at most --total %2").arg(row.right).arg(row.of));
    return row;
}

QJsonObject estimateJson(const DPrimeEstimate& e) {
    QJsonArray warnings;
    for (const std::string& warning : e.warnings)
        warnings.append(QString::fromStdString(warning));
    return {{"d_prime", e.dPrime},
            {"se", e.standardError},
            {"ci_low", e.low},
            {"ci_high", e.high},
            {"proportion_correct", e.proportion},
            {"p_value", e.pValue},
            {"warnings", warnings}};
}

QJsonObject yesNoJson(const std::array<long long, 4>& c, bool corrected) {
    const core::DetectionCounts counts{static_cast<int>(c[0]), static_cast<int>(c[0] + c[1]),
                                       static_cast<int>(c[2]), static_cast<int>(c[2] + c[3])};
    const core::RateCorrection correction =
        corrected ? core::RateCorrection::logLinear : core::RateCorrection::none;
    // A correction must not produce a number from no data.
    const bool any = counts.ofSignal > 0 && counts.ofNoise > 0;
    const auto rate = [&](int yes, int of) {
        return any ? core::rateOf(yes, of, correction) : std::numeric_limits<double>::quiet_NaN();
    };
    const double hit = rate(counts.hits, counts.ofSignal), alarm = rate(counts.falseAlarms, counts.ofNoise);
    QJsonArray warnings;
    if (any && !std::isfinite(core::dPrime(hit, alarm)))
        warnings.append(
            QStringLiteral("no_limit: a rate is 0 or 1, so d' has no finite value without a correction"));
    if (any && corrected)
        for (const std::string& warning : warningsOfRates(c[0], c[0] + c[1], c[2], c[2] + c[3]))
            warnings.append(QString::fromStdString(warning));
    if (!any)
        warnings.append(QStringLiteral("no_trials: there are no trials with, or none without, the stimulus"));
    else if (!core::isUsable(counts))
        warnings.append(
            QStringLiteral("few_trials: fewer than %1 trials with, or without, the stimulus; d' is uncertain")
                .arg(core::kUsableCounts));
    core::DetectionInterval interval{std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::quiet_NaN()};
    if (any)
        interval = core::dPrimeInterval(counts, 0.95, correction);
    const double error =
        any ? core::dPrimeStandardError(counts, correction) : std::numeric_limits<double>::quiet_NaN();
    return {{"d_prime", core::dPrime(hit, alarm)},
            {"criterion", core::criterion(hit, alarm)},
            {"log_beta", core::dPrime(hit, alarm) * core::criterion(hit, alarm)},
            {"se", error},
            {"ci_low", interval.low},
            {"ci_high", interval.high},
            {"hit_rate", hit},
            {"false_alarm_rate", alarm},
            {"correction", corrected ? "log-linear" : "none"},
            {"warnings", warnings}};
}

core::Result<QJsonObject> rowJson(const Arguments& arguments, const QString& task, const Row& row) {
    QJsonObject json;
    const bool corrected = !arguments.has(QStringLiteral("uncorrected"));
    if (task == u"yes-no") {
        json = yesNoJson(*row.counts, corrected);
    } else if (row.counts && arguments.value(QStringLiteral("rule")) != u"independent") {
        const auto& c = *row.counts;
        json = estimateJson(
            sameDifferentOfCounts(c[0], c[0] + c[1], c[2], c[2] + c[3], 0.95,
                                  corrected ? core::RateCorrection::logLinear : core::RateCorrection::none));
        json.insert("correction", corrected ? "log-linear" : "none");
        json.insert("rule", "differencing");
    } else {
        const auto rule = ruleOf(arguments, task);
        CHIRON_TRY(rule);
        if (row.counts) {
            const QJsonObject rates = yesNoJson(*row.counts, corrected);
            QJsonArray warnings = rates["warnings"].toArray();
            if (rates["hit_rate"].toDouble() <= rates["false_alarm_rate"].toDouble())
                warnings.append(QLatin1String(kChance));
            json = {{"d_prime", dPrimeOfRates(*rule, rates["hit_rate"].toDouble(),
                                              rates["false_alarm_rate"].toDouble())},
                    {"hit_rate", rates["hit_rate"]},
                    {"false_alarm_rate", rates["false_alarm_rate"]},
                    {"rule", "independent"},
                    {"warnings", warnings}};
        } else if (std::isfinite(row.proportion)) {
            const double found = dPrimeAt(*rule, row.proportion);
            QJsonArray warnings;
            if (!std::isfinite(found))
                warnings.append(QStringLiteral("no_limit: at this proportion d' has no finite value"));
            if (row.proportion <= chanceOf(*rule))
                warnings.append(QLatin1String(kChance));
            json = {{"d_prime", found}, {"proportion_correct", row.proportion}, {"warnings", warnings}};
        } else {
            json = estimateJson(dPrimeOfCounts(*rule, row.right, row.of));
        }
        json.insert("chance", chanceOf(*rule));
    }
    json.insert("task", task);
    return json;
}

} // namespace

core::Result<CommandOutput> detectionTables(const Arguments& arguments) {
    const auto task = arguments.choice(QStringLiteral("task"), kTasks, QStringLiteral("yes-no"));
    CHIRON_TRY(task);
    const bool fourCounts = *task == u"yes-no" || *task == u"same-different";
    const bool isTable = !arguments.operand(0).isEmpty();
    std::vector<Row> rows;
    if (isTable) {
        for (const char* option :
             {"hits", "misses", "false-alarms", "correct-rejections", "correct", "total", "proportion"})
            if (arguments.has(QLatin1String(option)))
                return wrongUse(
                    QStringLiteral("--%1 beside a table: expected one of them").arg(QLatin1String(option)));
        auto read = readRows(arguments.operand(0), fourCounts);
        CHIRON_TRY(read);
        rows = std::move(*read);
    } else {
        auto row = rowOfOptions(arguments, fourCounts);
        CHIRON_TRY(row);
        rows.push_back(*row);
    }
    QJsonArray all;
    TextTable table({"task", ">d'", ">low", ">high", ">criterion", "warnings"});
    for (const Row& row : rows) {
        const auto json = rowJson(arguments, *task, row);
        CHIRON_TRY(json);
        all.append(*json);
        const auto shown = [&](const char* key) {
            return shortNumber(json->value(QLatin1String(key)).toDouble(std::nan("")));
        };
        QStringList warnings;
        for (const QJsonValue& warning : (*json)["warnings"].toArray())
            warnings << warning.toString();
        table.add({*task, shown("d_prime"), shown("ci_low"), shown("ci_high"), shown("criterion"),
                   warnings.join(QStringLiteral("; "))});
    }
    return CommandOutput{QJsonDocument(isTable ? QJsonObject{{"rows", all}} : all[0].toObject()),
                         table.toText(), 0};
}

} // namespace chiron::cli
