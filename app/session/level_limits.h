// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"

#include <optional>

namespace chiron::session {

/// What must not be exceeded at a level. One number for each, wherever a person meets it: the level's own limit, or the pass mark on the
/// largest value where that is stricter.
struct LevelLimits {
    double force_N = 4.0;               ///< on the tissue
    std::optional<double> squeeze_N;    ///< between the jaws of a grasper
    std::optional<double> lateral_N;    ///< across a canal
    std::optional<double> retraction_N; ///< pull on a fold
    std::optional<double> placement_mm; ///< from the middle of the target, in the mean over the trials
};

/// Pure.
LevelLimits levelLimits(const catalogue::ExerciseLevel& level);

/// The level's limit that a pass mark on the largest value lets be passed by a little, N: what it takes to react is no failure. Absent
/// where the pass mark is as strict as the limit, or is on something else. Pure.
std::optional<double> limitBehind(const catalogue::ExerciseLevel& level, const scoring::Gate& gate);

} // namespace chiron::session
