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

/// How a session's value follows from its trials. `pooled`: computed once over the samples or answers of all
/// trials.
enum class Aggregate { sum, mean, median, maximum, pooled };

/// Which tools a metric reads; the command `exercise show` reports it.
enum class MetricTools { first, all };

/// A metric's outcome: a value, or none and the reason.
struct Measurement {
    std::optional<double> value;
    std::string reason; ///< in the form in which scores store it: storedText

    static Measurement of(double v) { return {v, {}}; }
    static Measurement undefined(const UndefinedReason& why, const std::array<int, 3>& counts = {}) {
        return {std::nullopt, storedText({why, counts})};
    }
};

/// The level that pure guessing reaches in a metric: either a fixed value, or the session's value of another
/// metric.
struct ChanceLevel {
    std::optional<double> value{}; ///< in the metric's unit
    std::string_view metric{};     ///< id of that metric; empty if there is none
};

/// What a publication reports of people who felt the force, in the metric's unit: their mean ± SD.
struct PublishedBand {
    double low = 0.0;
    double high = 0.0;
    std::string_view source{}; ///< who they were, for people, English; marked for translation like a title
};

/// One metric in one version (models.md §6). It is one row of a file in metrics/, which screens, reports, the
/// command line and exports read. Filter, rate and thresholds belong to the version: changing any of them
/// adds a new entry beside the old one, so that stored scores remain explicable and can be recomputed with
/// either.
struct MetricDefinition {
    std::string_view id; ///< snake_case
    int version = 1;
    std::string_view unit; ///< "" if it has none
    Direction direction = Direction::lowerIsBetter;
    MetricWrench wrench = MetricWrench::none;
    Aggregate aggregate = Aggregate::mean;
    MetricTools tools = MetricTools::first;
    bool needsForces = false; ///< no value, with the reason, for a trace without force columns
    /// For people, English; marked for translation by QT_TRANSLATE_NOOP (marked_texts.h).
    std::string_view title{};
    std::string_view meaning{}; ///< what it measures, in one sentence for people; marked likewise
    /// Used for a session with one trial if the title speaks of several; empty: the title. Marked likewise.
    std::string_view titleOfOneTrial{};
    std::string_view meaningOfOneTrial{}; ///< the same for the meaning
    /// Title for the single moment to which the metric leads, where there is neither mean nor spread; empty:
    /// the title. Marked likewise.
    std::string_view titleAtMoment{};
    /// What a pass mark of 100 % asks for, as a sentence without a full stop; empty: title and value. Marked
    /// likewise.
    std::string_view wholly{};
    std::string_view definition; ///< one sentence with the equation
    std::string_view source;     ///< paper and equation, or models.md §
    ChanceLevel chance{};
    /// Only in the version that measures what the publication did.
    std::optional<PublishedBand> published{};
    /// Computes the value over these trials. It is called with one trial for `trials[]`, and with all of them
    /// if aggregate is pooled.
    Measurement (*measure)(std::span<const PreparedTrial> trials) = nullptr;
};

std::string_view toString(Direction direction);
std::string_view toString(MetricWrench wrench);
std::string_view toString(Aggregate aggregate);
std::string_view toString(MetricTools tools);

} // namespace chiron::scoring
