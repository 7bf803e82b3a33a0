// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace chiron::session {

/// The values that must not be exceeded at a level. Each has a single number everywhere in the program: the
/// level's own limit, or the pass mark on the largest value if that is stricter.
struct LevelLimits {
    double force_N = 4.0; ///< on the tissue
    /// Of the exercise's own metrics (ExerciseKind::limitedMetrics), in their units; a metric that nothing
    /// limits is left out.
    std::vector<std::pair<std::string_view, double>> others{};

    /// The limit of one of `others`, by the metric's id; empty if nothing limits it.
    std::optional<double> of(std::string_view metric) const;
};

/// Pure function.
LevelLimits levelLimits(const catalogue::ExerciseLevel& level);

/// The level's own limit, N, if the pass mark on the largest value allows a small excess over it: exceeding
/// the limit within the reaction time is not a failure. Empty if the pass mark is as strict as the limit, or
/// applies to another quantity. Pure function.
std::optional<double> limitBehind(const catalogue::ExerciseLevel& level, const scoring::Gate& gate);

} // namespace chiron::session
