// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/metric_words.h"

#include "scoring/metric_catalogue.h"
#include "scoring/undefined_reason.h"

#include <QCoreApplication>
#include <algorithm>
#include <string>
#include <string_view>

namespace chiron::session_report {

namespace {

QString inLanguage(const QString& text, const char* source) {
    return text == QString::fromUtf8(source) ? QCoreApplication::translate("Metrics", source) : QString();
}

QString translated(std::string_view marked) {
    return QCoreApplication::translate("Metrics", std::string(marked).c_str());
}

const scoring::MetricDefinition* newest(const QString& id) {
    return scoring::findMetric(id.toStdString());
}

std::optional<double> valueIn(const scoring::ScoreCard& card, std::string_view id) {
    const auto found = std::find_if(card.metrics.begin(), card.metrics.end(),
                                    [id](const auto& metric) { return metric.id == id; });
    return found == card.metrics.end() ? std::nullopt : found->value;
}

} // namespace

QString metricTitle(const QString& id, int trials) {
    const scoring::MetricDefinition* metric = newest(id);
    if (!metric)
        return QString(id).replace(QLatin1Char('_'), QLatin1Char(' '));
    return translated(trials == 1 && !metric->titleOfOneTrial.empty() ? metric->titleOfOneTrial
                                                                      : metric->title);
}

QString metricMeaning(const QString& id, int trials) {
    const scoring::MetricDefinition* metric = newest(id);
    if (!metric)
        return {};
    return translated(trials == 1 && !metric->meaningOfOneTrial.empty() ? metric->meaningOfOneTrial
                                                                        : metric->meaning);
}

QString momentTitle(const QString& id) {
    const scoring::MetricDefinition* metric = newest(id);
    return metric && !metric->titleAtMoment.empty() ? translated(metric->titleAtMoment) : metricTitle(id);
}

QString metricWholly(const QString& id) {
    const scoring::MetricDefinition* metric = newest(id);
    return metric && !metric->wholly.empty() ? translated(metric->wholly) : QString();
}

QString metricReason(const QString& stored) {
    const auto undefined = scoring::undefinedOf(stored.toStdString());
    if (!undefined)
        return stored;
    QString words = translated(undefined->reason.words);
    for (std::size_t i = 0; i < scoring::countsOf(undefined->reason); ++i)
        words = words.arg(undefined->counts[i]);
    return words;
}

QString unitText(const QString& unit) {
    constexpr const char* kOfRadius = QT_TRANSLATE_NOOP("Metrics", "% of R");
    const QString words = inLanguage(unit, kOfRadius);
    return words.isEmpty() ? unit : words;
}

QString bandSourceText(const QString& source) {
    return translated(source.toStdString());
}

std::optional<double> chanceOf(const std::string& id, const scoring::ScoreCard& card) {
    const scoring::MetricDefinition* metric = scoring::findMetric(id);
    if (metric == nullptr)
        return std::nullopt;
    return metric->chance.metric.empty() ? metric->chance.value : valueIn(card, metric->chance.metric);
}

} // namespace chiron::session_report
