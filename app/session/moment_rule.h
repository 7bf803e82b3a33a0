// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/playback_mark.h"
#include "session/worst_moment.h"

#include <optional>
#include <string_view>
#include <vector>

namespace chiron::session {

/// A rule that locates the worst moment of one of an exercise's own metrics, for metrics without a
/// PlaybackPeak.
struct MomentRule {
    enum class By {
        largestMark,     ///< the mark with the largest value, of the first of `marks`
        firstMark,       ///< the first mark of any of `marks`; the value shown is the metric's
        largestQuantity, ///< the moment at which one of the scene's quantities was largest
        own              ///< as the exercise's own function finds it
    };
    std::string_view metric; ///< metric id; a trailing '*' matches every id with this beginning
    By by = By::firstMark;
    /// For By::own; returns nothing if the recording has no such moment.
    std::optional<WorstMoment> (*own)(const PlaybackTrack& track) = nullptr;
    std::vector<PlaybackMarkKind> marks{};
    std::string_view quantity{}; ///< one of ExerciseKind::quantities
    double factor = 1.0;         ///< factor of the mark's value that gives the unit
    std::string_view unit{};
    bool onlyCritical = false; ///< largestMark: only marks that the metric critical_errors counts
    /// The metric is spread over a trial, so that a moment of any other missed gate comes before this one.
    bool spread = false;
    bool ofWholeTrial = false; ///< what happened concerns the trial as a whole, whose end is the moment

    bool isOf(std::string_view id) const noexcept {
        return metric.ends_with('*') ? id.starts_with(metric.substr(0, metric.size() - 1)) : id == metric;
    }
};

} // namespace chiron::session
