// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/random.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

/// Detection counted anew, apart from modules/scoring: marks to lumps greedily by distance, regions as the
/// unit of d′, and the interval that the counts themselves allow.
namespace chiron::support {

/// Inverse of the standard normal distribution, by bisection of erfc: exact enough and short.
inline double probit(double p) {
    double low = -8.0, high = 8.0;
    for (int i = 0; i < 80; ++i) {
        const double middle = 0.5 * (low + high);
        (0.5 * std::erfc(-middle / std::sqrt(2.0)) < p ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

struct Detection {
    int hits = 0, misses = 0, falseAlarms = 0;
    int signal = 0, signalHit = 0, empty = 0, emptyMarked = 0; ///< regions
    std::vector<double> distances_m;                           ///< of the hits
    std::vector<double> sizeErrors_m;
    int ordered = 0, pairs = 0; ///< of lumps of different hardness found in one trial

    double hitRate() const { return (signalHit + 0.5) / (signal + 1.0); } ///< log-linear
    double falseRate() const { return (emptyMarked + 0.5) / (empty + 1.0); }
    double dPrime() const { return probit(hitRate()) - probit(falseRate()); }
    double criterion() const { return -0.5 * (probit(hitRate()) + probit(falseRate())); }
    /// Standard error of d′ from its own counts (Gourevitch & Galanter 1967, Psychometrika 32:25).
    double dPrimeError() const {
        const auto part = [](double rate, int n) {
            const double z = probit(rate),
                         density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * 3.14159265358979323846);
            return rate * (1.0 - rate) / ((n + 1.0) * density * density);
        };
        return std::sqrt(part(hitRate(), signal) + part(falseRate(), empty));
    }
    double meanDistance_m() const {
        double sum = 0.0;
        for (const double d : distances_m)
            sum += d;
        return distances_m.empty() ? std::nan("") : sum / static_cast<double>(distances_m.size());
    }
    double hitShare() const {
        return hits + misses > 0 ? static_cast<double>(hits) / (hits + misses) : std::nan("");
    }
    double hitShareError() const { ///< Agresti & Coull 1998: not zero at the ends
        const double n = hits + misses + 4.0, p = (hits + 2.0) / n;
        return std::sqrt(p * (1.0 - p) / n);
    }
};

struct Mean {
    double value = 0.0, error = 0.0;
};
/// With its standard error.
inline Mean meanOf(const std::vector<double>& values) {
    double sum = 0.0, squares = 0.0;
    for (const double v : values) {
        sum += v;
        squares += v * v;
    }
    const double n = static_cast<double>(values.size()), mean = sum / n;
    return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean) / std::max(1.0, n - 1.0))};
}
inline double errorOf(double a, double b) {
    return std::sqrt(a * a + b * b);
}

inline int regionOf(const simulation::PalpationParameters& p, const core::Vec2& place_m) {
    const auto cell = [](double x, double half, int n) {
        return std::clamp(static_cast<int>(std::floor((x + half) / (2.0 * half) * n)), 0, n - 1);
    };
    return cell(place_m.y(), p.areaHalf_m.y(), p.regionRows) * p.regionColumns +
           cell(place_m.x(), p.areaHalf_m.x(), p.regionColumns);
}

inline void countTrial(Detection& d, const simulation::PalpationParameters& p,
                       const std::vector<simulation::Lump>& lumps,
                       const std::array<simulation::Finding, simulation::kMaxFindings>& findings) {
    struct Pair {
        double distance;
        std::size_t lump, mark;
    };
    std::vector<Pair> near;
    for (std::size_t l = 0; l < lumps.size(); ++l)
        for (std::size_t m = 0; m < findings.size(); ++m) {
            const double distance =
                (core::Vec2(findings[m].p_W[0], findings[m].p_W[1]) - lumps[l].place_m).norm();
            if (findings[m].present && distance <= std::max(p.hitRadius_m, lumps[l].radius_m))
                near.push_back({distance, l, m});
        }
    std::sort(near.begin(), near.end(), [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    std::vector<int> markOf(lumps.size(), -1);
    std::vector<bool> used(findings.size(), false);
    for (const Pair& pair : near)
        if (markOf[pair.lump] < 0 && !used[pair.mark]) {
            markOf[pair.lump] = static_cast<int>(pair.mark);
            used[pair.mark] = true;
            d.distances_m.push_back(pair.distance);
            if (findings[pair.mark].radius_m > 0.0)
                d.sizeErrors_m.push_back(std::abs(findings[pair.mark].radius_m - lumps[pair.lump].radius_m));
        }
    std::vector<int> signal(static_cast<std::size_t>(p.regionColumns * p.regionRows),
                            0); // 0 empty, 1 missed, 2 hit
    for (std::size_t l = 0; l < lumps.size(); ++l) {
        (markOf[l] >= 0 ? d.hits : d.misses) += 1;
        int& region = signal[static_cast<std::size_t>(regionOf(p, lumps[l].place_m))];
        region = std::max(region, markOf[l] >= 0 ? 2 : 1);
        for (std::size_t k = 0; k < l; ++k)
            if (markOf[k] >= 0 && markOf[l] >= 0 && lumps[k].ratio != lumps[l].ratio) {
                const int said = static_cast<int>(findings[static_cast<std::size_t>(markOf[k])].hardness) -
                                 static_cast<int>(findings[static_cast<std::size_t>(markOf[l])].hardness);
                ++d.pairs;
                d.ordered += (said > 0) == (lumps[k].ratio > lumps[l].ratio) && said != 0 ? 1 : 0;
            }
    }
    std::vector<bool> marked(signal.size(), false);
    for (std::size_t m = 0; m < findings.size(); ++m)
        if (findings[m].present && !used[m]) {
            ++d.falseAlarms;
            marked[static_cast<std::size_t>(regionOf(p, {findings[m].p_W[0], findings[m].p_W[1]}))] = true;
        }
    for (std::size_t r = 0; r < signal.size(); ++r) {
        if (signal[r] == 0) {
            ++d.empty;
            d.emptyMarked += marked[r] ? 1 : 0;
        } else {
            ++d.signal;
            d.signalHit += signal[r] == 2 ? 1 : 0;
        }
    }
}

/// So many lumps of one kind, anywhere in the area but near its edge, apart from each other.
inline std::vector<simulation::Lump> drawLumps(const simulation::PalpationParameters& p,
                                               const simulation::LumpKind& kind, int count,
                                               core::Random& random) {
    std::vector<simulation::Lump> lumps;
    for (int tries = 0; static_cast<int>(lumps.size()) < count && tries < 1000; ++tries) {
        const core::Vec2 half = p.areaHalf_m - core::Vec2(0.008, 0.008);
        const double x = random.uniform(-half.x(), half.x());
        const core::Vec2 place(x, random.uniform(-half.y(), half.y()));
        const bool apart = std::all_of(lumps.begin(), lumps.end(), [&](const simulation::Lump& other) {
            return (other.place_m - place).norm() >= p.spacing_m;
        });
        if (apart)
            lumps.push_back({place, kind.depth_m, kind.radius_m, kind.ratio});
    }
    return lumps;
}

} // namespace chiron::support
