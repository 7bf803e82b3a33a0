// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/palpation/scoring/finding_matches.h"

#include <utility>
#include <vector>

namespace chiron::scoring {

/// A sum of errors and their number, which can be added up over trials.
struct ErrorSum {
    double sum = 0.0;
    int count = 0;
};

/// Distances of the hits from the positions of their lumps, m.
ErrorSum localisationErrors(const std::vector<FindingMatch>& matches);
/// Errors |reported − true radius| of the hits for which a size was reported, m.
ErrorSum sizeErrors(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                    const std::vector<FindingMatch>& matches);

/// True radii of the hits for which a size was reported, m.
std::vector<double> saidSizes(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                              const std::vector<FindingMatch>& matches);

/// True and reported hardness of the hits that were rated, 1..5.
std::vector<std::pair<int, int>> ratedHits(const PalpationTruth& truth,
                                           const simulation::FindingsBook& findings,
                                           const std::vector<FindingMatch>& matches);

/// Counts of pairs of lumps of different hardness that were both found and rated.
struct HardnessPairs {
    int right = 0; ///< the harder one was rated harder; equal ratings are not right
    int pairs = 0;
    int rated = 0; ///< found lumps with a rating
    /// Share of pairs right if the same ratings were given in random order, 0..1/2.
    double rightByChance = 0.0;
};
HardnessPairs hardnessPairs(const std::vector<std::pair<int, int>>& rated);
/// The same for one trial.
HardnessPairs hardnessPairs(const PalpationTruth& truth, const simulation::FindingsBook& findings,
                            const std::vector<FindingMatch>& matches);

} // namespace chiron::scoring
