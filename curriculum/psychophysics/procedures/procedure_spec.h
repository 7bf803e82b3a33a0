// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/result.h"
#include "psychophysics/procedures/procedure.h"

namespace chiron::psychophysics {

// What procedures are set up with. JSON keys are these names in snake_case (schema/procedure.json documents each); the catalogue's
// procedure_reader fills them and says where a value is wrong. "x" is the procedure's own unit (a study: log10 of the difference D, or D).

/// When a run ends: whichever comes first. 0: does not end it.
struct StopRule {
    int trials = 0;        ///< at most so many
    int minimumTrials = 0; ///< never before
    int reversals = 0;
    double sd = 0.0;       ///< posterior sd of the first parameter at most
    bool reversalsAndTrials = false; ///< trials and reversals must both be reached (PsychoPy's rule)
};

/// Transformed and weighted up–down (Levitt 1971; Kaernbach 1991; García-Pérez 1998).
struct StaircaseSpec {
    static constexpr std::string_view kKind = "staircase";
    double start = 0.0;
    int up = 1;                       ///< consecutive wrong answers before a step up
    int down = 3;                     ///< consecutive right answers before a step down
    std::vector<double> stepsUp{0.1}; ///< by number of reversals so far; the last one is kept
    std::vector<double> stepsDown;    ///< empty: as stepsUp
    double stepRatio = 0.0;           ///< > 0: a step down is a step up times this (García-Pérez: 0.2845, 0.5488, 0.7393, 0.8415)
    enum class StepType { linear, log, db } stepType = StepType::linear; ///< x ± s; x · 10^±s; x · 10^±(s/20)
    bool initialOneUpOneDown = true;  ///< until the first reversal
    bool resetCounters = true;        ///< both, at each step
    bool newStepAtReversal = true;    ///< the step that makes the reversal already has the new size
    bool truncate = true;             ///< at the ends of the range; else only presented truncated
    std::optional<double> minimum;
    std::optional<double> maximum;
    int estimateReversals = 6;        ///< mean of so many last ones, made even
    StopRule stop{.trials = 60};
};

struct PestSpec { ///< Taylor & Creelman 1967
    static constexpr std::string_view kKind = "pest";
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

struct ConstantSpec {
    static constexpr std::string_view kKind = "constant";
    std::vector<double> levels;
    int repeats = 20;
    bool shuffled = true; ///< by blocks of one of each level; else in the order given
};

/// P2's descending rule: difference shrinks until the participant fails. "legacy": overestimates the JND (psychophysics.md §1).
struct DescendingSpec {
    static constexpr std::string_view kKind = "descending";
    std::vector<double> levels; ///< descending
    int repeats = 3;            ///< presentations a level
    int passes = 2;             ///< right ones needed to go on
};

struct QuestSpec { ///< Watson & Pelli 1983
    static constexpr std::string_view kKind = "quest";
    double priorMean = 0.0;
    double priorSd = 0.5;
    double target = 0.82;
    double slope = 3.5;   ///< β
    double lapse = 0.01;  ///< δ
    double guess = 0.5;   ///< γ
    double grain = 0.01;
    double range = 5.0;
    std::string method = "quantile"; ///< test at quantile (Pelli's optimal), mean or mode
    std::optional<double> minimum;
    std::optional<double> maximum;
    StopRule stop{.trials = 40};
};

/// A grid of one parameter, with its prior where that is not uniform (same length, any positive scale).
struct ParameterGrid {
    std::string name;
    std::vector<double> values;
    std::vector<double> prior;
    bool nuisance = false; ///< left out of the entropy (Prins 2013)
};

struct QuestPlusSpec { ///< Watson 2017
    static constexpr std::string_view kKind = "quest_plus";
    std::string function = "weibull_log10"; ///< weibull_db, weibull_log10, weibull, norm_cdf, norm_cdf_2, logistic, gumbel, ... ; rank3; table
    std::vector<std::pair<std::string, std::vector<double>>> stimuli; ///< a dimension each: name, values
    std::vector<ParameterGrid> parameters; ///< in the function's own order
    int outcomes = 2;
    int repeatLimit = 0;         ///< > 0: the same stimulus at most so often in a row
    double catchEvery = 0.0;     ///< > 0: share of catch trials at the easiest stimulus
    StopRule stop{.trials = 64};
    std::uint64_t seed = 1;      ///< of the catch trials
    std::vector<std::vector<std::vector<double>>> table; ///< function "table": [outcome][stimulus][parameter cell]
};

/// Rank-3 with the Thurstone observer (psychophysics.md §4): QUEST+ over (log10 σ, λ), six outcomes; with ties over
/// (log10 σ, tie, λ), 13 outcomes (observers/tied_orders.h); x is D in log10 units.
struct Rank3Spec {
    static constexpr std::string_view kKind = "rank3_quest_plus";
    std::vector<double> differences; ///< candidates D > 0, log10 of the ratio, ascending
    std::vector<double> log10Sigma;  ///< grid; empty: from a tenth of the least difference to three times the largest, 0.05 apart
    std::vector<double> lapse{0.0, 0.02, 0.05, 0.1}; ///< JSON: lapse_rates
    bool allowTies = false; ///< neighbours may be called equal (task rank3_ties)
    std::vector<double> tieThresholds{0.25, 0.5, 1.0, 1.5}; ///< with ties: grid of the difference felt, in σ, below which objects are called equal
    StopRule stop{.trials = 80, .minimumTrials = 20, .sd = 0.06};
    int repeatLimit = 0;
};

using ProcedureSpec = std::variant<StaircaseSpec, PestSpec, ConstantSpec, DescendingSpec, QuestSpec, QuestPlusSpec, Rank3Spec>;

/// The procedure's id, as content and exports say it: its specification's kKind.
std::string_view kindOf(const ProcedureSpec& spec) noexcept;
/// Failure: badInput naming the key and what was expected. `seed`: of whatever the procedure draws.
core::Result<std::unique_ptr<Procedure>> makeProcedure(const ProcedureSpec& spec, std::uint64_t seed);

/// Makes any number of runs of one specification; what they share (tables of QUEST+) is made once.
using ProcedureFactory = std::function<std::unique_ptr<Procedure>(std::uint64_t seed)>;
core::Result<ProcedureFactory> procedureFactory(const ProcedureSpec& spec); ///< fails as makeProcedure does

} // namespace chiron::psychophysics
