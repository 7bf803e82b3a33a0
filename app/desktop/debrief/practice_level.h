// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <string_view>

namespace chiron::desktop {

/// The level of the same exercise on which a metric that was missed at `level` is best practised: of the
/// lower levels with a pass mark for it, the highest that gives feedback, or else the highest. Null if no
/// lower level judges the metric.
const catalogue::ExerciseLevel* practiceLevel(const catalogue::Exercise& exercise, int level,
                                              std::string_view metric);

} // namespace chiron::desktop
