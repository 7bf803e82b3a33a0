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

/// A scored trial as analysis needs it.
struct ScoredTrial {
    int procedure = 0;
    int arrangement = 0;
    int answer = -1;
    int outcome = -1;
    double difference = 0.0;      ///< D presented (log10 of the ratio)
    std::optional<double> value;  ///< number said, or value set (SI)
};

struct Interval {
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
};

/// A point of the curve: at this difference so many of so many were right (yes).
struct CurvePoint {
    double difference = 0.0;
    int right = 0;
    int of = 0;
};

/// How an estimate was got. In words: methodText for data, session_report/study_warning_words for people.
enum class EstimateMethod : std::uint8_t {
    none,
    observer,         ///< posterior of a Thurstone observer
    observerOfOrders, ///< the same, of whole orders of three
    settings,         ///< geometric mean and standard deviation of what was set
    numbersSaid,      ///< a power law through what was said
    apexMarks,        ///< summariseApex
};

/// English, as data and the command line have it; empty for none.
std::string_view methodText(EstimateMethod method);

/// What a run says. Numbers that cannot be had are NaN, and `warnings` say why.
struct RunEstimate {
    double weber = std::numeric_limits<double>::quiet_NaN();      ///< ΔX/X at the criterion, 75 %-correct 2AFC equivalent
    double jnd = std::numeric_limits<double>::quiet_NaN();        ///< in the attribute's unit, at the reference
    double sigma_log10 = std::numeric_limits<double>::quiet_NaN();///< internal noise, log10(1+W)/0.954
    Interval weber95;
    Interval sigma95;
    double priorInfluence = std::numeric_limits<double>::quiet_NaN(); ///< the posterior's sd of log10 σ over the prior's: near 0 the answers decide, near 1 what was assumed
    double pse = std::numeric_limits<double>::quiet_NaN();        ///< SI, where the task has one
    Interval pse95;
    double criterion = 0.75;
    double threshold = std::numeric_limits<double>::quiet_NaN(); ///< D at which the task's own proportion correct is the criterion
    Interval threshold95;
    double fitThreshold = std::numeric_limits<double>::quiet_NaN(); ///< the same from a free psychometric curve (fits/), beside it
    Interval fitThreshold95;
    double lapse = std::numeric_limits<double>::quiet_NaN();     ///< share of answers that were guesses
    double tie = std::numeric_limits<double>::quiet_NaN();       ///< rank3_ties: what is felt nearer than so many σ is called equal
    Interval tie95;
    double deviance = std::numeric_limits<double>::quiet_NaN();  ///< of the answers from the observer's curve, where there is one, and its p
    double pValue = std::numeric_limits<double>::quiet_NaN();
    double exponent = std::numeric_limits<double>::quiet_NaN();  ///< magnitude estimation: of the power law
    Interval exponent95;
    std::string unit;
    EstimateMethod method = EstimateMethod::none; ///< how it was got
    int trials = 0;
    std::vector<CurvePoint> points;
    std::vector<double> curveDifference, curveProportion, curveLow, curveHigh; ///< fitted curve with its 95 % band
    std::vector<Warning> warnings;
};

/// Analyses one run of a condition. weber and jnd are always those of 75 % correct in 2AFC (σ and W say the same: σ = log10(1+W)/0.954), so
/// that tasks compare; `threshold` is at the condition's criterion in the task itself.
/// Never fails: what the data do not carry is NaN with a warning. `seed`: of bootstraps.
RunEstimate estimateRun(const Condition& condition, const std::vector<ScoredTrial>& trials, std::uint64_t seed);

} // namespace chiron::psychophysics
