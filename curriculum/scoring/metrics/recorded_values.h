// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/prepared_trial.h"

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

} // namespace chiron::scoring
