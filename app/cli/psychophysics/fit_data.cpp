// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/psychophysics/fit_data.h"

#include "cli/cli_errors.h"
#include "cli/csv_table.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/fits/prepared_levels.h"

#include <QHash>
#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::cli {

namespace {

using namespace psychophysics;

/// Limit of one level, and of all levels of a group together; beyond it, a posterior is narrower than any
/// grid.
constexpr double kMostTrials = 1e9;
constexpr std::size_t kMostGroups = 1000; ///< if there are more, the column does not define groups

QStringList sigmoidNames() {
    QStringList names;
    for (int i = 0; i < kSigmoids; ++i)
        names << QString::fromStdString(std::string(token(static_cast<Sigmoid>(i))));
    return names;
}

/// "DATA.csv: lines 3, 7". Only a few lines are named, since a wrongly chosen column makes every row
/// unusable.
QString placesOf(const CsvTable& table, const std::vector<std::size_t>& rows) {
    constexpr std::size_t kMostNamed = 5;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(rows.size(), kMostNamed); ++i)
        lines << QString::number(table.lines[rows[i]]);
    return rows.empty()
               ? QString()
               : QStringLiteral("%1: %2 %3%4")
                     .arg(table.name, rows.size() == 1 ? QStringLiteral("line") : QStringLiteral("lines"),
                          lines.join(QStringLiteral(", ")),
                          rows.size() > kMostNamed ? QStringLiteral(" ...") : QString());
}

/// The columns of the table that hold the answers.
struct AnswerColumns {
    int intensity = -1;
    int correct = -1;           ///< column of single trials; −1: the table holds counts
    int right = -1, total = -1; ///< columns of counts
    QList<int> by;

    bool trials() const { return correct >= 0; }
};

core::Result<int> columnOf(const CsvTable& table, const QString& name, const QString& expected) {
    const int column = table.column(name);
    if (column < 0)
        return badInput(QStringLiteral("%1:%2: column %3 is missing; expected %4")
                            .arg(table.name)
                            .arg(table.headerLine)
                            .arg(name, expected));
    return column;
}

core::Result<AnswerColumns> columnsOf(const CsvTable& table, const Arguments& arguments,
                                      const QStringList& by) {
    const auto named = [&](const char* option) {
        return arguments.has(QLatin1String(option)) ? arguments.value(QLatin1String(option))
                                                    : QLatin1String(option);
    };
    const QString intensity = named("intensity"), correct = named("correct");
    AnswerColumns columns;
    const bool trials = arguments.has(QStringLiteral("correct")) ||
                        (table.column(correct) >= 0 && table.column(QStringLiteral("n_correct")) < 0);
    const QString expected =
        trials ? intensity + u',' + correct
               : intensity +
                     QStringLiteral(",n_correct,n_total, or %1,%2 of single trials").arg(intensity, correct);
    const auto take = [&](int& into, const QString& name) -> core::Result<void> {
        const auto column = columnOf(table, name, expected);
        CHIRON_TRY(column);
        into = *column;
        return {};
    };
    auto read = take(columns.intensity, intensity);
    if (read && trials)
        read = take(columns.correct, correct);
    else if (read)
        read = take(columns.right, QStringLiteral("n_correct"));
    if (read && !trials)
        read = take(columns.total, QStringLiteral("n_total"));
    CHIRON_TRY(read);
    for (const QString& name : by) {
        const auto column =
            columnOf(table, name, QStringLiteral("one of %1 for --by").arg(table.header.join(u',')));
        CHIRON_TRY(column);
        if (*column == columns.intensity || *column == columns.correct || *column == columns.right ||
            *column == columns.total)
            return wrongUse(
                QStringLiteral("--by %1: expected a column of groups, not one of the answers").arg(name));
        columns.by << *column;
    }
    return columns;
}

/// The values of a row and its fault, if any: the column and what was expected there.
struct ReadRow {
    double x = 0.0, right = 0.0, of = 0.0;
    int wrongColumn = -1;
    QString expected;
};

