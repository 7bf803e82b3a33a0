// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/csv_table.h"
#include "cli/psychophysics/handlers.h"
#include "cli/text_table.h"
#include "psychophysics/measures/agreement.h"
#include "psychophysics/measures/page_trend.h"
#include "psychophysics/measures/pairwise_ranking.h"

#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace chiron::cli {

namespace {

using namespace psychophysics;

QJsonArray words(const std::vector<std::string>& warnings) {
    QJsonArray array;
    for (const std::string& warning : warnings)
        array.append(QString::fromStdString(warning));
    return array;
}

QJsonObject worthJson(WorthEstimate worth, const QStringList& items, bool exponentials, int leftOut = 0) {
    if (leftOut > 0)
        worth.warnings.push_back("left_out: " + std::to_string(leftOut) +
                                 " rankings have ties or missing ranks, which this model does not take");
    QJsonArray objects;
    double total = 0.0;
    for (const double log : worth.logWorth)
        total += std::exp(log);
    for (std::size_t i = 0; i < worth.logWorth.size(); ++i) {
        QJsonObject one{{"item", items[static_cast<qsizetype>(i)]}};
        one.insert(exponentials ? "log_worth" : "scale", worth.logWorth[i]);
        if (exponentials)
            one.insert("worth", std::exp(worth.logWorth[i]) / total);
        if (i < worth.standardError.size())
            one.insert("se", worth.standardError[i]);
        objects.append(one);
    }
    return {{"fitted", worth.fitted},
            {"items", objects},
            {"log_likelihood", worth.logLikelihood},
            {"iterations", worth.iterations},
            {"warnings", words(worth.warnings)}};
}

/// Judges' ranks, one row per judge and one column per object. Columns named subject, judge, participant or
/// trial are skipped.
struct Judges {
    QStringList items;
    std::vector<std::vector<double>> ranks;
    std::vector<std::vector<int>> bestFirst; ///< only rows without ties and missing ranks
    int leftOut = 0;                         ///< rows that are not in bestFirst
    int notRanks = 0; ///< rows with a value that is not a rank from 1 to the number of objects
};

core::Result<Judges> readJudges(const CsvTable& table) {
    const QStringList names{"subject", "judge", "participant", "trial"};
    Judges judges;
    std::vector<int> columns;
    for (int i = 0; i < table.header.size(); ++i) {
        if (names.contains(table.header[i].toLower()))
            continue;
        columns.push_back(i);
        judges.items << table.header[i];
    }
    if (columns.size() < 2)
        return badInput(QStringLiteral("%1:1: %2 objects; expected a column for each object, at least two")
                            .arg(table.name)
                            .arg(columns.size()));
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        std::vector<double> ranks;
        for (const int column : columns) {
            const auto rank = table.number(row, column);
            CHIRON_TRY(rank);
            ranks.push_back(*rank);
        }
        std::vector<int> order(ranks.size());
        std::iota(order.begin(), order.end(), 0);
        const auto rankOf = [&](int i) { return ranks[static_cast<std::size_t>(i)]; };
        const bool finite =
            std::all_of(ranks.begin(), ranks.end(), [](double r) { return std::isfinite(r); });
        if (finite)
            std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rankOf(a) < rankOf(b); });
        const bool tied = finite && std::adjacent_find(order.begin(), order.end(), [&](int a, int b) {
                                        return rankOf(a) == rankOf(b);
                                    }) != order.end();
        if (finite && !tied)
            judges.bestFirst.push_back(order);
        else
            ++judges.leftOut;
        const auto isRank = [&](double r) {
            return !std::isfinite(r) || (r >= 1.0 && r <= static_cast<double>(ranks.size()));
        };
        judges.notRanks += std::all_of(ranks.begin(), ranks.end(), isRank) ? 0 : 1;
        judges.ranks.push_back(std::move(ranks));
    }
    return judges;
}

