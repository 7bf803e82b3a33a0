// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/score_output.h"
#include "cli/text_table.h"
#include "scoring/metric_catalogue.h"
#include "scoring/score_calculator.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"
#include "session/exercise_kind.h"

namespace chiron::cli {

namespace {

QString allMetricIds() {
    QStringList ids;
    for (const scoring::MetricDefinition& metric : scoring::metricCatalogue()) {
        const QString id = QString::fromUtf8(metric.id.data(), static_cast<qsizetype>(metric.id.size()));
        if (!ids.contains(id))
            ids << id;
    }
    return ids.join(QStringLiteral(", "));
}

core::Result<std::vector<scoring::MetricRequest>> requests(const Arguments& arguments) {
    auto names = arguments.list(QStringLiteral("metric"));
    CHIRON_TRY(names);
    if (names->isEmpty())
        names = allMetricIds().split(QStringLiteral(", "));
    std::vector<scoring::MetricRequest> wanted;
    for (const QString& name : *names) {
        if (!scoring::findMetric(name.toStdString()))
            return badInput(QStringLiteral("--metric: %1: unknown; expected some of %2")
                                .arg(quoted(name), allMetricIds()));
        wanted.push_back({name.toStdString(), 0});
    }
    return wanted;
}

/// Without an exercise the file decides: if it states the correct answer (target), each trial has one answer.
core::Result<scoring::MarkMeaning> markOf(const std::string& exercise, const scoring::TraceColumns& columns) {
    const auto meaning = [](bool ends) {
        return ends ? scoring::MarkMeaning::endsTheTrial : scoring::MarkMeaning::oneOfSeveral;
    };
    if (exercise.empty())
        return meaning(columns.target);
    const auto kind = session::exerciseKind(exercise);
    if (!kind)
        return badInput(QStringLiteral("--exercise: %1").arg(QString::fromStdString(kind.error().message)));
    return meaning((*kind)->markRole() == session::MarkRole::endsTrial);
}

core::Result<CommandOutput> metrics(const Arguments& arguments) {
    const auto wanted = requests(arguments);
    CHIRON_TRY(wanted);
    const auto limit = arguments.number(QStringLiteral("force-limit"), 0.01, 100.0, 4.0);
    CHIRON_TRY(limit);
    const auto rows = scoring::readTraceCsvFile(arguments.operand(0).toStdString());
    CHIRON_TRY(rows);
    const std::string exercise = arguments.value(QStringLiteral("exercise")).toStdString();
    const auto mark = markOf(exercise, rows->columns);
    CHIRON_TRY(mark);
    const auto trace = scoring::buildSessionTrace(*rows, exercise, *limit, *mark);
    CHIRON_TRY(trace);
    const auto card = scoring::calculateScore(*trace, *wanted, {}, true);
    CHIRON_TRY(card);
    std::vector<TrialEnding> endings;
    for (const scoring::TrialTrace& trial : trace->trials)
        endings.push_back(
            {{}, trial.marked || trial.completed, trial.timedOut, trial.failed, trial.unfinished});
    const QJsonObject json{{QStringLiteral("trace"), arguments.operand(0)},
                           {QStringLiteral("metrics"), metricsJson(card->metrics)},
                           {QStringLiteral("trials"), trialsJson(*card, endings)}};
    return CommandOutput{QJsonDocument(json), metricsText(card->metrics) + flaggedText(endings), 0};
}

} // namespace

std::vector<CommandSpec> metricsCommands() {
    CommandSpec command;
    command.group = QStringLiteral("metrics");
    command.summary = QStringLiteral("compute metrics of a trace file");
    command.operands = {{QStringLiteral("TRACE.csv"),
                         QStringLiteral("a trace file: t_s,x_mm,y_mm,z_mm and more, frame W, tool tip")}};
    command.options = {
        {QStringLiteral("metric"), QStringLiteral("ID,..."), QStringLiteral("which metrics; default: all")},
        {QStringLiteral("exercise"), QStringLiteral("ID"),
         QStringLiteral("how trials end; default: at the mark where the file has target columns")},
        {QStringLiteral("force-limit"), QStringLiteral("N"),
         QStringLiteral("limit for 'over the limit' where the file has none; default: 4")}};
    command.example = QStringLiteral("chiron-cli metrics TRACE.csv --metric sparc,ldlj,path_length --json");
    command.run = metrics;
    return {command};
}

} // namespace chiron::cli
