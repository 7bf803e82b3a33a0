// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/random.h"
#include "modules/exercises/palpation/operators/palpation_operator_settings.h"

#include <array>
#include <cstddef>

namespace chiron::operators {

/// The part of the search area that one hand takes, and the fingers with which it searches it.
/// Unit: m.
/// Frame: W.
struct SearchShare {
    core::Vec2 low_m = core::Vec2::Zero();
    core::Vec2 high_m = core::Vec2::Zero();
    int fingers = 1;
    double fingerSpacing_m = 0.018; ///< along x
};

/// The spots that a hand intends to press in one trial, in order, as positions of its first finger. Fixed
/// size; allocates nothing.
class SearchPath {
public:
    static constexpr std::size_t kMost = 256;

    /// Plans spots as close together as possible with at most `most` (at least 4) spots, but not closer than
    /// the settings say.
    void plan(const PalpationOperatorSettings& settings, const SearchShare& share, int most,
              core::Random& random) noexcept;
    void clear() noexcept { m_count = m_next = 0; }
    bool next(core::Vec2& spot_m) noexcept;
    std::size_t spots() const noexcept { return m_count; }

private:
    void add(const core::Vec2& spot_m) noexcept;
    void grid(const PalpationOperatorSettings& settings, const SearchShare& share, int most) noexcept;
    void spiral(double spacing_m, const SearchShare& share) noexcept;
    void random(const SearchShare& share, int most, core::Random& random) noexcept;

    std::size_t m_count = 0;
    std::size_t m_next = 0;
    std::array<core::Vec2, kMost> m_spots{};
};

} // namespace chiron::operators
