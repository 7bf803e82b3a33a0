// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/undefined_reason.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace chiron::scoring {

struct PreparedTrial;

enum class Direction { lowerIsBetter, higherIsBetter, neutral };

/// Which wrench a metric reads (data.md: three wrenches, distinct everywhere).
enum class MetricWrench { none, tissue, commanded, measured };

/// How a session's value comes from its trials. `pooled`: computed once over all trials' samples or answers.
enum class Aggregate { sum, mean, median, maximum, pooled };

/// Which tools a metric reads; `exercise show` says it.
enum class MetricTools { first, all };

/// A metric's outcome: a value, or none and the reason.
struct Measurement {
    std::optional<double> value;
    std::string reason; ///< as scores keep it: storedText

    static Measurement of(double v) { return {v, {}}; }
    static Measurement undefined(UndefinedReason why, const std::array<int, 3>& counts = {}) { return {std::nullopt, storedText({why, counts})}; }
};

/// What somebody who only guesses reaches in a metric: a value whatever was there, or the session's value of another metric.
struct ChanceLevel {
    std::optional<double> value{}; ///< in the metric's unit
    std::string_view metric{};     ///< id, empty where there is none
};

/// One metric in one version (models.md §6): one row of a file in metrics/, which screens, papers, the command line and exports read. Filter, rate and thresholds belong to the version: changing any
/// of them is a new entry beside the old one, so that stored scores stay explicable and can be recomputed
/// under either.
struct MetricDefinition {
    std::string_view id; ///< snake_case
    int version = 1;
    std::string_view unit; ///< "" where it has none
    Direction direction = Direction::lowerIsBetter;
    MetricWrench wrench = MetricWrench::none;
    Aggregate aggregate = Aggregate::mean;
    MetricTools tools = MetricTools::first;
    bool needsForces = false;    ///< null, with its reason, for a trace without force columns
    std::string_view title{};    ///< for people, English; QT_TRANSLATE_NOOP (marked_texts.h) marks it for translation
    std::string_view meaning{};  ///< what it measures, in a sentence for people; marked likewise
    std::string_view titleOfOneTrial{};   ///< of a session of one trial, where the title speaks of several; empty: the title. Marked likewise
    std::string_view meaningOfOneTrial{}; ///< the same of the meaning
    /// What is told of the one moment that it leads to, where there is neither mean nor spread; empty: the title. Marked likewise
    std::string_view titleAtMoment{};
    std::string_view definition; ///< one sentence with the equation
    std::string_view source;     ///< paper and equation, or models.md §
    ChanceLevel chance{};
    /// The value over these trials: called with one trial for `trials[]`, with all of them where aggregate is
    /// pooled.
    Measurement (*measure)(std::span<const PreparedTrial> trials) = nullptr;
};

std::string_view toString(Direction direction);
std::string_view toString(MetricWrench wrench);
std::string_view toString(Aggregate aggregate);
std::string_view toString(MetricTools tools);

} // namespace chiron::scoring
