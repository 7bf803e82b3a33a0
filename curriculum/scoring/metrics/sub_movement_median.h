// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <span>

namespace chiron::scoring {

/// The median over the sub-movements of all trials of one smoothness measure. Sub-movements for which it is
/// undefined are left out; undefined where none is left.
Measurement subMovementMedian(std::span<const PreparedTrial> trials, Motion PreparedTrial::*motion,
                              Measurement (*measure)(std::span<const double> speed, double dt_s));

} // namespace chiron::scoring
