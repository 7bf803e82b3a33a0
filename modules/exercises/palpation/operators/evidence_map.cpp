// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/operators/evidence_map.h"

#include <algorithm>
#include <cmath>

namespace chiron::operators {

using core::Vec2;

namespace {
constexpr double kDeviationToSd = 1.4826; ///< for a normal distribution
constexpr double kLeastSd = 0.08;         ///< least noise that it assumes for stiffness: assumption
constexpr double kLeastLeanSd_rad = 0.03;
constexpr double kLeastStiffness_N_per_m = 20.0; ///< anything softer feels like nothing: assumption
constexpr double kFar2 = 9.0;                    ///< (ρ/H)² beyond which a lump is not felt
constexpr double kWidths_m[] = {0.010, 0.013, 0.017};

/// Effect of a lump of amplitude 1 on a press at that distance: share of stiffness, and lean outwards.
struct Expected {
    double y = 0.0;
    double lean_rad = 0.0;
};

Expected expected(double distance2_m2, double width_m, double depth_m) noexcept {
    const double q = 1.0 / (1.0 + distance2_m2 / (width_m * width_m));
    const double g = q * q * q;
    return {g, 3.0 * depth_m * std::sqrt(distance2_m2) / (width_m * width_m) * g * q};
}
} // namespace

void EvidenceMap::clear() noexcept {
    m_count = 0;
    m_explainedCount = 0;
    m_weighed = 0;
    m_evidence.fill(0.0);
}

void EvidenceMap::add(const Press& press) noexcept {
    if (m_count < kMostPresses && press.pressure >= 0 && press.pressure < kPressures)
        m_presses[m_count++] = press;
}

double EvidenceMap::medianOf(std::size_t n) noexcept {
    if (n == 0)
        return 0.0;
    const auto middle = m_scratch.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::nth_element(m_scratch.begin(), middle, m_scratch.begin() + static_cast<std::ptrdiff_t>(n));
    return *middle;
}

void EvidenceMap::settleBackground() noexcept {
    for (int pressure = 0; pressure < kPressures; ++pressure) {
        std::size_t n = 0;
        for (std::size_t i = 0; i < m_count; ++i)
            if (m_presses[i].pressure == pressure)
                m_scratch[n++] = m_presses[i].stiffness_N_per_m;
        const double background = std::max(medianOf(n), kLeastStiffness_N_per_m);
        for (std::size_t i = 0; i < m_count; ++i)
            if (m_presses[i].pressure == pressure)
                m_residues[i] = {m_presses[i].stiffness_N_per_m / background - 1.0, m_presses[i].lean_rad};
    }
    for (std::size_t i = 0; i < m_count; ++i)
        m_scratch[i] = m_presses[i].depth_m;
    m_depth_m = std::clamp(medianOf(m_count), 0.001, 0.012);
}

void EvidenceMap::leaveOutExplained() noexcept {
    for (std::size_t lump = 0; lump < m_explainedCount; ++lump)
        for (std::size_t i = 0; i < m_count; ++i) {
            const Vec2 away = m_presses[i].place_m - m_explained[lump].place_m;
            const double distance2 = away.squaredNorm();
            const Expected e = expected(distance2, m_explained[lump].width_m, m_depth_m);
            m_residues[i].y -= m_explained[lump].amplitude * e.y;
            if (distance2 > 1e-12)
                m_residues[i].lean_rad -=
                    m_explained[lump].amplitude * e.lean_rad / std::sqrt(distance2) * away;
        }
}

void EvidenceMap::settleNoise() noexcept {
    for (std::size_t i = 0; i < m_count; ++i)
        m_scratch[i] = std::abs(m_residues[i].y);
    m_ySd = std::max(kLeastSd, kDeviationToSd * medianOf(m_count));
    double sum = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
        for (std::size_t i = 0; i < m_count; ++i)
            m_scratch[i] = std::abs(m_residues[i].lean_rad[axis]);
        sum += kDeviationToSd * medianOf(m_count);
    }
    m_leanSd_rad = std::max(kLeastLeanSd_rad, 0.5 * sum);
}

