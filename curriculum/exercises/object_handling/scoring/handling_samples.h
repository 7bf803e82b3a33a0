// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/object_handling/scoring/handling_truth.h"
#include "scoring/metrics/recorded_values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace chiron::scoring {

/// An object at the end of a trial.
struct PlacedObject {
    int number = 0;
    /// Horizontal distance from the target's centre.
    double fromTarget_m = std::numeric_limits<double>::infinity();
    bool taken = true; ///< false: no object was ever held, and this one is only the nearest
};

/// Returns how far object `number` lies from the target at the trial's last sample, or none if the trace does
/// not record it.
inline std::optional<double> fromTarget_m(const PreparedTrial& trial, const HandlingTruth& truth,
                                          int number) {
    const std::string body = "body_" + std::to_string(number);
    const QuantityTrace* bodyX = quantityOf(trial, body + "_x_m");
    const QuantityTrace* bodyY = quantityOf(trial, body + "_y_m");
    if (!truth.targetX_m || !truth.targetY_m || bodyX == nullptr || bodyY == nullptr || bodyX->values.empty())
        return std::nullopt;
    return std::hypot(bodyX->values.back() - *truth.targetX_m, bodyY->values.back() - *truth.targetY_m);
}

/// Returns the object that was held last in the trial (recorded `held`: its number + 1), or none.
inline std::optional<int> lastHeld(const QuantityTrace& held) {
    const auto last =
        std::find_if(held.values.rbegin(), held.values.rend(), [](double value) { return value > 0.5; });
    return last == held.values.rend() ? std::nullopt
                                      : std::optional(static_cast<int>(std::lround(*last)) - 1);
}

/// Returns the trial's answer: the object that was held last, even if another happens to lie nearer to the
/// target. If no object was ever held, it is the object nearest to the target. Returns none if the trace does
/// not record it.
inline std::optional<PlacedObject> answerOf(const PreparedTrial& trial) {
    const HandlingTruth truth = handlingTruthIn(*trial.trial);
    const QuantityTrace* held = quantityOf(trial, "held");
    if (!truth.objects || held == nullptr)
        return std::nullopt;
    if (const auto number = lastHeld(*held)) {
        const auto away_m = fromTarget_m(trial, truth, *number);
        return away_m ? std::optional(PlacedObject{*number, *away_m, true}) : std::nullopt;
    }
    PlacedObject nearest;
    nearest.taken = false;
    for (int i = 0; i < *truth.objects; ++i) {
        const auto away_m = fromTarget_m(trial, truth, i);
        if (!away_m)
            return std::nullopt;
        if (*away_m < nearest.fromTarget_m)
            nearest = {i, *away_m, false};
    }
    return std::isfinite(nearest.fromTarget_m) ? std::optional(nearest) : std::nullopt;
}

} // namespace chiron::scoring
