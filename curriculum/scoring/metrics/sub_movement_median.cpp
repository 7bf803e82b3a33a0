// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metrics/sub_movement_median.h"

#include "scoring/median.h"

#include <vector>

namespace chiron::scoring {

Measurement subMovementMedian(std::span<const PreparedTrial> trials, Motion PreparedTrial::*motion,
                              Measurement (*measure)(std::span<const double> speed, double dt_s)) {
    std::vector<double> values;
    bool moved = false;
    for (const PreparedTrial& trial : trials) {
        moved = moved || trial.movementStart_s.has_value();
        const Motion& source = trial.*motion;
        for (const std::span<const double> speed : subMovements(trial, source))
            if (const Measurement m = measure(speed, source.dt_s); m.value)
                values.push_back(*m.value);
    }
    if (!values.empty())
        return Measurement::of(median(std::move(values)));
    return Measurement::undefined(moved ? UndefinedReason::noSubMovement : UndefinedReason::noMovement);
}

} // namespace chiron::scoring
