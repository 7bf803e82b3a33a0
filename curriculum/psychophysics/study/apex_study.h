// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/warning.h"

#include <array>
#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

// The apex study (P2 §5, figure 4): participants find the top of a hemisphere on a plane by touch; the error is what was marked less where
// the apex is, along the two horizontal axes x and y. Metres and metres of radius in; millimetres and per cent of the radius out.

/// Under unbiased normal errors of sd σ the absolute error has mean σ√(2/π) and sd σ√(1 − 2/π); their ratio is this.
inline constexpr double kSdOverMeanAbsolute = 0.755510639763; ///< √(π/2 − 1)
/// P2's published errors (per cent of the radius, 5 participants, 10 hemispheres each, both axes) and the earlier device's mean.
inline constexpr double kP2MeanPercent = 14.2;
inline constexpr double kP2SdPercent = 11.3;
inline constexpr double kP2EarlierMeanPercent = 29.7;
inline constexpr double kP2Radius_m = 0.02;

struct ApexTrial {
    int participant = 0;
    double errorX_m = 0.0;
    double errorY_m = 0.0;
};

/// Signed error along one axis, participants as random effect.
struct ApexAxis {
    double bias_mm = std::numeric_limits<double>::quiet_NaN();
    Interval bias95_mm;   ///< t over participants' own means
    double biasPercent = std::numeric_limits<double>::quiet_NaN();
    double sd_mm = std::numeric_limits<double>::quiet_NaN();        ///< of one trial of one further participant: √(within² + between²)
    double sdWithin_mm = std::numeric_limits<double>::quiet_NaN();  ///< between trials of a participant
    double sdBetween_mm = std::numeric_limits<double>::quiet_NaN(); ///< between participants' own biases
    double sdPercent = std::numeric_limits<double>::quiet_NaN();
};

/// One bar of P2's figure 4: a participant's mean error, pooled over both axes, with its sd; per cent of the radius.
struct ApexBar {
    int participant = 0;
    int trials = 0;
    double meanPercent = 0.0;
    double sdPercent = std::numeric_limits<double>::quiet_NaN();
    double biasXPercent = 0.0;
    double biasYPercent = 0.0;
};

/// One point of the scatter: signed, per cent of the radius.
struct ApexPoint {
    int participant = 0;
    double xPercent = 0.0;
    double yPercent = 0.0;
};

struct ApexSummary {
    int participants = 0;
    int trials = 0;
    int leftOut = 0;
    std::array<ApexAxis, 2> axes; ///< x, y
    double meanAbsolutePercent = std::numeric_limits<double>::quiet_NaN(); ///< P2's mean error: |error| over axes and trials
    double sdAbsolutePercent = std::numeric_limits<double>::quiet_NaN();   ///< P2's sd
    Interval meanAbsolute95;      ///< t over participants' own means
    Interval meanAbsoluteBootstrap95; ///< BCa, participants drawn with replacement
    double meanAbsolute_mm = std::numeric_limits<double>::quiet_NaN();
    double sdOverMean = std::numeric_limits<double>::quiet_NaN();          ///< beside kSdOverMeanAbsolute
    double meanDistance_mm = std::numeric_limits<double>::quiet_NaN();     ///< in the plane
    double impliedSdPercent = std::numeric_limits<double>::quiet_NaN();    ///< σ per axis of unbiased errors with this mean: mean·√(π/2)
    double impliedSd_mm = std::numeric_limits<double>::quiet_NaN();
    std::vector<ApexBar> bars;
    std::vector<ApexPoint> points;
    std::vector<Warning> warnings;
};

/// Errors that are not finite are left out. Radius in metres, above zero. `seed`: of the bootstrap.
ApexSummary summariseApex(const std::vector<ApexTrial>& trials, double radius_m, std::uint64_t seed);

/// A simulated participant for planning only: unbiased normal errors about a bias of their own. Operators in simulation never see it.
struct ApexObserver {
    double sdPercent = 17.8;        ///< per axis, within a participant (P2's mean error; 3.6 mm of 20 mm)
    double sdBetweenPercent = 0.0;  ///< of participants' own biases
};
std::vector<ApexTrial> simulateApex(const ApexObserver& observer, int participants, int trialsEach, double radius_m, std::uint64_t seed);

/// What a design can show: simulated studies, their mean absolute error tested (t over participants) against a published mean.
struct ApexPlan {
    double meanAbsolutePercent = std::numeric_limits<double>::quiet_NaN();
    double halfWidthPercent = std::numeric_limits<double>::quiet_NaN(); ///< mean half width of the 95 % interval
    double power = std::numeric_limits<double>::quiet_NaN();            ///< share of studies whose interval leaves the other mean out
    /// Standard errors of the three, as so few simulated studies know them (Monte Carlo).
    double meanError = std::numeric_limits<double>::quiet_NaN(), halfWidthError = std::numeric_limits<double>::quiet_NaN();
    double powerError = std::numeric_limits<double>::quiet_NaN(); ///< after Agresti & Coull 1998
};
ApexPlan planApex(const ApexObserver& observer, int participants, int trialsEach, double otherMeanPercent, int studies, std::uint64_t seed);

} // namespace chiron::psychophysics