void EvidenceMap::begin() noexcept {
    settleBackground();
    leaveOutExplained();
    settleNoise();
    m_weighed = 0;
}

EvidenceMap::Weighed EvidenceMap::weigh(const Vec2& place_m, double width_m) const noexcept {
    const double far2 = kFar2 * width_m * width_m;
    const double yWeight = 1.0 / (m_ySd * m_ySd), leanWeight = 1.0 / (m_leanSd_rad * m_leanSd_rad);
    double speaks = 0.0, most = 0.0;
    for (std::size_t i = 0; i < m_count; ++i) {
        const Vec2 away = m_presses[i].place_m - place_m;
        const double distance2 = away.squaredNorm();
        if (distance2 > far2)
            continue;
        const Expected e = expected(distance2, width_m, m_depth_m);
        speaks += yWeight * e.y * m_residues[i].y;
        most += yWeight * e.y * e.y;
        if (distance2 > 1e-12) {
            speaks += leanWeight * e.lean_rad * m_residues[i].lean_rad.dot(away) / std::sqrt(distance2);
            most += leanWeight * e.lean_rad * e.lean_rad;
        }
    }
    if (!(most > yWeight * 0.1)) // nothing was felt near this place
        return {};
    return {speaks / most, speaks / std::sqrt(most)};
}

Vec2 EvidenceMap::placeOf(int column, int row) const noexcept {
    const double step = 2.0 / (kSide - 1);
    return {m_half_m.x() * (step * column - 1.0), m_half_m.y() * (step * row - 1.0)};
}

bool EvidenceMap::nearExplained(const Vec2& place_m) const noexcept {
    for (std::size_t lump = 0; lump < m_explainedCount; ++lump)
        if ((m_explained[lump].place_m - place_m).norm() < kApart_m)
            return true;
    return false;
}

bool EvidenceMap::advance(int places) noexcept {
    const int all = kSide * kSide;
    const int until = std::min(all, m_weighed + places);
    for (; m_weighed < until; ++m_weighed) {
        const Vec2 place = placeOf(m_weighed % kSide, m_weighed / kSide);
        m_evidence[static_cast<std::size_t>(m_weighed)] =
            nearExplained(place) ? 0.0 : weigh(place, kUsualWidth_m).evidence;
    }
    return m_weighed == all;
}

Suspicion EvidenceMap::strongest() const noexcept {
    const auto top =
        static_cast<int>(std::max_element(m_evidence.begin(), m_evidence.end()) - m_evidence.begin());
    Suspicion best;
    const int column = top % kSide, row = top / kSide;
    const auto at = [&](int c, int r) { return m_evidence[static_cast<std::size_t>(r * kSide + c)]; };
    if (!(at(column, row) > 0.0))
        return best;
    best.place_m = placeOf(column, row);
    // Vertex of the parabola through three values
    const auto between = [&](double left, double middle, double right) {
        const double bend = left - 2.0 * middle + right;
        return bend < -1e-9 ? std::clamp(0.5 * (left - right) / bend, -0.5, 0.5) : 0.0;
    };
    const double step = 2.0 / (kSide - 1);
    if (column > 0 && column + 1 < kSide)
        best.place_m.x() +=
            step * m_half_m.x() * between(at(column - 1, row), at(column, row), at(column + 1, row));
    if (row > 0 && row + 1 < kSide)
        best.place_m.y() +=
            step * m_half_m.y() * between(at(column, row - 1), at(column, row), at(column, row + 1));
    return this->at(best.place_m);
}

Suspicion EvidenceMap::at(const Vec2& place_m) const noexcept {
    Suspicion best{place_m, 0.0, 0.0, kUsualWidth_m};
    for (const double width : kWidths_m) {
        const Weighed w = weigh(place_m, width);
        if (w.evidence > best.evidence)
            best = {place_m, w.amplitude, w.evidence, width};
    }
    return best;
}

void EvidenceMap::explain(const Suspicion& lump) noexcept {
    if (m_explainedCount < kMostExplained)
        m_explained[m_explainedCount++] = lump;
}

} // namespace chiron::operators
