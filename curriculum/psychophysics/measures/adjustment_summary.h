// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/warning.h"

#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// Method of adjustment: settings of a comparison made equal to the reference (Gescheider 1997, ch. 3), in log10 of the ratio.
struct AdjustmentSummary {
    int settings = 0; ///< used
    double pse = std::numeric_limits<double>::quiet_NaN();          ///< geometric mean of the settings, SI, with its 95 % t interval
    double pseLow = std::numeric_limits<double>::quiet_NaN();
    double pseHigh = std::numeric_limits<double>::quiet_NaN();
    double constantErrorLog10 = std::numeric_limits<double>::quiet_NaN(); ///< log10(PSE/reference)
    double sdLog10 = std::numeric_limits<double>::quiet_NaN();      ///< of the settings, with its 95 % chi-square interval
    double sdLow = std::numeric_limits<double>::quiet_NaN();
    double sdHigh = std::numeric_limits<double>::quiet_NaN();
    double jndLog10 = std::numeric_limits<double>::quiet_NaN();     ///< z(0.75) sd: half of the settings lie within it (probable error)
    std::vector<Warning> warnings;
};

/// Settings and reference in SI, above zero; others are left out. PSE from one setting on; spread from two on.
AdjustmentSummary summariseSettings(double reference, const std::vector<double>& settings);

} // namespace chiron::psychophysics
