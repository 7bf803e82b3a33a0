// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "psychophysics/procedures/stop_rule.h"

namespace chiron::psychophysics {

class ProcedureKind;

/// Parameters of QUEST (Watson & Pelli 1983).
struct QuestSpec {
    static constexpr std::string_view kKind = "quest";
    static const ProcedureKind& kind();
    double priorMean = 0.0;
    double priorSd = 0.5;
    double target = 0.82;
    double slope = 3.5;  ///< β
    double lapse = 0.01; ///< δ
    double guess = 0.5;  ///< γ
    double grain = 0.01;
    double range = 5.0;
    std::string method = "quantile"; ///< test at quantile (Pelli's optimal), mean or mode
    std::optional<double> minimum;
    std::optional<double> maximum;
    StopRule stop{.trials = 40};
};

} // namespace chiron::psychophysics
