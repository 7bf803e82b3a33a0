// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace chiron::station {

/// What goes wrong on purpose.
enum class FaultKind {
    none,
    delay,     ///< what is sent leaves `amount` ms late
    jitter,    ///< what is sent leaves 0 to `amount` ms late, in its order
    drop,      ///< of what is sent and of what comes, this share is lost
    duplicate, ///< of what is sent, this share is sent twice
    reorder,   ///< of what is sent, this share leaves after what comes next
    corrupt,   ///< of what is sent and of what comes, this share has one wrong bit
    freeze,    ///< for `amount` ms nothing is sent and nothing is taken; the mechanism goes on
    unplug,    ///< for `amount` ms the line is gone; 0: for good
    saturate,  ///< motors give no more than this share of their rating, and say so
    drift,     ///< the first axis counts `amount` counts a second too many
};

/// One fault, from a moment of the station's own clock on.
struct FaultPlan {
    FaultKind kind = FaultKind::none;
    double when_s = 1.0;
    double amount = 0.0; ///< in the unit of its kind
};

/// Reads KIND[:WHEN[:AMOUNT]], as drop:2.5:0.1. WHEN: seconds, 1 if it is not given; AMOUNT: the kind's usual
/// one.
/// Errors: badInput naming the kinds, or the range of the number.
core::Result<FaultPlan> readFaultPlan(std::string_view text);

/// The kinds that readFaultPlan() knows, separated by commas.
std::string faultKinds();

} // namespace chiron::station
