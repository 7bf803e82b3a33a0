// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/palpation/operators/search_path.h"

#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::operators {

using core::Vec2;

namespace {
/// Equidistant positions along [low, high], about `spacing` apart; the outer ones are half a step from the
/// ends.
struct Steps {
    Steps(double low, double high, double spacing) noexcept
        : count(std::max(1, static_cast<int>(std::lround((high - low) / spacing)))),
          step((high - low) / count), first(low + 0.5 * step) {}
    double at(int i) const noexcept { return first + step * i; }
    int count;
    double step;
    double first;
};

/// Positions of a hand with two fingers side by side, chosen so that the fingers together press all columns.
/// A block has twice as many columns as lie between the fingers, and the second finger presses the second
/// half of each block; of the last block only the remaining columns are used.
struct Columns {
    Columns(const SearchShare& share, double spacing_m) noexcept {
        const double width = share.high_m.x() - share.low_m.x();
        if (share.fingers < 2) {
            const Steps single(share.low_m.x(), share.high_m.x(), spacing_m);
            count = single.count;
            for (int i = 0; i < std::min(count, kMost); ++i)
                x[static_cast<std::size_t>(i)] = single.at(i);
            return;
        }
        const int inner = std::max(1, static_cast<int>(std::lround(share.fingerSpacing_m / spacing_m)));
        const double step = share.fingerSpacing_m / inner;
        const int all = std::max(1, static_cast<int>(std::lround(width / step)));
        const double first = share.low_m.x() + 0.5 * (width - all * step) + 0.5 * step;
        for (int begun = 0; begun < all; begun += 2 * inner) {
            const int left = std::min(all - begun, 2 * inner), moves = std::min(left, inner);
            for (int i = 0; i < moves && count < kMost; ++i)
                x[static_cast<std::size_t>(count++)] = first + step * (begun + left - moves - inner + i);
        }
    }
    static constexpr int kMost = 128;
    int count = 0;
    std::array<double, kMost> x{};
};
} // namespace

void SearchPath::add(const Vec2& spot_m) noexcept {
    if (m_count < kMost)
        m_spots[m_count++] = spot_m;
}

bool SearchPath::next(Vec2& spot_m) noexcept {
    if (m_next >= m_count)
        return false;
    spot_m = m_spots[m_next++];
    return true;
}

void SearchPath::plan(const PalpationOperatorSettings& settings, const SearchShare& whole, int most,
                      core::Random& random_) noexcept {
    clear();
    SearchShare share = whole;
    const Vec2 middle = 0.5 * (whole.low_m + whole.high_m);
    share.low_m = middle + settings.reach * (whole.low_m - middle);
    share.high_m = middle + settings.reach * (whole.high_m - middle);
    const int spots = std::clamp(most, 4, static_cast<int>(kMost));
    const Vec2 size = share.high_m - share.low_m;
    const double spacing =
        std::max(settings.spacing_m, std::sqrt(size.x() * size.y() / (spots * share.fingers)));
    switch (settings.search) {
    case SearchKind::grid:
        return grid(settings, share, spots);
    case SearchKind::spiral:
        return spiral(spacing, share);
    case SearchKind::random:
        return random(share, spots, random_);
    }
}

void SearchPath::grid(const PalpationOperatorSettings& settings, const SearchShare& share,
                      int most) noexcept {
    double spacing = settings.spacing_m;
    const double height = share.high_m.y() - share.low_m.y();
    while (Columns(share, spacing).count * Steps(0.0, height, spacing).count > most && spacing < 0.05)
        spacing *= 1.03;
    const Steps rows(share.low_m.y(), share.high_m.y(), spacing);
    const Columns columns(share, spacing);
    for (int column = 0; column < std::min(columns.count, Columns::kMost); ++column)
        for (int row = 0; row < rows.count; ++row)
            add({columns.x[static_cast<std::size_t>(column)],
                 rows.at(column % 2 == 0 ? row : rows.count - 1 - row)});
}

/// r = spacing·φ/2π in a square, stretched to the area, with spots one spacing apart along the spiral.
void SearchPath::spiral(double spacing_m, const SearchShare& share) noexcept {
    const Vec2 middle = 0.5 * (share.low_m + share.high_m), half = 0.5 * (share.high_m - share.low_m);
    const double mean = std::sqrt(half.x() * half.y());
    double angle = 0.0;
    for (double radius = 0.0; radius < mean && m_count < kMost;
         radius = spacing_m * angle / (2.0 * core::kPi)) {
        add(middle + radius / mean * Vec2(half.x() * std::cos(angle), half.y() * std::sin(angle)));
        angle += radius < 0.5 * spacing_m ? core::kPi / 3.0 : spacing_m / radius;
    }
}

void SearchPath::random(const SearchShare& share, int most, core::Random& random) noexcept {
    for (int i = 0; i < most; ++i) {
        const double x = random.uniform(share.low_m.x(), share.high_m.x());
        add({x, random.uniform(share.low_m.y(), share.high_m.y())});
    }
}

} // namespace chiron::operators
