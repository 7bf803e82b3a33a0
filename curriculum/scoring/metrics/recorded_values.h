// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/prepared_trial.h"

#include <optional>
#include <string_view>

namespace chiron::scoring {

/// Returns one recorded quantity of a trial, with one value per sample of its tool; null if the trial has
/// none of this name.
inline const QuantityTrace* quantityOf(const PreparedTrial& trial, std::string_view id) {
    if (trial.tool == nullptr)
        return nullptr;
    for (const QuantityTrace& quantity : trial.trial->quantities)
        if (quantity.id == id && quantity.values.size() == trial.tool->t_s.size())
            return &quantity;
    return nullptr;
}

/// Returns a ground-truth value of a trial by its name.
inline std::optional<double> truthOf(const PreparedTrial& trial, std::string_view id) {
    for (const NamedValue& value : trial.trial->truth)
        if (value.id == id)
            return value.value;
    return std::nullopt;
}

} // namespace chiron::scoring
