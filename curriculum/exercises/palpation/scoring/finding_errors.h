// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/palpation/scoring/finding_matches.h"

#include <utility>
#include <vector>

namespace chiron::scoring {

/// What a sum of errors is made of: adds up over trials.
struct ErrorSum {
    double sum = 0.0;
    int count = 0;
};

/// Distances of hits from their lumps' places, m.
ErrorSum localisationErrors(const std::vector<FindingMatch>& matches);
/// |reported − true radius| of hits whose size was said, m.
ErrorSum sizeErrors(const PalpationTruth& truth, const simulation::FindingsBook& findings, const std::vector<FindingMatch>& matches);

/// The true radii of the hits whose size was said, m.
std::vector<double> saidSizes(const PalpationTruth& truth, const simulation::FindingsBook& findings, const std::vector<FindingMatch>& matches);

/// True and said hardness of the hits that were rated, 1..5.
std::vector<std::pair<int, int>> ratedHits(const PalpationTruth& truth, const simulation::FindingsBook& findings, const std::vector<FindingMatch>& matches);

/// Pairs of lumps of different hardness that were found and rated.
struct HardnessPairs {
    int right = 0; ///< the harder one was called harder; alike is not right
    int pairs = 0;
    int rated = 0; ///< found lumps with a rating
    double rightByChance = 0.0; ///< share of pairs right if the same ratings were given in random order, 0..1/2
};
HardnessPairs hardnessPairs(const std::vector<std::pair<int, int>>& rated);
/// Of one trial.
HardnessPairs hardnessPairs(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                            const std::vector<FindingMatch>& matches);

} // namespace chiron::scoring
