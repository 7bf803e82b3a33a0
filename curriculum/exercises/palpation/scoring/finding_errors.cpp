// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/scoring/finding_errors.h"

#include <cmath>
#include <utility>

namespace chiron::scoring {

namespace {

const simulation::Finding& findingOf(const simulation::FindingsBook& findings, const FindingMatch& match) {
    return findings.list()[static_cast<std::size_t>(match.finding)];
}

const LumpTruth& lumpOf(const PalpationTruth& truth, const FindingMatch& hit) {
    return truth.lumps[static_cast<std::size_t>(hit.lump)];
}

} // namespace

ErrorSum localisationErrors(const std::vector<FindingMatch>& matches) {
    ErrorSum errors;
    for (const FindingMatch& match : matches)
        if (match.hit()) {
            errors.sum += match.distance_m;
            ++errors.count;
        }
    return errors;
}

ErrorSum sizeErrors(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                    const std::vector<FindingMatch>& matches) {
    ErrorSum errors;
    for (const FindingMatch& match : matches) {
        const double said_m = findingOf(findings, match).radius_m;
        if (!match.hit() || !(said_m > 0.0))
            continue;
        errors.sum += std::abs(said_m - lumpOf(truth, match).radius_m);
        ++errors.count;
    }
    return errors;
}

std::vector<double> saidSizes(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                              const std::vector<FindingMatch>& matches) {
    std::vector<double> radii_m;
    for (const FindingMatch& match : matches)
        if (match.hit() && findingOf(findings, match).radius_m > 0.0)
            radii_m.push_back(lumpOf(truth, match).radius_m);
    return radii_m;
}

std::vector<std::pair<int, int>> ratedHits(const PalpationTruth& truth,
                                           const simulation::FindingsBook& findings,
                                           const std::vector<FindingMatch>& matches) {
    std::vector<std::pair<int, int>> rated;
    for (const FindingMatch& match : matches)
        if (match.hit() && findingOf(findings, match).hardness > 0)
            rated.emplace_back(lumpOf(truth, match).hardness, findingOf(findings, match).hardness);
    return rated;
}

HardnessPairs hardnessPairs(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                            const std::vector<FindingMatch>& matches) {
    return hardnessPairs(ratedHits(truth, findings, matches));
}

HardnessPairs hardnessPairs(const std::vector<std::pair<int, int>>& rated) {
    HardnessPairs out;
    out.rated = static_cast<int>(rated.size());
    int differently = 0, all = 0;
    for (std::size_t i = 0; i < rated.size(); ++i)
        for (std::size_t k = i + 1; k < rated.size(); ++k) {
            const int truly = rated[i].first - rated[k].first;
            const int said = rated[i].second - rated[k].second;
            out.pairs += truly != 0 ? 1 : 0;
            out.right += truly * said > 0 ? 1 : 0;
            differently += said != 0 ? 1 : 0;
            ++all;
        }
    if (all > 0)
        out.rightByChance = 0.5 * differently / all;
    return out;
}

} // namespace chiron::scoring
