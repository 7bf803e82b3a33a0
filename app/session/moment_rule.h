// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_mark.h"

#include <string_view>
#include <vector>

namespace chiron::session {

/// How to find where one of an exercise's own metrics was worst, for those without a PlaybackPeak.
struct MomentRule {
    enum class By {
        largestMark,     ///< the mark of the first of the kinds with the largest value
        firstMark,       ///< the first mark, of the first of the kinds that there is; the metric's own value goes with it
        largestQuantity, ///< where one of the scene's quantities was largest
        farthestAnswer   ///< the answer farthest from what was to be found, in per cent of its radius
    };
    std::string_view metric; ///< its id; with '*' at the end, of all that begin so
    By by = By::firstMark;
    std::vector<PlaybackMarkKind> marks{};
    std::string_view quantity{}; ///< ExerciseKind::quantities
    double factor = 1.0;         ///< of the mark's value, for the unit
    std::string_view unit{};

    bool isOf(std::string_view id) const noexcept {
        return metric.ends_with('*') ? id.starts_with(metric.substr(0, metric.size() - 1)) : id == metric;
    }
};

} // namespace chiron::session
