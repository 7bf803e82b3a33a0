// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::simulation {

/// What changes from trial to trial of a palpation: the truth that scoring needs.
struct PalpationTrial {
    int lumps = 0; ///< 0: a catch trial
    bool introduction = false; ///< has a lump because the level says so: no evidence of detection
    std::array<Lump, TissueParameters::kMaxLumps> lump{};
    std::array<int, TissueParameters::kMaxLumps> hardness{}; ///< what a person should call each, 1..5

    std::span<const Lump> list() const noexcept { return {lump.data(), static_cast<std::size_t>(lumps)}; }
};

/// A lump's place keeps so far from the border of its region, as a share of the region's width and height: a mark that is a little
/// off is still in the region it is meant for.
inline constexpr double kRegionInset = 0.2;

/// The region of the search area (column + columns·row, from the corner of least x and y) that holds (x, y); -1: outside.
int palpationRegion(const PalpationParameters& parameters, const core::Vec2& p_m) noexcept;
/// The middle of a region, x and y in W.
core::Vec2 palpationRegionMiddle_m(const PalpationParameters& parameters, int region) noexcept;
/// Where each lump goes when the level's control moves it; the place itself where it does not.
core::Vec2 palpationMovedPlace_m(const PalpationParameters& parameters, const core::Vec2& place_m) noexcept;
/// How many lumps the plan of last resort places, from whichever region it begins with: content asks for no more.
int mostPalpationLumps(const PalpationParameters& parameters);

/// Plans every trial of a session from its seed, before the first tick. Which `catchTrials` of the trials have no lump is drawn (never
/// the first where the level introduces itself with a lump);
/// the others draw their number in [low, high], each lump its kind, its depth (kind's ± spread, but never nearer than R/0.75:
/// models.md §3) and a region of its own, in which its place is uniform within kRegionInset. Lumps keep `spacing_m` from each
/// other and from the middles of the tissue's regions (distractors); drawn again until they do, at most 1000 times, after which
/// they lie in the middles of regions that do, from a drawn one on (fewer lumps where there is no room: content was checked).
/// What the control moves keeps all this at both places. Each quantity has its own random stream ("palpation.place", ...), so that
/// changing one draw leaves the others. Pure; allocates.
std::vector<PalpationTrial> planPalpationTrials(const PalpationParameters& parameters, std::uint64_t seed);

} // namespace chiron::simulation
