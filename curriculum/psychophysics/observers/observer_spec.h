// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <string>
#include <string_view>

namespace chiron::psychophysics {

/// A simulated participant. On the command line "weber:0.12,lapse:0.02,bias:0.3", and "operator:expert" in a study of the apex.
struct ObserverSpec {
    double weber = 0.1; ///< Weber fraction at 75 % correct in 2AFC: log10(1+W) = 0.954 σ
    double lapse = 0.0; ///< share of trials answered blindly, all answers alike
    double ties = 0.5;  ///< rank3_ties: what is felt nearer than so many σ is called equal
    double bias = 0.0;  ///< in σ: the left object feels so much more; yes-no: to yes; same-different: to different; adjustment: sets so much more
    /// Apex: which scripted trainee of the sphere-apex exercise searches; it has its own noises, so that the numbers above say nothing
    /// of it. Empty: the usual one.
    std::string trainee{};
};

/// Failure: badInput naming the part and what was expected.
core::Result<ObserverSpec> parseObserver(std::string_view text);
std::string observerText(const ObserverSpec& spec); ///< what parseObserver reads back
/// Internal noise of one percept, log10 units: log10(1+W)/0.954.
double sigmaOf(const ObserverSpec& spec);

} // namespace chiron::psychophysics
