// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "psychophysics/procedures/stop_rule.h"

namespace chiron::psychophysics {

class ProcedureKind;

/// Parameters of PEST (Taylor & Creelman 1967).
struct PestSpec {
    static constexpr std::string_view kKind = "pest";
    static const ProcedureKind& kind();
    double start = 0.0;
    double target = 0.75;
    double waldDeviation = 1.0;
    double step = 0.4;
    double smallestStep = 0.05; ///< ends the run when reached
    double largestStep = 1.6;
    double minimum = -1e9;
    double maximum = 1e9;
    StopRule stop{.trials = 200};
};

} // namespace chiron::psychophysics
