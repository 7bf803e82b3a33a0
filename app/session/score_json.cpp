// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/score_json.h"

#include <QJsonObject>
#include <cmath>

namespace chiron::session {

namespace {

QJsonObject metricJson(const scoring::MetricValue& metric) {
    QJsonObject json{{QStringLiteral("id"), QString::fromStdString(metric.id)},
                     {QStringLiteral("version"), metric.version},
                     {QStringLiteral("unit"), QString::fromStdString(metric.unit)}};
    const bool defined = metric.value && std::isfinite(*metric.value);
    json[QStringLiteral("value")] = defined ? QJsonValue(*metric.value) : QJsonValue(QJsonValue::Null);
    if (!defined)
        json[QStringLiteral("reason")] = QString::fromStdString(metric.reason);
    json[QStringLiteral("passed")] =
        metric.passed ? QJsonValue(*metric.passed) : QJsonValue(QJsonValue::Null);
    return json;
}

} // namespace

QJsonArray metricsJson(const std::vector<scoring::MetricValue>& metrics) {
    QJsonArray array;
    for (const scoring::MetricValue& metric : metrics)
        array.append(metricJson(metric));
    return array;
}

} // namespace chiron::session
