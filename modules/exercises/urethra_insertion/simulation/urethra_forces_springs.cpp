// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_springs.h"

#include <cmath>
#include <utility>

namespace chiron::simulation {

namespace {

constexpr double kC1 = 0.92387953251128674;    // cos π/8
constexpr double kS1 = 0.38268343236508977;    // sin π/8
constexpr double kC2 = 0.70710678118654752;    // cos π/4
constexpr double kTan1 = 0.41421356237309505;  // tan π/8
constexpr double kTan05 = 0.19891236737965800; // tan π/16

/// cos(jπ/8), any j.
constexpr double cosOf(int j) {
    constexpr std::array<double, 16> table{1.0,  kC1,  kC2,  kS1,  0.0, -kS1, -kC2, -kC1,
                                           -1.0, -kC1, -kC2, -kS1, 0.0, kS1,  kC2,  kC1};
    return table[static_cast<std::size_t>(((j % 16) + 16) % 16)];
}

constexpr double sinOf(int j) {
    return cosOf(j - 4);
}

/// Spring at a rank in the order of distance from a direction in the wedge 0 … π/16: 0, 1, −1, 2, −2 … 7, −7,
/// 8.
constexpr int springAt(int rank) {
    return rank % 2 == 1 ? (rank + 1) / 2 : -(rank / 2);
}

/// Σ cos(p jπ/8) and Σ sin(p jπ/8) over the first m springs, p = 1, 2, 3.
struct ArcSums {
    std::array<double, 3> cos{};
    std::array<double, 3> sin{};
};

constexpr auto kArcs = [] {
    std::array<ArcSums, RadialSprings::kCount + 1> arcs{};
    for (int m = 1; m < RadialSprings::kCount; ++m) // the sums over all 16 are zero and stay so
        for (int p = 1; p <= 3; ++p) {
            const auto here = static_cast<std::size_t>(m);
            const auto power = static_cast<std::size_t>(p - 1);
            const int j = p * springAt(m - 1);
            arcs[here].cos[power] = arcs[here - 1].cos[power] + cosOf(j);
            arcs[here].sin[power] = arcs[here - 1].sin[power] + sinOf(j);
        }
    return arcs;
}();

} // namespace

RadialSprings::RadialSprings(double ex_m, double en_m) noexcept
    : m_offset_m(std::sqrt(ex_m * ex_m + en_m * en_m)) {
    if (m_offset_m > 0.0) {
        m_ex = ex_m / m_offset_m;
        m_en = en_m / m_offset_m;
    }
}

void RadialSprings::order() noexcept {
    double x = std::abs(m_ex);
    double y = std::abs(m_en);
    bool odd = (m_ex < 0.0) != (m_en < 0.0);
    if (y > x) {
        std::swap(x, y);
        odd = !odd;
    }
    if (y > kTan1 * x) { // reflect at π/8
        const double mirrored = kC2 * (x + y);
        y = kC2 * (x - y);
        x = mirrored;
        odd = !odd;
    }
    if (y > kTan05 * x) { // reflect at π/16
        const double mirrored = kC1 * x + kS1 * y;
        y = kS1 * x - kC1 * y;
        x = mirrored;
        odd = !odd;
    }
    m_cos = x;
    m_sin = y;
    m_turn = odd ? -1.0 : 1.0;
    for (int rank = 0; rank < kCount; ++rank)
        m_c[static_cast<std::size_t>(rank)] = cosOf(springAt(rank)) * x + sinOf(springAt(rank)) * y;
    m_ordered = true;
}

void RadialSprings::sum(int compressed) noexcept {
    m_compressed = compressed;
    const ArcSums& arc = kArcs[static_cast<std::size_t>(compressed)];
    const double cos2 = m_cos * m_cos - m_sin * m_sin;
    const double sin2 = 2.0 * m_cos * m_sin;
    const double cos3 = cos2 * m_cos - sin2 * m_sin;
    const double sin3 = sin2 * m_cos + cos2 * m_sin;
    // Σ cos and Σ sin of p(θ_j − φ)
    const double c1 = arc.cos[0] * m_cos + arc.sin[0] * m_sin;
    const double s1 = arc.sin[0] * m_cos - arc.cos[0] * m_sin;
    const double c2 = arc.cos[1] * cos2 + arc.sin[1] * sin2;
    const double s2 = arc.sin[1] * cos2 - arc.cos[1] * sin2;
    const double c3 = arc.cos[2] * cos3 + arc.sin[2] * sin3;
    const double s3 = arc.sin[2] * cos3 - arc.cos[2] * sin3;
    m_sums.count = compressed;
    m_sums.c = c1;
    m_sums.c2 = 0.5 * (m_sums.count + c2);
    m_sums.c3 = 0.25 * (3.0 * c1 + c3);
    m_sums.s = s1;
    m_sums.sc = 0.5 * s2;
    m_sums.sc2 = 0.25 * (s1 + s3);
}

core::Vec2 RadialSprings::inSection(double along, double across) const noexcept {
    const double turned = m_turn * across;
    return {along * m_ex - turned * m_en, along * m_en + turned * m_ex};
}

} // namespace chiron::simulation
