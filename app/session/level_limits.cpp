// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/level_limits.h"

#include "session/exercise_kind.h"

#include <algorithm>
#include <string_view>

namespace chiron::session {

namespace {

std::optional<double> largestPassed(const catalogue::ExerciseLevel& level, std::string_view metric) {
    const auto gate = std::find_if(level.gates.begin(), level.gates.end(), [metric](const scoring::Gate& each) { return each.metric == metric; });
    return gate == level.gates.end() ? std::nullopt : gate->maximum;
}

double stricter(double limit_N, const std::optional<double>& passed_N) { return passed_N ? std::min(limit_N, *passed_N) : limit_N; }

/// As content and scoring have them, without any pass mark.
LevelLimits ownLimits(const catalogue::ExerciseLevel& level) {
    LevelLimits limits;
    if (const auto kind = exerciseKind(level.exercise))
        limits.force_N = (*kind)->forceLimit_N(level);
    if (const auto* handling = std::get_if<simulation::ObjectHandlingParameters>(&level.parameters))
        limits.squeeze_N = handling->squeezeLimit_N;
    if (const auto* endoscopy = std::get_if<simulation::UrethraInsertionParameters>(&level.parameters))
        limits.lateral_N = endoscopy->lateralLimit_N;
    return limits;
}

} // namespace

LevelLimits levelLimits(const catalogue::ExerciseLevel& level) {
    LevelLimits limits = ownLimits(level);
    limits.force_N = stricter(limits.force_N, largestPassed(level, "force_max"));
    if (limits.squeeze_N)
        limits.squeeze_N = stricter(*limits.squeeze_N, largestPassed(level, "squeeze_max"));
    if (limits.lateral_N)
        limits.lateral_N = stricter(*limits.lateral_N, largestPassed(level, "lateral_max"));
    limits.retraction_N = largestPassed(level, "retraction_max");
    return limits;
}

std::optional<double> limitBehind(const catalogue::ExerciseLevel& level, const scoring::Gate& gate) {
    const LevelLimits limits = ownLimits(level);
    const std::optional<double> limit_N = gate.metric == "force_max"     ? std::optional(limits.force_N)
                                          : gate.metric == "squeeze_max" ? limits.squeeze_N
                                          : gate.metric == "lateral_max" ? limits.lateral_N
                                                                         : std::nullopt;
    return limit_N && gate.maximum && *gate.maximum > *limit_N ? limit_N : std::nullopt;
}

} // namespace chiron::session
