// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/warning.h"

#include <array>
#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

// The apex study (P2 §5, figure 4): participants find the top of a hemisphere on a plane by touch. The error
// is the marked position minus the position of the apex, along the two horizontal axes x and y. Input is in
// metres; results are in millimetres and in per cent of the radius.

/// For unbiased normal errors with sd σ the absolute error has mean σ√(2/π) and sd σ√(1 − 2/π). This is the
/// ratio of sd to mean.
inline constexpr double kSdOverMeanAbsolute = 0.755510639763; ///< √(π/2 − 1)
/// P2's published errors (per cent of the radius, 5 participants, 10 hemispheres each, both axes), and the
/// mean error with the earlier device.
inline constexpr double kP2MeanPercent = 14.2;
inline constexpr double kP2SdPercent = 11.3;
inline constexpr double kP2EarlierMeanPercent = 29.7;
inline constexpr double kP2Radius_m = 0.02;

struct ApexTrial {
    int participant = 0;
    double errorX_m = 0.0;
    double errorY_m = 0.0;
};

/// Signed error along one axis, with participants as random effect.
struct ApexAxis {
    double bias_mm = std::numeric_limits<double>::quiet_NaN();
    Interval bias95_mm; ///< t interval over the participants' own means
    double biasPercent = std::numeric_limits<double>::quiet_NaN();
    /// For one trial of one further participant: √(within² + between²).
    double sd_mm = std::numeric_limits<double>::quiet_NaN();
    double sdWithin_mm = std::numeric_limits<double>::quiet_NaN();  ///< between the trials of a participant
    double sdBetween_mm = std::numeric_limits<double>::quiet_NaN(); ///< between the participants' own biases
    double sdPercent = std::numeric_limits<double>::quiet_NaN();
};

/// One bar of P2's figure 4: a participant's mean error, pooled over both axes, with its sd, in per cent of
/// the radius.
struct ApexBar {
    int participant = 0;
    int trials = 0;
    double meanPercent = 0.0;
    double sdPercent = std::numeric_limits<double>::quiet_NaN();
    double biasXPercent = 0.0;
    double biasYPercent = 0.0;
};

/// One point of the scatter plot: signed errors, in per cent of the radius.
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
    /// P2's mean error: |error| over axes and trials.
    double meanAbsolutePercent = std::numeric_limits<double>::quiet_NaN();
    double sdAbsolutePercent = std::numeric_limits<double>::quiet_NaN(); ///< P2's sd
    Interval meanAbsolute95;          ///< t interval over the participants' own means
    Interval meanAbsoluteBootstrap95; ///< BCa, with participants drawn with replacement
    double meanAbsolute_mm = std::numeric_limits<double>::quiet_NaN();
    /// To be compared with kSdOverMeanAbsolute.
    double sdOverMean = std::numeric_limits<double>::quiet_NaN();
    double meanDistance_mm = std::numeric_limits<double>::quiet_NaN(); ///< distance in the plane
    /// σ per axis of unbiased errors that would have this mean: mean·√(π/2).
    double impliedSdPercent = std::numeric_limits<double>::quiet_NaN();
    double impliedSd_mm = std::numeric_limits<double>::quiet_NaN();
    std::vector<ApexBar> bars;
    std::vector<ApexPoint> points;
    std::vector<Warning> warnings;
};

/// Summarises the trials; errors that are not finite are left out. The radius is in metres, above zero.
/// `seed` is for the bootstrap.
ApexSummary summariseApex(const std::vector<ApexTrial>& trials, double radius_m, std::uint64_t seed);

/// A simulated participant for planning only: each has a bias of its own and normal errors around it. The
/// scripted operators in the simulation do not use it.
struct ApexObserver {
    /// Per axis, within a participant (from P2's mean error; 3.6 mm of 20 mm).
    double sdPercent = 17.8;
    double sdBetweenPercent = 0.0; ///< of the participants' own biases
};
std::vector<ApexTrial> simulateApex(const ApexObserver& observer, int participants, int trialsEach,
                                    double radius_m, std::uint64_t seed);

/// What a design can show: in simulated studies, the mean absolute error is tested (t over participants)
/// against a published mean.
struct ApexPlan {
    double meanAbsolutePercent = std::numeric_limits<double>::quiet_NaN();
    /// Mean half width of the 95 % interval.
    double halfWidthPercent = std::numeric_limits<double>::quiet_NaN();
    /// Share of studies whose interval excludes the other mean.
    double power = std::numeric_limits<double>::quiet_NaN();
    /// Monte Carlo standard errors of the three values, due to the limited number of simulated studies.
    double meanError = std::numeric_limits<double>::quiet_NaN(),
           halfWidthError = std::numeric_limits<double>::quiet_NaN();
    double powerError = std::numeric_limits<double>::quiet_NaN(); ///< after Agresti & Coull 1998
};
ApexPlan planApex(const ApexObserver& observer, int participants, int trialsEach, double otherMeanPercent,
                  int studies, std::uint64_t seed);

} // namespace chiron::psychophysics
