// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"
#include "psychophysics/study/warning.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::psychophysics {

/// A scored trial in the form that the analysis needs.
struct ScoredTrial {
    int procedure = 0;
    int arrangement = 0;
    int answer = -1;
    int outcome = -1;
    double difference = 0.0;     ///< D presented (log10 of the ratio)
    std::optional<double> value; ///< number given, or value set (SI)
};

struct Interval {
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
};

/// A point of the curve: the number of right (yes) answers among all answers at this difference.
struct CurvePoint {
    double difference = 0.0;
    int right = 0;
    int of = 0;
};

/// How an estimate was obtained. For the wording see methodText (data) and session_report/study_warning_words
/// (people).
enum class EstimateMethod : std::uint8_t {
    none,
    observer,         ///< posterior of a Thurstone observer
    observerOfOrders, ///< the same, from complete orders of three
    settings,         ///< geometric mean and standard deviation of the settings
    numbersSaid,      ///< a power law fitted to the numbers given
    apexMarks,        ///< summariseApex
};

/// Returns the method in English, as in data and on the command line; empty for none.
std::string_view methodText(EstimateMethod method);

/// The estimate from one run. Values that cannot be determined are NaN, and `warnings` say why.
struct RunEstimate {
    /// ΔX/X at the criterion, 75 %-correct 2AFC equivalent.
    double weber = std::numeric_limits<double>::quiet_NaN();
    double jnd = std::numeric_limits<double>::quiet_NaN(); ///< in the attribute's unit, at the reference
    double sigma_log10 = std::numeric_limits<double>::quiet_NaN(); ///< internal noise, log10(1+W)/0.954
    Interval weber95;
    Interval sigma95;
    /// The posterior's sd of log10 σ divided by the prior's: near 0 the answers determine the estimate, near
    /// 1 the prior does.
    double priorInfluence = std::numeric_limits<double>::quiet_NaN();
    double pse = std::numeric_limits<double>::quiet_NaN(); ///< SI, if the task has one
    Interval pse95;
    double criterion = 0.75;
    double threshold = std::numeric_limits<double>::quiet_NaN(); ///< D at which the task's own proportion
                                                                 ///< correct is the criterion
    Interval threshold95;
    /// The same from a free psychometric curve (fits/), for comparison.
    double fitThreshold = std::numeric_limits<double>::quiet_NaN();
    Interval fitThreshold95;
    double lapse = std::numeric_limits<double>::quiet_NaN(); ///< share of answers that were guesses
    /// rank3_ties: percepts nearer than this many σ are called equal.
    double tie = std::numeric_limits<double>::quiet_NaN();
    Interval tie95;
    /// Deviance of the answers from the observer's curve, if there is one, and its p.
    double deviance = std::numeric_limits<double>::quiet_NaN();
    double pValue = std::numeric_limits<double>::quiet_NaN();
    double exponent = std::numeric_limits<double>::quiet_NaN(); ///< magnitude estimation: exponent of the
                                                                ///< power law
    Interval exponent95;
    std::string unit;
    EstimateMethod method = EstimateMethod::none;
    int trials = 0;
    std::vector<CurvePoint> points;
    /// Fitted curve with its 95 % band.
    std::vector<double> curveDifference, curveProportion, curveLow, curveHigh;
    std::vector<Warning> warnings;
};

/// Analyses one run of a condition. weber and jnd always refer to 75 % correct in 2AFC (σ and W are
/// equivalent: σ = log10(1+W)/0.954), so that tasks can be compared; `threshold` is at the condition's
/// criterion in the task itself. It never fails: a value that the data do not determine is NaN, with a
/// warning. `seed` is for bootstraps; at present nothing is drawn.
RunEstimate estimateRun(const Condition& condition, const std::vector<ScoredTrial>& trials,
                        std::uint64_t seed);

} // namespace chiron::psychophysics
