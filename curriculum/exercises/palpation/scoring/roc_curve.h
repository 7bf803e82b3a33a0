// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal_detection.h"
#include "curriculum/exercises/palpation/scoring/detection_regions.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// Counts of each answer, from the most confident yes to no: [0] confidence 5 … [4] confidence 1, [5] yes
/// without a confidence, [6] no. Counts can be added up over trials and sessions.
struct RatingCounts {
    static constexpr std::size_t kAnswers = 7;
    std::array<int, kAnswers> ofSignal{};
    std::array<int, kAnswers> ofNoise{};

    void add(std::span<const DetectionRegion> regions) noexcept;
    RatingCounts& operator+=(const RatingCounts& other) noexcept;
    core::DetectionCounts counts() const noexcept; ///< yes with any confidence
};

/// Rates of answering with at least this confidence.
struct RocPoint {
    double falseAlarmRate = 0.0;
    double hitRate = 0.0;
    int confidence = 5; ///< 5..1; 0: any yes; −1: any answer
};

/// Receiver operating characteristic from ratings (Macmillan & Creelman 2005, ch. 3).
struct RocCurve {
    /// From strict (0, 0) to lax (1, 1), both included; as observed, uncorrected.
    std::vector<RocPoint> points;
    double area = 0.5; ///< trapezoidal area below the points: 0.5 is chance, 1 is perfect
    /// Sensitivity for unequal variances, d_a = √(2/(1+s²)) (z(H) − s z(F)) (eq. 3.5), at the centroid of the
    /// points in z coordinates. Their slope s is the ratio of the spreads of z(H) and z(F) (reduced major
    /// axis, because neither is free of error). Absent if fewer than two different points lie strictly
    /// between 0 and 1 on both axes.
    std::optional<double> dA;
    std::optional<double> slope;
};

/// Returns none if there is no signal or no noise, because a rate over no cases is undefined.
std::optional<RocCurve> rocOf(const RatingCounts& ratings);

} // namespace chiron::scoring
