// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// One trial's answer in the sphere-apex task (models.md §2.3).
struct ApexAnswer {
    double errorX_percent = 0.0; ///< 100 (x − x₀)/R
    double errorY_percent = 0.0;
    /// Out of contact, farther than R from the apex (x, y), or no mark before the time was up.
    bool miss = false;

    /// Absolute errors in which a miss counts as an error of at least R, because a mark made without touching
    /// the sphere says nothing about where the apex was felt.
    double countedX_percent() const { return counted(errorX_percent); }
    double countedY_percent() const { return counted(errorY_percent); }

private:
    double counted(double error_percent) const {
        return miss ? std::max(100.0, std::abs(error_percent)) : std::abs(error_percent);
    }
};

/// Returns the answer at the marked position. If nothing was marked, it is at the last position of the first
/// tool, so that leaving hard trials unmarked improves no score. Misses keep their value. Returns none
/// without the truth or without any position.
std::optional<ApexAnswer> apexAnswer(const PreparedTrial& trial);

/// The answers of all trials. If any trial has none, `undefined` holds the reason: a session's error must not
/// silently leave trials out.
struct ApexAnswers {
    std::vector<ApexAnswer> answers;
    std::optional<Measurement> undefined;
};
ApexAnswers apexAnswers(std::span<const PreparedTrial> trials);

} // namespace chiron::scoring
