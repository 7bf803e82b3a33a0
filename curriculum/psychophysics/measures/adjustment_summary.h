// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/warning.h"

#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// Summary of the method of adjustment: settings of a comparison that was to be made equal to the reference
/// (Gescheider 1997, ch. 3), in log10 of the ratio.
struct AdjustmentSummary {
    int settings = 0;                                      ///< number of settings used
    double pse = std::numeric_limits<double>::quiet_NaN(); ///< geometric mean of the settings, SI, with its
                                                           ///< 95 % t interval
    double pseLow = std::numeric_limits<double>::quiet_NaN();
    double pseHigh = std::numeric_limits<double>::quiet_NaN();
    double constantErrorLog10 = std::numeric_limits<double>::quiet_NaN(); ///< log10(PSE/reference)
    /// Of the settings, with its 95 % chi-square interval.
    double sdLog10 = std::numeric_limits<double>::quiet_NaN();
    double sdLow = std::numeric_limits<double>::quiet_NaN();
    double sdHigh = std::numeric_limits<double>::quiet_NaN();
    /// z(0.75) sd: half of the settings lie within it (probable error).
    double jndLog10 = std::numeric_limits<double>::quiet_NaN();
    std::vector<Warning> warnings;
};

/// Summarises settings. Settings and reference are in SI and above zero; others are left out. The PSE needs
/// one setting, the spread two.
AdjustmentSummary summariseSettings(double reference, const std::vector<double>& settings);

} // namespace chiron::psychophysics
