// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/marked_texts.h"
#include "scoring/metric.h"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace chiron::scoring {

/// The changes in a new version of a metric. Everything else, including its texts, stays the same; a
/// published band does not: it belongs to the version that measures what the publication did.
struct NextVersion {
    std::optional<Direction> direction{};
    std::optional<MetricWrench> wrench{};
    std::optional<MetricTools> tools{};
    std::optional<bool> needsForces{};
    std::string_view definition;
    std::optional<std::string_view> source{};
    std::optional<PublishedBand> published{};
    Measurement (*measure)(std::span<const PreparedTrial> trials) = nullptr;
};

/// Collects the rows of one subject, in the order in which metrics are listed.
class MetricRows {
public:
    void add(MetricDefinition metric) { m_rows.push_back(std::move(metric)); }
    /// Adds the next version of the previous row.
    void next(const NextVersion& change) {
        MetricDefinition metric = m_rows.back();
        ++metric.version;
        metric.direction = change.direction.value_or(metric.direction);
        metric.wrench = change.wrench.value_or(metric.wrench);
        metric.tools = change.tools.value_or(metric.tools);
        metric.needsForces = change.needsForces.value_or(metric.needsForces);
        metric.definition = change.definition;
        metric.source = change.source.value_or(metric.source);
        metric.published = change.published;
        metric.measure = change.measure;
        m_rows.push_back(std::move(metric));
    }
    std::vector<MetricDefinition> take() { return std::move(m_rows); }

private:
    std::vector<MetricDefinition> m_rows;
};

// One function per subject that several exercises share, in the file of that name. metric_catalogue.cpp lists
// them together with those of single exercises.
std::vector<MetricDefinition> motionMetrics();
std::vector<MetricDefinition> forceMetrics();
std::vector<MetricDefinition> torqueMetrics();
std::vector<MetricDefinition> outcomeMetrics();
std::vector<MetricDefinition> predictionMetrics();

} // namespace chiron::scoring
