// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/metric_words.h"

#include "scoring/metric_catalogue.h"
#include "scoring/undefined_reason.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace chiron::session_report {

namespace {

constexpr std::array<const char*, 1> kBandSources{{
    QT_TRANSLATE_NOOP("Metrics", "published, 5 subjects × 10"),
}};

constexpr const char* kApexMean = "apex_error_mean"; // the one title that says it is a mean over trials
constexpr const char* kApexError = QT_TRANSLATE_NOOP("Metrics", "Apex error");
constexpr const char* kApexErrorMeaning =
    QT_TRANSLATE_NOOP("Metrics", "How far the mark lay from the highest point, in % of the radius, on average left to right and front to back.");
constexpr const char* kLargestMisalignment = QT_TRANSLATE_NOOP("Metrics", "Largest misalignment");
/// What is spread over a session, and what its largest value is called.
constexpr std::array<std::pair<const char*, const char*>, 5> kLargestOf{{{"force_mean", "force_max"},
                                                                         {"force_rms", "force_max"},
                                                                         {"force_p95", "force_max"},
                                                                         {"offset_rms", "offset_max"},
                                                                         {"torque_rms", "torque_max"}}};

QString inLanguage(const QString& text, const char* source) {
    return text == QString::fromUtf8(source) ? QCoreApplication::translate("Metrics", source) : QString();
}

QString translated(std::string_view marked) { return QCoreApplication::translate("Metrics", std::string(marked).c_str()); }

const scoring::MetricDefinition* newest(const QString& id) { return scoring::findMetric(id.toStdString()); }

std::optional<double> valueIn(const scoring::ScoreCard& card, std::string_view id) {
    const auto found = std::find_if(card.metrics.begin(), card.metrics.end(), [id](const auto& metric) { return metric.id == id; });
    return found == card.metrics.end() ? std::nullopt : found->value;
}

} // namespace

QString metricTitle(const QString& id, int trials) {
    if (trials == 1 && id == QLatin1String(kApexMean))
        return QCoreApplication::translate("Metrics", kApexError);
    const scoring::MetricDefinition* metric = newest(id);
    return metric ? translated(metric->title) : QString(id).replace(QLatin1Char('_'), QLatin1Char(' '));
}

QString metricMeaning(const QString& id, int trials) {
    if (trials == 1 && id == QLatin1String(kApexMean))
        return QCoreApplication::translate("Metrics", kApexErrorMeaning);
    const scoring::MetricDefinition* metric = newest(id);
    return metric ? translated(metric->meaning) : QString();
}

QString momentTitle(const QString& id) {
    if (id.startsWith(QLatin1String("apex_")))
        return QCoreApplication::translate("Metrics", kApexError);
    if (id == QLatin1String("alignment_rms"))
        return QCoreApplication::translate("Metrics", kLargestMisalignment);
    for (const auto& [spread, largest] : kLargestOf)
        if (id == QLatin1String(spread))
            return metricTitle(QLatin1String(largest));
    return metricTitle(id);
}

QString metricReason(const QString& stored) {
    const auto undefined = scoring::undefinedOf(stored.toStdString());
    if (!undefined)
        return stored;
    QString words = translated(scoring::wordsOf(undefined->reason));
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
    for (const char* known : kBandSources)
        if (const QString text = inLanguage(source, known); !text.isEmpty())
            return text;
    return source;
}

std::optional<double> chanceOf(const std::string& id, const scoring::ScoreCard& card) {
    const scoring::MetricDefinition* metric = scoring::findMetric(id);
    if (metric == nullptr)
        return std::nullopt;
    return metric->chance.metric.empty() ? metric->chance.value : valueIn(card, metric->chance.metric);
}

} // namespace chiron::session_report
