// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/roc_curve.h"

#include "core/normal_distribution.h"

#include <cmath>
#include <numeric>

namespace chiron::scoring {

namespace {

constexpr int kSurest = 5;

std::size_t answerOf(const DetectionRegion& region) noexcept {
    if (!region.reported)
        return RatingCounts::kAnswers - 1;
    return region.confidence >= 1 && region.confidence <= kSurest
               ? static_cast<std::size_t>(kSurest - region.confidence)
               : kSurest;
}

double trapezoids(const std::vector<RocPoint>& points) {
    double area = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        area += 0.5 * (points[i].falseAlarmRate - points[i - 1].falseAlarmRate) *
                (points[i].hitRate + points[i - 1].hitRate);
    return area;
}

bool isInside(double rate) {
    return rate > 0.0 && rate < 1.0;
}

/// Fits slope and d_a to the points that have finite z on both axes.
void fitLine(RocCurve& curve) {
    std::vector<std::pair<double, double>> z; // pairs of z(F) and z(H)
    for (const RocPoint& point : curve.points)
        if (isInside(point.falseAlarmRate) && isInside(point.hitRate))
            z.emplace_back(core::normalQuantile(point.falseAlarmRate), core::normalQuantile(point.hitRate));
    double meanF = 0.0;
    double meanH = 0.0;
    for (const auto& [f, h] : z) {
        meanF += f / static_cast<double>(z.size());
        meanH += h / static_cast<double>(z.size());
    }
    double spreadF = 0.0;
    double spreadH = 0.0;
    for (const auto& [f, h] : z) {
        spreadF += (f - meanF) * (f - meanF);
        spreadH += (h - meanH) * (h - meanH);
    }
    if (!(spreadF > 0.0) || !(spreadH > 0.0))
        return;
    const double s = std::sqrt(spreadH / spreadF);
    curve.slope = s;
    curve.dA = std::sqrt(2.0 / (1.0 + s * s)) * (meanH - s * meanF);
}

} // namespace

void RatingCounts::add(std::span<const DetectionRegion> regions) noexcept {
    for (const DetectionRegion& region : regions)
        ++(region.signal ? ofSignal : ofNoise)[answerOf(region)];
}

RatingCounts& RatingCounts::operator+=(const RatingCounts& other) noexcept {
    for (std::size_t i = 0; i < kAnswers; ++i) {
        ofSignal[i] += other.ofSignal[i];
        ofNoise[i] += other.ofNoise[i];
    }
    return *this;
}

core::DetectionCounts RatingCounts::counts() const noexcept {
    const int n1 = std::accumulate(ofSignal.begin(), ofSignal.end(), 0);
    const int n0 = std::accumulate(ofNoise.begin(), ofNoise.end(), 0);
    return {n1 - ofSignal.back(), n1, n0 - ofNoise.back(), n0};
}

std::optional<RocCurve> rocOf(const RatingCounts& ratings) {
    const core::DetectionCounts n = ratings.counts();
    if (n.ofSignal == 0 || n.ofNoise == 0)
        return std::nullopt;
    RocCurve curve;
    curve.points.push_back({0.0, 0.0, kSurest + 1});
    int hits = 0;
    int alarms = 0;
    for (std::size_t i = 0; i < RatingCounts::kAnswers; ++i) {
        hits += ratings.ofSignal[i];
        alarms += ratings.ofNoise[i];
        curve.points.push_back({static_cast<double>(alarms) / n.ofNoise,
                                static_cast<double>(hits) / n.ofSignal, kSurest - static_cast<int>(i)});
    }
    curve.area = trapezoids(curve.points);
    fitLine(curve);
    return curve;
}

} // namespace chiron::scoring
