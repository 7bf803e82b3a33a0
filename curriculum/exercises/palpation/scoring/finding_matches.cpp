// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/finding_matches.h"

#include "curriculum/exercises/palpation/scoring/detection_regions.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace chiron::scoring {

namespace {

struct Pair {
    double distance_m = 0.0;
    std::size_t match = 0; ///< index of the match, in the order of findings
    int lump = 0;
};

} // namespace

core::Vec3 placeOf(const simulation::Finding& finding) noexcept {
    return {finding.p_W[0], finding.p_W[1], finding.p_W[2]};
}

const FindingMatch* foundBy(const std::vector<FindingMatch>& matches, int lump) noexcept {
    const auto found = std::find_if(matches.begin(), matches.end(),
                                    [lump](const FindingMatch& o) { return o.lump == lump; });
    return found == matches.end() ? nullptr : &*found;
}

std::vector<FindingMatch> matchesOf(const simulation::FindingsBook& findings, const PalpationTruth& truth) {
    std::vector<FindingMatch> matches;
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < simulation::kMaxFindings; ++i) {
        if (!findings.has(static_cast<int>(i)))
            continue;
        const core::Vec3 place_W = placeOf(findings.list()[i]);
        FindingMatch match{static_cast<int>(i), FindingMatch::kNone, std::numeric_limits<double>::infinity(),
                           regionAt(truth, place_W)};
        for (std::size_t k = 0; k < truth.lumps.size(); ++k) {
            const double distance_m = (place_W - truth.lumps[k].place_W).norm();
            match.distance_m = std::min(match.distance_m, distance_m);
            if (distance_m <= std::max(truth.hitRadius_m, truth.lumps[k].radius_m))
                pairs.push_back({distance_m, matches.size(), static_cast<int>(k)});
        }
        matches.push_back(match);
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
        return std::tie(a.distance_m, a.match, a.lump) < std::tie(b.distance_m, b.match, b.lump);
    });
    for (const Pair& pair : pairs) {
        FindingMatch& match = matches[pair.match];
        if (match.hit() || foundBy(matches, pair.lump) != nullptr)
            continue;
        match.lump = pair.lump;
        match.distance_m = pair.distance_m;
    }
    return matches;
}

} // namespace chiron::scoring
