// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/level_limits.h"

#include "session/exercise_kind.h"

#include <algorithm>

namespace chiron::session {

namespace {

constexpr std::string_view kForce = "force_max";

std::optional<double> largestPassed(const catalogue::ExerciseLevel& level, std::string_view metric) {
    const auto gate = std::find_if(level.gates.begin(), level.gates.end(),
                                   [metric](const scoring::Gate& each) { return each.metric == metric; });
    return gate == level.gates.end() ? std::nullopt : gate->maximum;
}

/// All metrics that the level limits, the force on the tissue first. For an unknown exercise only this one.
std::vector<LimitedMetric> limitedMetricsOf(const catalogue::ExerciseLevel& level) {
    std::vector<LimitedMetric> limited{{.metric = kForce}};
    const auto kind = exerciseKind(level.exercise);
    if (!kind)
        return limited;
    limited.front().own = (*kind)->forceLimit_N(level);
    for (const LimitedMetric& other : (*kind)->limitedMetrics(level))
        limited.push_back(other);
    return limited;
}

/// The stricter of the two limits, if there is one.
std::optional<double> stricter(const std::optional<double>& own, const std::optional<double>& passed) {
    return own && passed ? std::min(*own, *passed) : own ? own : passed;
}

} // namespace

std::optional<double> LevelLimits::of(std::string_view metric) const {
    for (const auto& [limited, limit] : others)
        if (limited == metric)
            return limit;
    return std::nullopt;
}

LevelLimits levelLimits(const catalogue::ExerciseLevel& level) {
    LevelLimits limits;
    for (const LimitedMetric& limited : limitedMetricsOf(level)) {
        const auto limit = stricter(limited.own, largestPassed(level, limited.metric));
        if (limit && limited.metric == kForce)
            limits.force_N = *limit;
        else if (limit)
            limits.others.emplace_back(limited.metric, *limit);
    }
    return limits;
}

std::optional<double> limitBehind(const catalogue::ExerciseLevel& level, const scoring::Gate& gate) {
    for (const LimitedMetric& limited : limitedMetricsOf(level))
        if (limited.metric == gate.metric)
            return limited.own && gate.maximum && *gate.maximum > *limited.own ? limited.own : std::nullopt;
    return std::nullopt;
}

} // namespace chiron::session
