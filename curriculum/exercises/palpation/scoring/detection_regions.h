// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal_detection.h"
#include "curriculum/exercises/palpation/scoring/finding_matches.h"
#include "curriculum/exercises/palpation/scoring/palpation_truth.h"
#include "modules/exercises/palpation/cues/findings_book.h"

#include <vector>

namespace chiron::scoring {

/// One region of the search area as a unit of detection: whether it had a lump, whether one was reported, and
/// with which confidence.
struct DetectionRegion {
    static constexpr int kSilent = -1; ///< confidence of a region without a report

    bool signal = false; ///< a lump's position lies in it
    /// For a signal region: one of its lumps was found. For a noise region: a false alarm lies in it.
    bool reported = false;
    /// Highest confidence among its reports, 1..5; 0: reported, but without a confidence.
    int confidence = kSilent;
};

/// Returns the number of the region in which a position lies, counted row by row from (−x, −y). A position on
/// the border of two regions belongs to the one further along +x or +y; the area's own far edges belong to
/// the last regions. Returns FindingMatch::kNone outside the search area.
int regionAt(const PalpationTruth& truth, const core::Vec3& place_W) noexcept;

/// Returns all regions of a trial. A finding that found a lump counts for the lump's region, wherever the
/// finding itself lies. A false alarm counts for the lump-free region in which it lies; in a lump's region or
/// outside the area it counts for none.
std::vector<DetectionRegion> regionsOf(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                                       const std::vector<FindingMatch>& matches);

core::DetectionCounts countsOf(const std::vector<DetectionRegion>& regions) noexcept;

} // namespace chiron::scoring
