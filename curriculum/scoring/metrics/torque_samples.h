// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <cstddef>
#include <optional>
#include <span>

namespace chiron::scoring {

/// Calls visit(‖tissue torque about the tip‖ N·m) for each unpaused sample of the first tool. The reason, if a trial has
/// no torques (a device or a file without orientation).
template <class Visit>
std::optional<Measurement> forEachTorque(std::span<const PreparedTrial> trials, Visit&& visit) {
    for (const PreparedTrial& trial : trials) {
        if (trial.tool == nullptr)
            continue;
        if (trial.tool->tissueTorque_Nm.empty())
            return Measurement::undefined(UndefinedReason::noTorques);
        for (std::size_t i = 0; i < trial.tool->t_s.size(); ++i)
            if (trial.tool->paused[i] == 0)
                visit(trial.tool->tissueTorque_Nm[i].norm());
    }
    return std::nullopt;
}

} // namespace chiron::scoring
