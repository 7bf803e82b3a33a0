// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "psychophysics/procedures/stop_rule.h"

namespace chiron::psychophysics {

class ProcedureKind;

/// Parameters of a transformed and weighted up–down staircase (Levitt 1971; Kaernbach 1991; García-Pérez
/// 1998).
struct StaircaseSpec {
    static constexpr std::string_view kKind = "staircase";
    static const ProcedureKind& kind();
    double start = 0.0;
    int up = 1;                       ///< consecutive wrong answers before a step up
    int down = 3;                     ///< consecutive right answers before a step down
    std::vector<double> stepsUp{0.1}; ///< indexed by the number of reversals so far; the last one repeats
    std::vector<double> stepsDown;    ///< empty: same as stepsUp
    /// > 0: a step down is a step up times this factor (García-Pérez: 0.2845, 0.5488, 0.7393, 0.8415).
    double stepRatio = 0.0;
    enum class StepType { linear, log, db } stepType = StepType::linear; ///< x ± s; x · 10^±s; x · 10^±(s/20)
    bool initialOneUpOneDown = true; ///< 1-up/1-down until the first reversal
    bool resetCounters = true;       ///< both counters, at each step
    bool newStepAtReversal = true;   ///< the step that makes the reversal already has the new size
    /// Limit the level itself to the range; otherwise only the presented stimulus is limited.
    bool truncate = true;
    std::optional<double> minimum;
    std::optional<double> maximum;
    int estimateReversals = 6; ///< mean of this many last reversals, rounded down to an even number
    StopRule stop{.trials = 60};
};

} // namespace chiron::psychophysics
