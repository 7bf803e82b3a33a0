// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wtype-limits"
#pragma GCC diagnostic ignored "-Wtautological-compare"
#pragma GCC diagnostic ignored "-Wbool-compare"
#pragma GCC diagnostic ignored "-Wdiv-by-zero"
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#pragma GCC diagnostic ignored "-Wdangling-else"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#pragma GCC diagnostic ignored "-Waddress"
#pragma GCC diagnostic ignored "-Wnonnull"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wbool-operation"
#pragma GCC diagnostic ignored "-Wreturn-type"
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-value"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-label"
#pragma GCC diagnostic ignored "-Wunused-result"
#ifndef CHIRON_MUTANT_SWITCH
#define CHIRON_MUTANT_SWITCH
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
namespace chiron_mutants {
inline unsigned char unread[4096];
inline unsigned char* openMarks() {
    const char* path = std::getenv("CHIRON_MUTANTS_REACHED");
    const int file = path ? ::open(path, O_RDWR) : -1;
    void* marks = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof unread, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        ::close(file);
    return marks == MAP_FAILED ? unread : static_cast<unsigned char*>(marks);
}
inline int chosen() {
    const char* number = std::getenv("CHIRON_MUTANT");
    return number ? std::atoi(number) : 0;
}
inline unsigned char* marks = openMarks();
inline int current = chosen();
constexpr bool on(int number) {
    if (__builtin_is_constant_evaluated())
        return false;
    if (marks)
        marks[number] = 1;
    return current == number;
}
}
#endif
#include "scoring/detection/roc_curve.h"

#include "core/normal_distribution.h"

#include <cmath>
#include <numeric>

namespace chiron::scoring {

namespace {

constexpr int kSurest = 5;

std::size_t answerOf(const DetectionRegion& region) noexcept {
    if (!region.reported)
        return RatingCounts::kAnswers - 1;
    return region.confidence >= 1 && region.confidence <= kSurest ? static_cast<std::size_t>(kSurest - region.confidence) : kSurest;
}

double trapezoids(const std::vector<RocPoint>& points) {
    double area = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        area += 0.5 * (points[i].falseAlarmRate - points[i - 1].falseAlarmRate) * (points[i].hitRate + points[i - 1].hitRate);
    return area;
}

bool isInside(double rate) { return rate > 0.0 && rate < 1.0; }

/// Slope and d_a from the points that have finite z on both axes.
void fitLine(RocCurve& curve) { if (chiron_mutants::on(31)) {
    std::vector<std::pair<double, double>> z; // of F and H
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
    curve.dA = std::sqrt(2.0 / (1.0 + s * s)) * (meanH + s * meanF);
} else {
    std::vector<std::pair<double, double>> z; // of F and H
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
} }

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
        curve.points.push_back({static_cast<double>(alarms) / n.ofNoise, static_cast<double>(hits) / n.ofSignal,
                                kSurest - static_cast<int>(i)});
    }
    curve.area = trapezoids(curve.points);
    fitLine(curve);
    return curve;
}

} // namespace chiron::scoring
