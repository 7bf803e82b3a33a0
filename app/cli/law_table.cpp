// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/law_table.h"

#include "cli/cli_errors.h"
#include "cli/input_file.h"
#include "mechanisms/mechanism_laws.h"
#include "simulation/evaluate_laws.h"

#include <QJsonObject>
#include <QStringList>
#include <charconv>
#include <cmath>
#include <system_error>

namespace chiron::cli {

namespace {

QString text(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

QString inputNames(const core::LawDescription& law) {
    QStringList names;
    for (const core::LawColumn& column : law.inputs)
        names << text(column.name);
    return names.join(QLatin1Char(','));
}

const core::LawParameter* findParameter(const core::LawDescription& law, const QString& name) {
    for (const core::LawParameter& parameter : law.parameters) {
        if (text(parameter.name) == name)
            return &parameter;
    }
    return nullptr;
}

// Maps each field of a line to an input column.
core::Result<std::vector<std::size_t>> readHeader(const core::LawDescription& law,
                                                  const QList<QByteArray>& fields, const QString& name) {
    const QString expected = QStringLiteral("expected the columns %1, each once").arg(inputNames(law));
    std::vector<std::size_t> order(law.inputs.size(), SIZE_MAX);
    for (qsizetype i = 0; i < fields.size(); ++i) {
        const QString field = QString::fromUtf8(fields[i]).trimmed();
        std::size_t column = 0;
        while (column < law.inputs.size() && text(law.inputs[column].name) != field)
            ++column;
        if (column == law.inputs.size() || order[column] != SIZE_MAX)
            return badInput(
                QStringLiteral("%1:1:%2: %3: %4").arg(name).arg(i + 1).arg(quoted(field), expected));
        order[column] = static_cast<std::size_t>(i);
    }
    for (std::size_t column = 0; column < order.size(); ++column) {
        if (order[column] == SIZE_MAX)
            return badInput(QStringLiteral("%1:1: column %2 is missing; %3")
                                .arg(name, quoted(text(law.inputs[column].name)), expected));
    }
    return order;
}

// Accepts a decimal number and nothing else, independently of the locale.
bool readNumber(const QByteArray& field, double& value) {
    const QByteArray trimmed = field.trimmed();
    const char* begin = trimmed.constData();
    const char* end = begin + trimmed.size();
    if (begin != end && *begin == '+')
        ++begin;
    const auto read = std::from_chars(begin, end, value);
    return read.ec == std::errc() && read.ptr == end && begin != end && std::isfinite(value);
}

core::Result<std::vector<double>> readRow(const QList<QByteArray>& fields,
                                          const std::vector<std::size_t>& order, const QString& name,
                                          qsizetype line) {
    if (fields.size() != static_cast<qsizetype>(order.size()))
        return badInput(QStringLiteral("%1:%2: %3 fields; expected %4")
                            .arg(name)
                            .arg(line)
                            .arg(fields.size())
                            .arg(order.size()));
    std::vector<double> row(order.size());
    for (std::size_t column = 0; column < order.size(); ++column) {
        const QByteArray& field = fields[static_cast<qsizetype>(order[column])];
        if (!readNumber(field, row[column]))
            return badInput(QStringLiteral("%1:%2:%3: %4: expected a finite number")
                                .arg(name)
                                .arg(line)
                                .arg(order[column] + 1)
                                .arg(quoted(QString::fromUtf8(field))));
    }
    return row;
}

} // namespace

const std::vector<const core::LawDescription*>& allLaws() {
    static const std::vector<const core::LawDescription*> laws = [] {
        std::vector<const core::LawDescription*> all;
        for (const auto& module : {simulation::evaluateLaws(), mechanisms::evaluateLaws()}) {
            for (const core::LawDescription& law : module)
                all.push_back(&law);
        }
        return all;
    }();
    return laws;
}

const core::LawDescription* findLaw(const QString& id) {
    for (const core::LawDescription* law : allLaws()) {
        if (text(law->id) == id)
            return law;
    }
    return nullptr;
}

QString lawNames() {
    QStringList names;
    for (const core::LawDescription* law : allLaws())
        names << text(law->id);
    return names.join(QStringLiteral(", "));
}

core::Result<std::vector<double>> readLawParameters(const core::LawDescription& law, const QString& path) {
    QJsonObject given;
    if (!path.isEmpty()) {
        auto read = readJsonObject(path);
        CHIRON_TRY(read);
        given = *read;
    }
    for (auto it = given.begin(); it != given.end(); ++it) {
        const core::LawParameter* parameter = findParameter(law, it.key());
        if (!parameter) {
            QStringList names;
            for (const core::LawParameter& known : law.parameters)
                names << text(known.name);
            return badInput(
                QStringLiteral("%1: $.%2: unknown parameter; expected %3")
                    .arg(path, printable(it.key()),
                         names.isEmpty() ? QStringLiteral("none") : names.join(QStringLiteral(", "))));
        }
        const double value = it.value().toDouble(std::nan(""));
        if (!(value >= parameter->minimum && value <= parameter->maximum))
            return badInput(QStringLiteral("%1: $.%2: %3: expected a number from %4 to %5 %6")
                                .arg(path, it.key(),
                                     it.value().isDouble() ? QString::number(value)
                                                           : quoted(it.value().toVariant().toString()))
                                .arg(parameter->minimum)
                                .arg(parameter->maximum)
                                .arg(text(parameter->unit)));
        if (parameter->whole && value != std::floor(value))
            return badInput(QStringLiteral("%1: $.%2: %3: expected a whole number")
                                .arg(path, it.key(), QString::number(value)));
    }
    std::vector<double> values;
    for (const core::LawParameter& parameter : law.parameters)
        values.push_back(given.value(text(parameter.name)).toDouble(parameter.defaultValue));
    if (const std::string problem = law.problem ? law.problem(values, {}) : std::string(); !problem.empty())
        return badInput(QStringLiteral("%1: %2").arg(path, QString::fromStdString(problem)));
    return values;
}

core::Result<LawTable> readLawTable(const core::LawDescription& law, const QByteArray& csv,
                                    const QString& name) {
    QByteArray body = csv.startsWith("\xef\xbb\xbf") ? csv.mid(3) : csv;
    while (body.endsWith('\n') || body.endsWith('\r'))
        body.chop(1);
    if (body.isEmpty())
        return badInput(QStringLiteral("%1:1: empty; expected a header line %2 and rows of numbers")
                            .arg(name, inputNames(law)));
    const QList<QByteArray> lines = body.split('\n');
    const auto order = readHeader(law, lines[0].split(','), name);
    CHIRON_TRY(order);
    if (!csv.endsWith('\n'))
        return badInput(QStringLiteral("%1:%2: the last line has no line feed: expected one after every row, "
                                       "or the table was cut off")
                            .arg(name)
                            .arg(lines.size()));
    LawTable table;
    for (qsizetype i = 1; i < lines.size(); ++i) {
        auto row = readRow(lines[i].split(','), *order, name, i + 1);
        CHIRON_TRY(row);
        table.rows.push_back(std::move(*row));
    }
    return table;
}

core::Result<std::vector<std::vector<double>>> evaluateLaw(const core::LawDescription& law,
                                                           const std::vector<double>& parameters,
                                                           const LawTable& table, const QString& name) {
    std::vector<std::vector<double>> results;
    results.reserve(table.rows.size());
    for (const std::vector<double>& row : table.rows) {
        const auto refuse = [&](const QString& why) {
            return badInput(QStringLiteral("%1:%2: %3").arg(name).arg(results.size() + 2).arg(why));
        };
        if (const std::string problem = law.problem ? law.problem(parameters, row) : std::string();
            !problem.empty())
            return refuse(QString::fromStdString(problem));
        std::vector<double> values(law.outputs.size(), 0.0);
        law.evaluate(parameters, row, values);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!std::isfinite(values[i]))
                return refuse(QStringLiteral(
                                  "%1 is no finite number: expected inputs of a size that the law can answer")
                                  .arg(text(law.outputs[i].name)));
        results.push_back(std::move(values));
    }
    return results;
}

} // namespace chiron::cli
