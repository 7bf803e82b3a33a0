// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/level_limits.h"

#include "session/exercise_kind.h"

#include <algorithm>
#include <string_view>

namespace chiron::session {

namespace {

std::optional<double> largestPassed(const catalogue::ExerciseLevel& level, std::string_view metric) {
    const auto gate = std::find_if(level.gates.begin(), level.gates.end(),
                                   [metric](const scoring::Gate& each) { return each.metric == metric; });
    return gate == level.gates.end() ? std::nullopt : gate->maximum;
}

/// The limit that the content sets for a metric, independently of pass marks, N; empty if it sets none.
std::optional<double> ownLimit(const catalogue::ExerciseLevel& level, std::string_view metric) {
    const auto kind = exerciseKind(level.exercise);
    if (!kind)
        return {};
    if (metric == "force_max")
        return (*kind)->forceLimit_N(level);
    for (const auto& [limited, limit_N] : (*kind)->otherLimits_N(level))
        if (limited == metric)
            return limit_N;
    return {};
}

/// The stricter of the two limits, if there is one.
std::optional<double> limitOf(const catalogue::ExerciseLevel& level, std::string_view metric) {
    const std::optional<double> own_N = ownLimit(level, metric), passed_N = largestPassed(level, metric);
    return own_N && passed_N ? std::min(*own_N, *passed_N) : own_N ? own_N : passed_N;
}

} // namespace

LevelLimits levelLimits(const catalogue::ExerciseLevel& level) {
    LevelLimits limits;
    limits.force_N = limitOf(level, "force_max").value_or(limits.force_N);
    limits.squeeze_N = limitOf(level, "squeeze_max");
    limits.lateral_N = limitOf(level, "lateral_max");
    limits.retraction_N = limitOf(level, "retraction_max");
    limits.placement_mm = largestPassed(level, "placement_error");
    return limits;
}

std::optional<double> limitBehind(const catalogue::ExerciseLevel& level, const scoring::Gate& gate) {
    const std::optional<double> limit_N = ownLimit(level, gate.metric);
    return limit_N && gate.maximum && *gate.maximum > *limit_N ? limit_N : std::nullopt;
}

} // namespace chiron::session
