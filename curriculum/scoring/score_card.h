// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace chiron::scoring {

/// A pass mark on one session metric. Both ends are inclusive, and either may be absent. Gates are part of
/// the content.
struct Gate {
    std::string metric;
    std::optional<double> minimum;
    std::optional<double> maximum;
};

/// Whether a gate's minimum asks for everything, of which there is no more: people are not told "at least".
inline bool asksForAll(double minimum, std::string_view unit) {
    return unit == "%" && minimum >= 100.0;
}

struct MetricValue {
    std::string id;
    int version = 1;
    std::string unit;
    std::optional<double> value; ///< absent, with a reason, if it is not defined
    std::string reason;
    std::optional<bool> passed; ///< present only if the level gates this metric
};

/// The scores of a session: one value per metric, aggregated as the catalogue prescribes, and the values of
/// each trial.
struct ScoreCard {
    std::vector<MetricValue> metrics;
    std::vector<std::vector<MetricValue>> trials;
    /// Every gate is met and the session is completed; gates on absent values are not met.
    bool passed = false;
};

} // namespace chiron::scoring
