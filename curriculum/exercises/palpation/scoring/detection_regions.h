// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/findings_book.h"
#include "core/signal_detection.h"
#include "curriculum/exercises/palpation/scoring/finding_matches.h"
#include "curriculum/exercises/palpation/scoring/palpation_truth.h"

#include <vector>

namespace chiron::scoring {

/// One region of the search area as a unit of detection: was a lump there, was one reported, and how surely.
struct DetectionRegion {
    static constexpr int kSilent = -1; ///< confidence of a region that nothing was reported of

    bool signal = false;   ///< the place of a lump lies in it
    bool reported = false; ///< signal: one of its lumps was found; noise: a false alarm lies in it
    int confidence = kSilent; ///< the highest of what was reported of it, 1..5; 0: reported, but nobody said how surely
};

/// Number of the region in which a place lies, row by row from (−x, −y); a place on the border of two belongs to the one further
/// along +x or +y, the area's own far edges to the last ones. FindingMatch::kNone outside the search area.
int regionAt(const PalpationTruth& truth, const core::Vec3& place_W) noexcept;

/// All regions of a trial. A finding that found a lump counts for the lump's region, wherever it lies itself; a false alarm for the
/// lump-free region in which it lies: in a lump's region or outside the area it is none of any region's.
std::vector<DetectionRegion> regionsOf(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                                       const std::vector<FindingMatch>& matches);

core::DetectionCounts countsOf(const std::vector<DetectionRegion>& regions) noexcept;

} // namespace chiron::scoring
