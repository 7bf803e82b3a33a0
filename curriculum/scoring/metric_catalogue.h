// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"

#include <span>
#include <string_view>

namespace chiron::scoring {

/// Every metric in every version, subject by subject; each subject is a file in metrics/ and a line in metric_catalogue.cpp.
std::span<const MetricDefinition> metricCatalogue();

/// The entry with this id and version; version 0 is the newest. Null if there is none.
const MetricDefinition* findMetric(std::string_view id, int version = 0);

} // namespace chiron::scoring
