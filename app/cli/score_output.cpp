// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/score_output.h"

#include "cli/text_table.h"
#include "session_report/metric_words.h"

#include <cmath>

namespace chiron::cli {

namespace {

QString passedWord(const std::optional<bool>& passed) {
    return !passed ? QString() : *passed ? QStringLiteral("yes") : QStringLiteral("NO");
}

} // namespace

QJsonArray trialsJson(const scoring::ScoreCard& card, const std::vector<TrialEnding>& endings) {
    QJsonArray trials;
    for (std::size_t i = 0; i < card.trials.size(); ++i) {
        QJsonObject trial{{QStringLiteral("trial"), static_cast<int>(i) + 1},
                          {QStringLiteral("metrics"), metricsJson(card.trials[i])}};
        if (i < endings.size()) {
            const TrialEnding& ending = endings[i];
            if (!ending.state.isEmpty())
                trial[QStringLiteral("state")] = ending.state;
            trial[QStringLiteral("marked")] = ending.marked;
            trial[QStringLiteral("timed_out")] = ending.timedOut;
            trial[QStringLiteral("failed")] = ending.failed;
            trial[QStringLiteral("flag")] = ending.marked       ? QJsonValue()
                                            : ending.unfinished ? QJsonValue(QStringLiteral("unfinished"))
                                            : ending.failed     ? QJsonValue(QStringLiteral("failed"))
                                                                : QJsonValue(QStringLiteral("no_mark"));
        }
        trials.append(trial);
    }
    return trials;
}

QString flaggedText(const std::vector<TrialEnding>& endings) {
    QStringList numbers;
    QStringList failed;
    QStringList unfinished;
    for (std::size_t i = 0; i < endings.size(); ++i) {
        if (endings[i].unfinished)
            unfinished << QString::number(i + 1);
        else if (endings[i].failed)
            failed << QString::number(i + 1);
        else if (!endings[i].marked)
            numbers << QString::number(i + 1);
    }
    const auto line = [](const QString& words, const QStringList& trials) {
        return trials.isEmpty() ? QString() : words.arg(trials.join(QStringLiteral(", ")));
    };
    return line(QStringLiteral("\nnot marked, so the last position is scored: trial %1\n"), numbers) +
           line(QStringLiteral("\ncould not be done to its end: trial %1\n"), failed) +
           line(QStringLiteral("\nnot finished, so in no score: trial %1\n"), unfinished);
}

QJsonObject scoreJson(const ScoreView& view) {
    return {{QStringLiteral("session_id"), view.sessionId},
            {QStringLiteral("state"), view.state},
            {QStringLiteral("passed"), view.card.passed},
            {QStringLiteral("metrics"), metricsJson(view.card.metrics)},
            {QStringLiteral("trials"), trialsJson(view.card, view.trials)},
            {QStringLiteral("loop"), view.loop},
            {QStringLiteral("recording"), view.recording}};
}

QString metricsText(const std::vector<scoring::MetricValue>& metrics) {
    TextTable table({QStringLiteral("metric"), QStringLiteral(">version"), QStringLiteral(">value"),
                     QStringLiteral("unit"), QStringLiteral("passed"), QStringLiteral("note")});
    for (const scoring::MetricValue& metric : metrics)
        table.add(
            {QString::fromStdString(metric.id), QString::number(metric.version),
             metric.value ? shortNumber(*metric.value) : QStringLiteral("-"),
             QString::fromStdString(metric.unit), passedWord(metric.passed),
             metric.value ? QString() : session_report::metricReason(QString::fromStdString(metric.reason))});
    return table.toText();
}

QString scoreText(const ScoreView& view) {
    return QStringLiteral("session %1: %2, %3, %4\n\n")
               .arg(view.sessionId)
               .arg(view.state, view.card.passed ? QStringLiteral("passed") : QStringLiteral("not passed"))
               .arg(view.card.trials.size() == 1 ? QStringLiteral("1 trial")
                                                 : QStringLiteral("%1 trials").arg(view.card.trials.size())) +
           metricsText(view.card.metrics) + flaggedText(view.trials);
}

} // namespace chiron::cli
