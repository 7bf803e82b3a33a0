// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/marked_texts.h"
#include "scoring/metric.h"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace chiron::scoring {

/// What a new version of a metric changes; the rest stays as it was, its words with it.
struct NextVersion {
    std::optional<Direction> direction{};
    std::optional<MetricWrench> wrench{};
    std::optional<MetricTools> tools{};
    std::optional<bool> needsForces{};
    std::string_view definition;
    std::optional<std::string_view> source{};
    Measurement (*measure)(std::span<const PreparedTrial> trials) = nullptr;
};

/// The rows of one subject, in the order in which metrics are listed.
class MetricRows {
public:
    void add(MetricDefinition metric) { m_rows.push_back(std::move(metric)); }
    /// The next version of the row before.
    void next(const NextVersion& change) {
        MetricDefinition metric = m_rows.back();
        ++metric.version;
        metric.direction = change.direction.value_or(metric.direction);
        metric.wrench = change.wrench.value_or(metric.wrench);
        metric.tools = change.tools.value_or(metric.tools);
        metric.needsForces = change.needsForces.value_or(metric.needsForces);
        metric.definition = change.definition;
        metric.source = change.source.value_or(metric.source);
        metric.measure = change.measure;
        m_rows.push_back(std::move(metric));
    }
    std::vector<MetricDefinition> take() { return std::move(m_rows); }

private:
    std::vector<MetricDefinition> m_rows;
};

// One function a subject that several exercises share, in the file of its name; metric_catalogue.cpp lists them and those of single exercises.
std::vector<MetricDefinition> motionMetrics();
std::vector<MetricDefinition> forceMetrics();
std::vector<MetricDefinition> torqueMetrics();
std::vector<MetricDefinition> outcomeMetrics();
std::vector<MetricDefinition> predictionMetrics();

} // namespace chiron::scoring
