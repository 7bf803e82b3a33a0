// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <optional>

namespace chiron::session {

/// The values that must not be exceeded at a level. Each has a single number everywhere in the program: the
/// level's own limit, or the pass mark on the largest value if that is stricter.
struct LevelLimits {
    double force_N = 4.0;               ///< on the tissue
    std::optional<double> squeeze_N;    ///< between the jaws of a grasper
    std::optional<double> lateral_N;    ///< across a canal
    std::optional<double> retraction_N; ///< pull on a fold
    std::optional<double> placement_mm; ///< from the target's centre, mean over the trials
};

/// Pure function.
LevelLimits levelLimits(const catalogue::ExerciseLevel& level);

/// The level's own limit, N, if the pass mark on the largest value allows a small excess over it: exceeding
/// the limit within the reaction time is not a failure. Empty if the pass mark is as strict as the limit, or
/// applies to another quantity. Pure function.
std::optional<double> limitBehind(const catalogue::ExerciseLevel& level, const scoring::Gate& gate);

} // namespace chiron::session
