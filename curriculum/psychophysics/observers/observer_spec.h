// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <string>
#include <string_view>

namespace chiron::psychophysics {

/// Describes a simulated participant. On the command line it is "weber:0.12,lapse:0.02,bias:0.3", or
/// "operator:expert" in a study of the apex.
struct ObserverSpec {
    double weber = 0.1; ///< Weber fraction at 75 % correct in 2AFC: log10(1+W) = 0.954 σ
    double lapse = 0.0; ///< share of trials answered at random, with all answers equally likely
    double ties = 0.5;  ///< rank3_ties: percepts nearer than this many σ are called equal
    /// In σ. The left object seems larger by this amount; yes-no: bias towards yes; same-different: towards
    /// different; adjustment: sets larger by this amount.
    double bias = 0.0;
    /// Apex: the scripted operator of the sphere-apex exercise that searches. It has its own noise, so that
    /// the numbers above do not apply to it. Empty: the default one.
    std::string trainee{};
};

/// Errors: badInput naming the part and what was expected.
core::Result<ObserverSpec> parseObserver(std::string_view text);
std::string observerText(const ObserverSpec& spec); ///< text that parseObserver reads back
/// Returns the internal noise of one percept in log10 units: log10(1+W)/0.954.
double sigmaOf(const ObserverSpec& spec);

} // namespace chiron::psychophysics
