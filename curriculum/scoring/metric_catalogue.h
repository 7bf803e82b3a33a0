// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"

#include <span>
#include <string_view>

namespace chiron::scoring {

/// Returns every metric in every version, ordered by subject. Each subject is a file in metrics/ and a line
/// in metric_catalogue.cpp.
std::span<const MetricDefinition> metricCatalogue();

/// Returns the entry with this id and version, where version 0 means the newest; null if there is none.
const MetricDefinition* findMetric(std::string_view id, int version = 0);

} // namespace chiron::scoring
