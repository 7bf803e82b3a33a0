// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace chiron::scoring {

/// A pass mark on one session metric: both ends inclusive, either may be absent. Lives in content.
struct Gate {
    std::string metric;
    std::optional<double> minimum;
    std::optional<double> maximum;
};

struct MetricValue {
    std::string id;
    int version = 1;
    std::string unit;
    std::optional<double> value; ///< absent with a reason where it is not defined
    std::string reason;
    std::optional<bool> passed; ///< only where the level gates this metric
};

/// What a session scored: pooled metrics as the catalogue's aggregates say, and each trial's own.
struct ScoreCard {
    std::vector<MetricValue> metrics;
    std::vector<std::vector<MetricValue>> trials;
    bool passed =
        false; ///< every gate holds and the session is completed; gates on absent values do not hold
};

} // namespace chiron::scoring
