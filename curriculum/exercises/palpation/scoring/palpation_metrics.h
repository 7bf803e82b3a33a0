// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"

#include <vector>

namespace chiron::scoring {

/// Return the rows of the metrics that only this exercise has.
std::vector<MetricDefinition> palpationDetectionMetrics();
std::vector<MetricDefinition> palpationFindingsMetrics();
std::vector<MetricDefinition> palpationSearchMetrics();

} // namespace chiron::scoring