/// Columns in the order that --order states, for Page's L.
core::Result<std::vector<std::vector<double>>> inOrder(const Judges& judges, const QStringList& order) {
    std::vector<qsizetype> columns;
    for (const QString& item : order) {
        columns.push_back(judges.items.indexOf(item));
        if (columns.back() < 0)
            return wrongUse(QStringLiteral("--order: %1: not a column; expected each of %2")
                                .arg(quoted(item), judges.items.join(u',')));
    }
    if (order.size() != judges.items.size())
        return wrongUse(QStringLiteral("--order: %1 objects; expected each of %2")
                            .arg(order.size())
                            .arg(judges.items.join(u',')));
    std::vector<std::vector<double>> rows;
    for (const auto& ranks : judges.ranks) {
        std::vector<double> row;
        for (const qsizetype column : columns)
            row.push_back(ranks[static_cast<std::size_t>(column)]);
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Kendall's tau of each judge with the expected order, and their mean; only the mean if there are many
/// judges.
QJsonObject tauJson(const std::vector<std::vector<double>>& rows) {
    constexpr std::size_t kMostShown = 1000;
    QJsonArray each;
    double sum = 0.0;
    int counted = 0;
    for (const auto& ranks : rows) {
        std::vector<double> expected(ranks.size());
        std::iota(expected.begin(), expected.end(), 1.0);
        const bool whole = std::all_of(ranks.begin(), ranks.end(), [](double r) { return std::isfinite(r); });
        const RankCorrelation tau = whole ? kendallTau(expected, ranks) : RankCorrelation{};
        if (std::isfinite(tau.tau)) {
            sum += tau.tau;
            ++counted;
        }
        if (rows.size() <= kMostShown)
            each.append(QJsonObject{{"tau", tau.tau}, {"p_value", tau.pValue}, {"exact", tau.exact}});
    }
    return {{"mean", counted > 0 ? sum / counted : std::nan("")}, {"judges", counted}, {"each", each}};
}

core::Result<QJsonObject> ranksJson(const Arguments& arguments, const CsvTable& table,
                                    const WorthOptions& options) {
    const auto judges = readJudges(table);
    CHIRON_TRY(judges);
    auto order = arguments.list(QStringLiteral("order"));
    CHIRON_TRY(order);
    const auto rows = inOrder(*judges, order->isEmpty() ? judges->items : *order);
    CHIRON_TRY(rows);
    const Concordance w = kendallW(judges->ranks);
    const PageTrend page = pageTrend(*rows);
    std::vector<Selection> selections;
    for (const auto& bestFirst : judges->bestFirst)
        for (const Selection& selection : selectionsOf(bestFirst))
            selections.push_back(selection);
    const int objects = static_cast<int>(judges->items.size());
    std::vector<std::string> warnings;
    if (judges->notRanks > 0)
        warnings.push_back("not_ranks: " + std::to_string(judges->notRanks) +
                           " rows have values that are no ranks from 1 to " + std::to_string(objects) +
                           "; they were taken as an order, the smallest best");
    return QJsonObject{
        {"warnings", words(warnings)},
        {"judges", w.judges},
        {"objects", w.objects},
        {"items", QJsonArray::fromStringList(judges->items)},
        {"tied_or_incomplete", judges->leftOut},
        {"kendall_w", QJsonObject{{"w", w.w},
                                  {"chi_square", w.chiSquare},
                                  {"degrees_of_freedom", w.objects - 1},
                                  {"p_value", w.pValue},
                                  {"exact_p", w.exactP},
                                  {"warnings", words(w.warnings)}}},
        {"page", QJsonObject{{"order", QJsonArray::fromStringList(order->isEmpty() ? judges->items : *order)},
                             {"l", page.l},
                             {"expected", page.expected},
                             {"z", page.z},
                             {"p_value", page.pValue},
                             {"exact_p", page.exactP},
                             {"warnings", words(page.warnings)}}},
        {"kendall_tau", tauJson(*rows)},
        {"plackett_luce",
         worthJson(fitPlackettLuce(objects, selections, options), judges->items, true, judges->leftOut)},
        {"thurstone",
         worthJson(fitThurstoneOrders(objects, judges->bestFirst), judges->items, false, judges->leftOut)}};
}

core::Result<QJsonObject> pairsJson(const CsvTable& table, const WorthOptions& options) {
    const int winner = table.column("winner"), loser = table.column("loser"), count = table.column("count");
    QStringList items;
    std::vector<Selection> pairs;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        for (const int column : {winner, loser}) {
            if (table.cell(row, column).isEmpty())
                return table.fault(row, column, QStringLiteral("a name"));
            if (!items.contains(table.cell(row, column)))
                items << table.cell(row, column);
        }
        const auto times = count >= 0 ? table.number(row, count) : core::Result<double>(1.0);
        CHIRON_TRY(times);
        if (!(*times >= 0.0 && *times <= 1e9))
            return table.fault(row, count, QStringLiteral("a number from 0 to 1e9"));
        const auto index = [&](int column) {
            return static_cast<int>(items.indexOf(table.cell(row, column)));
        };
        if (index(winner) == index(loser))
            return table.fault(row, loser, QStringLiteral("another one than the winner"));
        pairs.push_back({index(winner), {index(loser)}, *times});
    }
    const int objects = static_cast<int>(items.size());
    return QJsonObject{{"objects", objects},
                       {"items", QJsonArray::fromStringList(items)},
                       {"bradley_terry", worthJson(fitPlackettLuce(objects, pairs, options), items, true)},
                       {"thurstone", worthJson(fitThurstonePairs(objects, pairs), items, false)}};
}

QString textOf(const QJsonObject& json) {
    QString text;
    if (json.contains("kendall_w")) {
        const QJsonObject w = json["kendall_w"].toObject(), page = json["page"].toObject();
        text += QStringLiteral("Kendall's W %1 (p %2), Page's L %3 (p %4), mean Kendall's tau with that "
                               "order %5, %6 judges\n")
                    .arg(shortNumber(w["w"].toDouble(std::nan(""))),
                         shortNumber(w["p_value"].toDouble(std::nan(""))),
                         shortNumber(page["l"].toDouble(std::nan(""))),
                         shortNumber(page["p_value"].toDouble(std::nan(""))),
                         shortNumber(json["kendall_tau"].toObject()["mean"].toDouble(std::nan(""))))
                    .arg(json["judges"].toInt());
        for (const QJsonValue& warning : json["warnings"].toArray())
            text += QStringLiteral("! %1\n").arg(warning.toString());
    }
    for (const char* model : {"plackett_luce", "bradley_terry", "thurstone"}) {
        const QJsonObject fit = json[QLatin1String(model)].toObject();
        if (fit.isEmpty())
            continue;
        TextTable table({QLatin1String(model), ">value", ">se"});
        for (const QJsonValue& item : fit["items"].toArray())
            table.add({item["item"].toString(),
                       shortNumber((item.toObject().contains("scale") ? item["scale"] : item["log_worth"])
                                       .toDouble(std::nan(""))),
                       shortNumber(item["se"].toDouble(std::nan("")))});
        text += table.toText();
        for (const QJsonValue& warning : fit["warnings"].toArray())
            text += QStringLiteral("! %1\n").arg(warning.toString());
    }
    return text;
}

} // namespace

core::Result<CommandOutput> rankings(const Arguments& arguments) {
    WorthOptions options;
    const auto regularisation = arguments.number(QStringLiteral("regularise"), 0.0, 1e6, 0.0);
    CHIRON_TRY(regularisation);
    options.regularisation = *regularisation;
    const auto table = readCsvTable(arguments.operand(0));
    CHIRON_TRY(table);
    const bool pairs = table->column("winner") >= 0 && table->column("loser") >= 0;
    const auto json = pairs ? pairsJson(*table, options) : ranksJson(arguments, *table, options);
    CHIRON_TRY(json);
    return CommandOutput{QJsonDocument(*json), textOf(*json), 0};
}

} // namespace chiron::cli
