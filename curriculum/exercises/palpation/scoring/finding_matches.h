// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/findings_book.h"
#include "curriculum/exercises/palpation/scoring/palpation_truth.h"

#include <vector>

namespace chiron::scoring {

/// What became of a finding.
struct FindingMatch {
    static constexpr int kNone = -1;

    int finding = 0;        ///< its number in the book
    int lump = kNone;       ///< the lump it found; kNone: a false alarm
    double distance_m = 0.0; ///< to that lump's place, or to the nearest lump's; infinite where there is none
    int region = kNone;     ///< in which it lies (regionAt); kNone: outside the search area

    bool hit() const noexcept { return lump != kNone; }
};

/// Which finding found which lump: among all pairs of a finding and a lump within reach, the nearest pair first, each finding and
/// each lump once. Reach is the hit radius, or the lump's own radius where that is larger; distance is the straight line between the
/// two places on the surface (within 12 mm and radii of curvature from 30 mm on at most 0.7 % shorter than along it). One match a
/// finding, in the order of their numbers. Pairs at the same distance: lower finding, then lower lump.
std::vector<FindingMatch> matchesOf(const simulation::FindingsBook& findings, const PalpationTruth& truth);

/// The match of the finding that found this lump, or null: missed.
const FindingMatch* foundBy(const std::vector<FindingMatch>& matches, int lump) noexcept;

core::Vec3 placeOf(const simulation::Finding& finding) noexcept; ///< W, m

} // namespace chiron::scoring
