// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/loop_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace chiron::session {

namespace {

std::optional<LatenessBins> binsFrom(const QJsonObject& json) {
    const QJsonArray edges = json.value(QLatin1String("lateness_edges_us")).toArray();
    const QJsonArray counts = json.value(QLatin1String("lateness_counts")).toArray();
    LatenessBins bins;
    if (edges.size() != static_cast<qsizetype>(bins.kEdges_us.size()) ||
        counts.size() != static_cast<qsizetype>(bins.counts.size()))
        return std::nullopt;
    for (qsizetype i = 0; i < edges.size(); ++i) {
        if (edges.at(i).toInteger() != bins.kEdges_us[static_cast<std::size_t>(i)])
            return std::nullopt; // bins of another version cannot be compared
    }
    for (qsizetype i = 0; i < counts.size(); ++i)
        bins.counts[static_cast<std::size_t>(i)] = static_cast<std::uint64_t>(counts.at(i).toInteger());
    return bins;
}

std::optional<double> numberFrom(const QJsonObject& json, const char* key) {
    const QJsonValue value = json.value(QLatin1String(key));
    return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

} // namespace

LatenessBins latenessBinsOf(const haptics::LatencyHistogram& lateness) noexcept {
    LatenessBins bins;
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < bins.kEdges_us.size(); ++i) {
        const std::uint64_t upTo = lateness.countUpTo(bins.kEdges_us[i] * 1000);
        bins.counts[i] = upTo - below;
        below = upTo;
    }
    bins.counts.back() = lateness.count() - below;
    return bins;
}

void setPunctuality(LoopReport& report, const haptics::LoopStatistics& statistics) {
    report.realtime = true;
    report.late = statistics.late();
    report.p50_us = statistics.lateness().percentile_us(0.5);
    report.p99_us = statistics.lateness().percentile_us(0.99);
    report.max_us = static_cast<double>(statistics.lateness().maximum_ns()) * 1e-3;
    report.lateness = latenessBinsOf(statistics.lateness());
}

std::string loopJson(const LoopReport& report) {
    QJsonObject json{{"ticks", static_cast<double>(report.ticks)},
                     {"late", static_cast<double>(report.late)},
                     {"skipped", static_cast<double>(report.skipped)},
                     {"realtime", report.realtime},
                     {"priority_granted", report.priorityGranted},
                     {"priority_detail", QString::fromStdString(report.priorityDetail)}};
    const auto put = [&json](const char* key, const std::optional<double>& value) {
        json.insert(QLatin1String(key), value ? QJsonValue(*value) : QJsonValue());
    };
    put("p50_us", report.p50_us);
    put("p99_us", report.p99_us);
    put("max_us", report.max_us);
    put("passivity_J", report.passivity_J);
    put("passivity_withheld_J", report.passivityWithheld_J);
    if (report.lateness) {
        QJsonArray edges;
        QJsonArray counts;
        for (const std::int64_t edge_us : LatenessBins::kEdges_us)
            edges.append(static_cast<qint64>(edge_us));
        for (const std::uint64_t count : report.lateness->counts)
            counts.append(static_cast<qint64>(count));
        json.insert(QLatin1String("lateness_edges_us"), edges);
        json.insert(QLatin1String("lateness_counts"), counts);
    }
    return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

core::Result<LoopReport> loopReportFrom(const std::string& text) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text));
    if (!document.isObject())
        return core::fail(core::ErrorCode::badInput, "loop statistics: expected a JSON object");
    const QJsonObject json = document.object();
    LoopReport report;
    report.ticks = static_cast<std::uint64_t>(json.value(QLatin1String("ticks")).toInteger());
    report.late = static_cast<std::uint64_t>(json.value(QLatin1String("late")).toInteger());
    report.skipped = static_cast<std::uint64_t>(json.value(QLatin1String("skipped")).toInteger());
    report.realtime = json.value(QLatin1String("realtime")).toBool();
    report.priorityGranted = json.value(QLatin1String("priority_granted")).toBool();
    report.priorityDetail = json.value(QLatin1String("priority_detail")).toString().toStdString();
    report.p50_us = numberFrom(json, "p50_us");
    report.p99_us = numberFrom(json, "p99_us");
    report.max_us = numberFrom(json, "max_us");
    report.passivity_J = numberFrom(json, "passivity_J");
    report.passivityWithheld_J = numberFrom(json, "passivity_withheld_J");
    report.lateness = binsFrom(json);
    return report;
}

} // namespace chiron::session
