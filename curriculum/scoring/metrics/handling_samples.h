// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace chiron::scoring {

/// One recorded quantity of a trial, as long as its tool's samples; null: the trial has none of this name.
inline const QuantityTrace* quantityOf(const PreparedTrial& trial, std::string_view id) {
    if (trial.tool == nullptr)
        return nullptr;
    for (const QuantityTrace& quantity : trial.trial->quantities)
        if (quantity.id == id && quantity.values.size() == trial.tool->t_s.size())
            return &quantity;
    return nullptr;
}

/// What is true of a trial by name.
inline std::optional<double> truthOf(const PreparedTrial& trial, std::string_view id) {
    for (const NamedValue& value : trial.trial->truth)
        if (value.id == id)
            return value.value;
    return std::nullopt;
}

/// An object at the end of a trial.
struct PlacedObject {
    int number = 0;
    double fromTarget_m = std::numeric_limits<double>::infinity(); ///< seen from above, from the target's middle
};

/// The object that is nearest to the target at the trial's last sample; none where the trace does not say.
inline std::optional<PlacedObject> nearestToTarget(const PreparedTrial& trial) {
    const auto x_m = truthOf(trial, "target_x_m");
    const auto y_m = truthOf(trial, "target_y_m");
    const auto objects = truthOf(trial, "objects");
    if (!x_m || !y_m || !objects || trial.tool == nullptr || trial.tool->t_s.empty())
        return std::nullopt;
    PlacedObject nearest;
    for (int i = 0; i < static_cast<int>(*objects); ++i) {
        const std::string body = "body_" + std::to_string(i);
        const QuantityTrace* bodyX = quantityOf(trial, body + "_x_m");
        const QuantityTrace* bodyY = quantityOf(trial, body + "_y_m");
        if (bodyX == nullptr || bodyY == nullptr)
            return std::nullopt;
        const double away_m = std::hypot(bodyX->values.back() - *x_m, bodyY->values.back() - *y_m);
        if (away_m < nearest.fromTarget_m)
            nearest = {i, away_m};
    }
    return std::isfinite(nearest.fromTarget_m) ? std::optional(nearest) : std::nullopt;
}

} // namespace chiron::scoring
