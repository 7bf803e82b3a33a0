// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/detection_regions.h"

#include <algorithm>
#include <cmath>

namespace chiron::scoring {

namespace {

/// Returns the column or row of a coordinate; none outside |offset| ≤ half.
int cellAt(double offset_m, double half_m, int count) noexcept {
    if (!(std::abs(offset_m) <= half_m))
        return FindingMatch::kNone;
    return std::min(count - 1, static_cast<int>(std::floor((offset_m + half_m) / (2.0 * half_m) * count)));
}

} // namespace

int regionAt(const PalpationTruth& truth, const core::Vec3& place_W) noexcept {
    const int column = cellAt(place_W.x(), truth.areaHalf_m.x(), truth.regionColumns);
    const int row = cellAt(place_W.y(), truth.areaHalf_m.y(), truth.regionRows);
    return column < 0 || row < 0 ? FindingMatch::kNone : row * truth.regionColumns + column;
}

std::vector<DetectionRegion> regionsOf(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                                       const std::vector<FindingMatch>& matches) {
    std::vector<DetectionRegion> regions(static_cast<std::size_t>(truth.regionColumns * truth.regionRows));
    for (const LumpTruth& lump : truth.lumps)
        if (const int region = regionAt(truth, lump.place_W); region >= 0)
            regions[static_cast<std::size_t>(region)].signal = true;
    for (const FindingMatch& match : matches) {
        const int number = match.hit()
                               ? regionAt(truth, truth.lumps[static_cast<std::size_t>(match.lump)].place_W)
                               : match.region;
        if (number < 0)
            continue;
        DetectionRegion& region = regions[static_cast<std::size_t>(number)];
        if (region.signal != match.hit())
            continue; // a false alarm in a region with a lump
        region.reported = true;
        region.confidence =
            std::max(region.confidence,
                     static_cast<int>(findings.list()[static_cast<std::size_t>(match.finding)].confidence));
    }
    return regions;
}

core::DetectionCounts countsOf(const std::vector<DetectionRegion>& regions) noexcept {
    core::DetectionCounts counts;
    for (const DetectionRegion& region : regions) {
        (region.signal ? counts.ofSignal : counts.ofNoise) += 1;
        (region.signal ? counts.hits : counts.falseAlarms) += region.reported ? 1 : 0;
    }
    return counts;
}

} // namespace chiron::scoring
