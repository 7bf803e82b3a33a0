// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"

#include <vector>

namespace chiron::scoring {

/// The rows of what is measured of this exercise alone.
std::vector<MetricDefinition> canalMetrics();

} // namespace chiron::scoring
