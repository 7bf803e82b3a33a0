// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/input_file.h"
#include "cli/law_table.h"
#include "cli/text_table.h"
#include "core/fp_environment.h"

#include <QJsonArray>
#include <QJsonObject>
#include <cmath>

namespace chiron::cli {

namespace {

QString fromView(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

QJsonArray columnsJson(std::span<const core::LawColumn> columns) {
    QJsonArray array;
    for (const core::LawColumn& column : columns)
        array.append(QJsonObject{{QStringLiteral("name"), fromView(column.name)},
                                 {QStringLiteral("unit"), fromView(column.unit)}});
    return array;
}

CommandOutput listLaws() {
    QJsonArray json;
    QString words;
    for (const core::LawDescription* law : allLaws()) {
        QJsonArray parameters;
        TextTable table({QStringLiteral("kind"), QStringLiteral("name"), QStringLiteral("unit"),
                         QStringLiteral(">default"), QStringLiteral(">from"), QStringLiteral(">to")});
        for (const core::LawParameter& parameter : law->parameters) {
            parameters.append(QJsonObject{{QStringLiteral("name"), fromView(parameter.name)},
                                          {QStringLiteral("unit"), fromView(parameter.unit)},
                                          {QStringLiteral("default"), parameter.defaultValue},
                                          {QStringLiteral("minimum"), parameter.minimum},
                                          {QStringLiteral("maximum"), parameter.maximum}});
            table.add({QStringLiteral("parameter"), fromView(parameter.name), fromView(parameter.unit),
                       shortNumber(parameter.defaultValue), shortNumber(parameter.minimum),
                       shortNumber(parameter.maximum)});
        }
        for (const core::LawColumn& column : law->inputs)
            table.add({QStringLiteral("input"), fromView(column.name), fromView(column.unit)});
        for (const core::LawColumn& column : law->outputs)
            table.add({QStringLiteral("output"), fromView(column.name), fromView(column.unit)});
        json.append(QJsonObject{{QStringLiteral("id"), fromView(law->id)},
                                {QStringLiteral("title"), fromView(law->title)},
                                {QStringLiteral("source"), fromView(law->source)},
                                {QStringLiteral("parameters"), parameters},
                                {QStringLiteral("inputs"), columnsJson(law->inputs)},
                                {QStringLiteral("outputs"), columnsJson(law->outputs)}});
        words += QStringLiteral("%1: %2 (%3)\n%4\n")
                     .arg(fromView(law->id), fromView(law->title), fromView(law->source), table.toText());
    }
    return {QJsonDocument(json), words, 0};
}

CommandOutput tableOutput(const core::LawDescription& law, const LawTable& in,
                          const std::vector<std::vector<double>>& out, bool withInputs) {
    QStringList names;
    QJsonArray columns = columnsJson(law.outputs);
    if (withInputs) {
        columns = columnsJson(law.inputs);
        for (const QJsonValue& column : columnsJson(law.outputs))
            columns.append(column);
    }
    for (const QJsonValue& column : std::as_const(columns))
        names << column[QStringLiteral("name")].toString();
    QString csv = names.join(QLatin1Char(',')) + QLatin1Char('\n');
    QJsonArray rows;
    for (std::size_t i = 0; i < out.size(); ++i) {
        std::vector<double> values = withInputs ? in.rows[i] : std::vector<double>();
        values.insert(values.end(), out[i].begin(), out[i].end());
        QStringList cells;
        QJsonArray row;
        for (const double value : values) {
            cells << exactNumber(value);
            row.append(value);
        }
        csv += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
        rows.append(row);
    }
    const QJsonObject json{{QStringLiteral("model"), fromView(law.id)},
                           {QStringLiteral("columns"), columns},
                           {QStringLiteral("rows"), rows}};
    return {QJsonDocument(json), csv, 0};
}

core::Result<CommandOutput> evaluate(const Arguments& arguments) {
    const QString id = arguments.operand(0);
    if (arguments.has(QStringLiteral("list"))) {
        if (!id.isEmpty())
            return wrongUse(QStringLiteral("%1: expected no model beside --list").arg(quoted(id)));
        return listLaws();
    }
    if (id.isEmpty())
        return wrongUse(QStringLiteral("MODEL is missing; expected one of %1, or --list").arg(lawNames()));
    const core::LawDescription* law = findLaw(id);
    if (!law)
        return core::fail(core::ErrorCode::notFound,
                          QStringLiteral("MODEL %1: no such law; expected one of %2")
                              .arg(quoted(id), lawNames())
                              .toStdString());
    const auto parameters = readLawParameters(*law, arguments.value(QStringLiteral("parameters")));
    CHIRON_TRY(parameters);
    constexpr qint64 kLargest = qint64{256} << 20;
    const auto bytes = readStandardInput(kLargest);
    CHIRON_TRY(bytes);
    const auto table = readLawTable(*law, *bytes, QStringLiteral("stdin"));
    CHIRON_TRY(table);
    core::setModelFloatingPointEnvironment();
    const auto results = evaluateLaw(*law, *parameters, *table, QStringLiteral("stdin"));
    CHIRON_TRY(results);
    return tableOutput(*law, *table, *results, arguments.has(QStringLiteral("with-inputs")));
}

} // namespace

std::vector<CommandSpec> evaluateCommands() {
    CommandSpec command;
    command.group = QStringLiteral("evaluate");
    command.summary =
        QStringLiteral("evaluate a law of the models over a table of inputs (CSV on stdin, CSV on stdout)");
    command.operands = {{QStringLiteral("MODEL"), QStringLiteral("the law's id, as --list shows it"), false}};
    command.options = {
        {QStringLiteral("list"), {}, QStringLiteral("list the laws with their parameters and columns")},
        {QStringLiteral("parameters"), QStringLiteral("P.json"),
         QStringLiteral("an object of parameter values; the others keep their defaults")},
        {QStringLiteral("with-inputs"), {}, QStringLiteral("repeat the input columns before the results")}};
    command.example = QStringLiteral("chiron-cli evaluate hemisphere --parameters P.json < IN.csv > OUT.csv");
    command.run = evaluate;
    return {command};
}

} // namespace chiron::cli