core::Result<ReadRow> readRow(const CsvTable& table, std::size_t row, const AnswerColumns& columns) {
    ReadRow read;
    const auto x = table.number(row, columns.intensity),
               right = table.number(row, columns.trials() ? columns.correct : columns.right);
    const auto of = columns.trials() ? core::Result<double>(1.0) : table.number(row, columns.total);
    for (const auto* value : {&x, &right, &of})
        CHIRON_TRY(*value);
    read.x = *x;
    read.right = *right;
    read.of = *of;
    const auto wrong = [&](int column, const char* expected) {
        read.wrongColumn = column;
        read.expected = QString::fromUtf8(expected);
    };
    if (!std::isfinite(read.x))
        wrong(columns.intensity, "a finite number");
    else if (columns.trials() && read.right != 0.0 && read.right != 1.0)
        wrong(columns.correct, "1 (right) or 0 (wrong)");
    else if (!columns.trials() &&
             !(read.of >= 0.0 && read.of == std::floor(read.of) && std::isfinite(read.of)))
        wrong(columns.total, "a whole number, at least 0");
    else if (!isUsableRow(read.x, read.right, read.of) && read.of > 0.0)
        wrong(columns.trials() ? columns.correct : columns.right, "a whole number from 0 to n_total");
    for (const int column : columns.by)
        if (read.wrongColumn < 0 && table.cell(row, column).isEmpty())
            wrong(column, "a value to group by");
    return read;
}

/// Sorts rows into their groups.
class Grouping {
public:
    Grouping(const CsvTable& table, const AnswerColumns& columns, bool strict, bool dropBad)
        : m_table(table), m_columns(columns), m_strict(strict), m_dropBad(dropBad) {}

    core::Result<void> add(std::size_t row) {
        const auto read = readRow(m_table, row, m_columns);
        if (!read)
            return m_dropBad ? leaveOut(row, {}) : tl::unexpected(read.error());
        if (std::isfinite(read->of) && read->of > kMostTrials)
            return m_table.fault(row, m_columns.total, QStringLiteral("at most 1e9"));
        if (read->wrongColumn >= 0 && m_strict && !m_dropBad)
            return m_table.fault(row, read->wrongColumn,
                                 read->expected + QStringLiteral("; --drop-bad leaves such rows out"));
        QStringList values;
        for (const int column : m_columns.by)
            values << m_table.cell(row, column);
        if (read->wrongColumn >= 0 && (m_strict || m_dropBad))
            return leaveOut(row, values);
        return put(row, values, *read);
    }
    std::vector<AnswersOf> take() {
        for (std::size_t i = 0; i < m_groups.size(); ++i)
            m_groups[i].leftOut = placesOf(m_table, m_bad[i]);
        return std::move(m_groups);
    }

private:
    core::Result<std::size_t> groupOf(const QStringList& values) {
        const auto found = m_place.constFind(values);
        if (found != m_place.constEnd())
            return *found;
        if (m_groups.size() == kMostGroups)
            return wrongUse(
                QStringLiteral(
                    "--by: more than %1 different values; expected a column of participants or conditions")
                    .arg(kMostGroups));
        m_place.insert(values, m_groups.size());
        m_groups.push_back({values, {}, {}});
        m_bad.emplace_back();
        m_trials.push_back(0.0);
        return m_groups.size() - 1;
    }
    /// Records an unreadable row in the group whose name it has.
    core::Result<void> leaveOut(std::size_t row, QStringList values) {
        if (values.isEmpty())
            for (const int column : m_columns.by)
                values << m_table.cell(row, column);
        if (values.contains(QString()))
            return {};
        const auto group = groupOf(values);
        CHIRON_TRY(group);
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        // A row that the fit counts and reports as not usable.
        PsychometricData& data = m_groups[*group].data;
        data.x.push_back(kNone);
        data.k.push_back(kNone);
        data.n.push_back(kNone);
        m_bad[*group].push_back(row);
        return {};
    }
    core::Result<void> put(std::size_t row, const QStringList& values, const ReadRow& read) {
        const auto group = groupOf(values);
        CHIRON_TRY(group);
        double& trials = m_trials[*group];
        trials += read.of > 0.0 ? read.of : 0.0;
        // Of all levels together; a larger number would let the grid use up all memory.
        if (trials > kMostTrials)
            return m_table.fault(row, m_columns.total, QStringLiteral("at most 1e9 of all rows together"));
        PsychometricData& data = m_groups[*group].data;
        data.x.push_back(read.x);
        data.k.push_back(read.right);
        data.n.push_back(read.of);
        if (!isUsableRow(read.x, read.right, read.of))
            m_bad[*group].push_back(row);
        return {};
    }

