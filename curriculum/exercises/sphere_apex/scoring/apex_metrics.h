// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"

#include <vector>

namespace chiron::scoring {

/// Returns the rows of the metrics that only this exercise has.
std::vector<MetricDefinition> apexMetrics();

} // namespace chiron::scoring
