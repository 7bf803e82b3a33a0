// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "psychophysics/procedures/stop_rule.h"

namespace chiron::psychophysics {

class ProcedureKind;

/// Parameters of rank-3 with the Thurstone observer (psychophysics.md §4): QUEST+ over (log10 σ, λ) with six
/// outcomes; with ties over (log10 σ, tie, λ) with 13 outcomes (observers/tied_orders.h). x is D in log10
/// units.
struct Rank3Spec {
    static constexpr std::string_view kKind = "rank3_quest_plus";
    static const ProcedureKind& kind();
    std::vector<double> differences; ///< candidates D > 0, log10 of the ratio, ascending
    /// Grid; empty: from a tenth of the smallest difference to three times the largest, 0.05 apart.
    std::vector<double> log10Sigma;
    std::vector<double> lapse{0.0, 0.02, 0.05, 0.1}; ///< JSON: lapse_rates
    bool allowTies = false;                          ///< neighbours may be called equal (task rank3_ties)
    /// With ties: grid of the perceived difference, in σ, below which objects are called equal.
    std::vector<double> tieThresholds{0.25, 0.5, 1.0, 1.5};
    StopRule stop{.trials = 80, .minimumTrials = 20, .sd = 0.06};
    int repeatLimit = 0;
};

} // namespace chiron::psychophysics
