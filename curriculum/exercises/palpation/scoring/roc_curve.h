// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal_detection.h"
#include "curriculum/exercises/palpation/scoring/detection_regions.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// How often each answer was given, from the surest yes to no: [0] confidence 5 … [4] confidence 1, [5] yes without saying how
/// surely, [6] no. Adds up over trials and sessions.
struct RatingCounts {
    static constexpr std::size_t kAnswers = 7;
    std::array<int, kAnswers> ofSignal{};
    std::array<int, kAnswers> ofNoise{};

    void add(std::span<const DetectionRegion> regions) noexcept;
    RatingCounts& operator+=(const RatingCounts& other) noexcept;
    core::DetectionCounts counts() const noexcept; ///< yes, however surely
};

/// Rates of answering at least so surely.
struct RocPoint {
    double falseAlarmRate = 0.0;
    double hitRate = 0.0;
    int confidence = 5; ///< 5..1; 0: any yes; −1: any answer
};

/// Receiver operating characteristic from ratings (Macmillan & Creelman 2005, ch. 3).
struct RocCurve {
    std::vector<RocPoint> points; ///< from strict (0, 0) to lax (1, 1), both included; as observed, uncorrected
    double area = 0.5;            ///< under the straight lines between them: 0.5 says nothing, 1 is perfect
    /// Sensitivity of unequal variances, d_a = √(2/(1+s²)) (z(H) − s z(F)) (eq. 3.5), at the middle of the points in z coordinates;
    /// s, their slope, is the ratio of the spreads of z(H) and z(F) (reduced major axis: neither is free of error). Absent with
    /// fewer than two different points that are neither 0 nor 1 on both axes.
    std::optional<double> dA;
    std::optional<double> slope;
};

/// Nothing where there is no signal or no noise: a rate of none is no rate.
std::optional<RocCurve> rocOf(const RatingCounts& ratings);

} // namespace chiron::scoring
