// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "psychophysics/procedures/stop_rule.h"

namespace chiron::psychophysics {

class ProcedureKind;

/// The grid of one parameter, with its prior if that is not uniform (same length, any positive scale).
struct ParameterGrid {
    std::string name;
    std::vector<double> values;
    std::vector<double> prior;
    bool nuisance = false; ///< left out of the entropy (Prins 2013)
};

/// One element per dimension of the stimulus: name and values.
using StimulusGrids = std::vector<std::pair<std::string, std::vector<double>>>;
/// [outcome][stimulus][parameter cell].
using OutcomeProbabilities = std::vector<std::vector<std::vector<double>>>;

/// Parameters of QUEST+ (Watson 2017).
struct QuestPlusSpec {
    static constexpr std::string_view kKind = "quest_plus";
    static const ProcedureKind& kind();
    /// weibull_db, weibull_log10, weibull, norm_cdf, norm_cdf_2, logistic, gumbel, ... ; rank3; table.
    std::string function = "weibull_log10";
    StimulusGrids stimuli;
    std::vector<ParameterGrid> parameters; ///< in the function's own order
    int outcomes = 2;
    int repeatLimit = 0;     ///< > 0: the same stimulus at most this many times in a row
    double catchEvery = 0.0; ///< > 0: share of catch trials at the easiest stimulus
    StopRule stop{.trials = 64};
    std::uint64_t seed = 1;     ///< for the catch trials
    OutcomeProbabilities table; ///< function "table": [outcome][stimulus][parameter cell]
};

} // namespace chiron::psychophysics