    const CsvTable& m_table;
    const AnswerColumns& m_columns;
    bool m_strict, m_dropBad;
    QHash<QStringList, std::size_t> m_place;
    std::vector<AnswersOf> m_groups;
    std::vector<std::vector<std::size_t>> m_bad;
    std::vector<double> m_trials;
};

/// A proportion, "free", or (if `equal` allows it) "equal".
core::Result<Asymptote> asymptote(const Arguments& arguments, const QString& option, bool equal,
                                  Asymptote fallback) {
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

} // namespace

core::Result<AnswerTable> readAnswers(const Arguments& arguments) {
    const auto by = arguments.list(QStringLiteral("by"));
    CHIRON_TRY(by);
    const auto table = readCsvTable(arguments.operand(0));
    CHIRON_TRY(table);
    const auto columns = columnsOf(*table, arguments, *by);
    CHIRON_TRY(columns);
    Grouping grouping(*table, *columns, columns->trials() || !by->isEmpty(),
                      arguments.has(QStringLiteral("drop-bad")));
    for (std::size_t row = 0; row < table->rows.size(); ++row)
        CHIRON_TRY(grouping.add(row));
    AnswerTable answers{*by, grouping.take()};
    if (answers.groups.empty())
        return badInput(
            QStringLiteral("%1: no row can be used; expected at least one with a group and an answer")
                .arg(table->name));
    return answers;
}

core::Result<FitOptions> readCurve(const Arguments& arguments) {
    FitOptions options;
    const auto function =
        arguments.choice(QStringLiteral("function"), sigmoidNames(), QStringLiteral("gauss"));
    const auto scale = arguments.choice(QStringLiteral("scale"), {"linear", "ln", "log10", "db"}, {});
    CHIRON_TRY(function);
    CHIRON_TRY(scale);
    options.function = *sigmoidFromToken(function->toStdString());
    if (!scale->isEmpty())
        options.scale = stimulusScaleFromToken(scale->toStdString());
    const auto guess = asymptote(arguments, QStringLiteral("guess"), true, Asymptote::fixedAt(0.5));
    const auto lapse = asymptote(arguments, QStringLiteral("lapse"), false, Asymptote::fitted());
    CHIRON_TRY(guess);
    CHIRON_TRY(lapse);
    options.guess = *guess;
    options.lapse = *lapse;
    if (guess->rule == Asymptote::Rule::equal && lapse->rule == Asymptote::Rule::fixed &&
        !(lapse->value < 0.5))
        return wrongUse(
            QStringLiteral("--guess equal, --lapse %1: expected a lapse below 0.5, which both are")
                .arg(lapse->value));
    const bool bothFixed = guess->rule == Asymptote::Rule::fixed && lapse->rule == Asymptote::Rule::fixed;
    if (bothFixed && !(guess->value + lapse->value < 1.0))
        return wrongUse(QStringLiteral("--guess %1, --lapse %2: expected less than 1 together")
                            .arg(guess->value)
                            .arg(lapse->value));
    return options;
}

QJsonObject groupJson(const QStringList& by, const QStringList& group) {
    QJsonObject json;
    for (qsizetype i = 0; i < by.size(); ++i)
        json.insert(by[i], group[i]);
    return json;
}

std::vector<OptionSpec> answerOptions() {
    return {{"intensity", "COLUMN", "where the intensities are; default: intensity"},
            {"correct", "COLUMN",
             "rows are single trials, and this column says 1 (right) or 0 (wrong); default: correct, where "
             "there is no n_correct"},
            {"drop-bad",
             {},
             "leave out rows that cannot be (no answer, more right than there were), instead of refusing the "
             "file"}};
}

std::vector<OptionSpec> curveOptions() {
    return {{"function", "NAME",
             "logistic, gauss, weibull, gumbel, rgumbel, logn, hyperbolic or tdist; default: gauss"},
            {"guess", "G", "a proportion, free, or equal (as the lapse); default: 0.5"},
            {"lapse", "L", "a proportion or free; default: free"},
            {"scale", "WORD",
             "axis it is fitted on: linear, ln, log10, db; default: ln for weibull and logn, else linear"}};
}

} // namespace chiron::cli
