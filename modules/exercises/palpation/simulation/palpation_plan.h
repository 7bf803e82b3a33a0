// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::simulation {

/// The values that change from trial to trial of a palpation: the truth that scoring needs.
struct PalpationTrial {
    int lumps = 0; ///< 0: a catch trial
    /// Has a lump because the level prescribes it, and therefore says nothing about detection.
    bool introduction = false;
    std::array<Lump, TissueParameters::kMaxLumps> lump{};
    /// The rating that a person should give to each, 1..5.
    std::array<int, TissueParameters::kMaxLumps> hardness{};

    std::span<const Lump> list() const noexcept { return {lump.data(), static_cast<std::size_t>(lumps)}; }
};

/// Least distance of a lump from the border of its region, as a share of the region's width and height. A
/// mark that is slightly off is then still in the intended region.
inline constexpr double kRegionInset = 0.2;

/// Index of the region of the search area that contains (x, y): column + columns·row, counted from the corner
/// of least x and y; -1: outside.
int palpationRegion(const PalpationParameters& parameters, const core::Vec2& p_m) noexcept;
/// The middle of a region, x and y in W.
core::Vec2 palpationRegionMiddle_m(const PalpationParameters& parameters, int region) noexcept;
/// Position of a lump after the level's control has moved it; unchanged where the control moves nothing.
core::Vec2 palpationMovedPlace_m(const PalpationParameters& parameters, const core::Vec2& place_m) noexcept;
/// The number of lumps that the fallback plan can place from any region on which it starts. Content must not
/// ask for more.
int mostPalpationLumps(const PalpationParameters& parameters);

/// Plans every trial of a session from its seed, before the first tick. It draws which `catchTrials` of the
/// trials have no lump (never the first one where the level introduces itself with a lump). The other trials
/// draw their number of lumps in [low, high]. Each lump draws its kind, its depth (kind's ± spread, but never
/// nearer than R/0.75: models.md §3) and a region of its own, in which its place is uniform within
/// kRegionInset. Lumps keep `spacing_m` from each other and from the middles of the tissue's regions
/// (distractors). Places are drawn again until they do, at most 1000 times; after that the lumps lie in the
/// middles of regions that satisfy this, beginning with a drawn one (fewer lumps where there is no room;
/// content was checked). A lump that the control moves satisfies this at both positions. Each quantity has
/// its own random stream ("palpation.place", ...), so that changing one draw leaves the others. Pure;
/// allocates.
std::vector<PalpationTrial> planPalpationTrials(const PalpationParameters& parameters, std::uint64_t seed);

} // namespace chiron::simulation
