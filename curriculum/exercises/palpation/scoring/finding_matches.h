// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/palpation/scoring/palpation_truth.h"
#include "modules/exercises/palpation/cues/findings_book.h"

#include <vector>

namespace chiron::scoring {

/// The judgement of one finding.
struct FindingMatch {
    static constexpr int kNone = -1;

    int finding = 0;         ///< its index in the FindingsBook
    int lump = kNone;        ///< the lump it found; kNone: a false alarm
    double distance_m = 0.0; ///< to that lump's position, or to the nearest lump's; infinite if there is no
                             ///< lump
    int region = kNone;      ///< region in which it lies (regionAt); kNone: outside the search area

    bool hit() const noexcept { return lump != kNone; }
};

/// Returns which finding found which lump. Among all pairs of a finding and a lump within reach, the nearest
/// pair is matched first, and each finding and each lump is matched once. The reach is the hit radius, or the
/// lump's own radius if that is larger. The distance is the straight line between the two points on the
/// surface (within 12 mm, and for radii of curvature of at least 30 mm, at most 0.7 % shorter than along the
/// surface). The result has one match per finding, in the order of their numbers. Of pairs at the same
/// distance the lower finding comes first, then the lower lump.
std::vector<FindingMatch> matchesOf(const simulation::FindingsBook& findings, const PalpationTruth& truth);

/// Returns the match of the finding that found this lump, or null if the lump was missed.
const FindingMatch* foundBy(const std::vector<FindingMatch>& matches, int lump) noexcept;

core::Vec3 placeOf(const simulation::Finding& finding) noexcept; ///< W, m

} // namespace chiron::scoring
