// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/arrangement.h"

#include <limits>
#include <vector>

namespace chiron::psychophysics {

/// Number of answers of one kind at one difference D (log10 of the ratio). Kinds: rank3, rank3_ties: the
/// outcome; same_different: 2·(the two differed) + (said "different"); yes_no: 2·(multiple shown) + (said
/// yes); 2afc, 3afc, oddity: 1 right, 0 wrong.
struct AnswerCount {
    double difference = 0.0;
    int kind = 0;
    double count = 0.0;
};

/// Limits of the prior of log10 σ and of the uniform prior of the criterion (yes_no: in log10 units;
/// same_different, rank3_ties: in σ). The prior of log10 σ is uniform up to `evenUpTo`. An observer with a
/// larger σ is close to guessing at every difference; above `evenUpTo` the prior is therefore uniform in the
/// distance of the answers from guessing: in (D/σ), or in its square if the task does not reveal the sign of
/// a difference (oddity, same_different).
struct ThurstonePrior {
    double lowLog10Sigma = -3.0;
    double highLog10Sigma = 0.0;
    /// log10 of the largest difference D presented.
    double evenUpTo = std::numeric_limits<double>::infinity();
    double lowCriterion = 0.0;
    double highCriterion = 0.0;
};

/// One point of the posterior.
struct ThurstonePoint {
    double log10Sigma = 0.0;
    double lapse = 0.0;
    double criterion = 0.0;
};

/// Posterior of a Thurstone observer (case V: every observation has independent noise of sd σ, in log10
/// units). With probability λ (prior Beta(1, 30) below 0.3: mean 0.03) an answer is a guess among all;
/// otherwise it follows the task's rule. rank3: order by size (rank3_ties: neighbours nearer than the
/// criterion are equal); 2afc and 3afc: the largest; oddity: the farthest from the others; same_different:
/// "different" beyond a criterion; yes_no: yes if the percept exceeds the remembered reference (which has the
/// same noise) by a criterion.
struct ThurstonePosterior {
    bool known = false;
    double medianLog10Sigma = std::numeric_limits<double>::quiet_NaN();
    double meanLog10Sigma = std::numeric_limits<double>::quiet_NaN();
    double sdLog10Sigma = std::numeric_limits<double>::quiet_NaN();
    double lowLog10Sigma = std::numeric_limits<double>::quiet_NaN(); ///< limits of the central 95 % interval
    double highLog10Sigma = std::numeric_limits<double>::quiet_NaN();
    double meanLapse = std::numeric_limits<double>::quiet_NaN();
    double criterion = std::numeric_limits<double>::quiet_NaN(); ///< median, with its central 95 % interval
    double lowCriterion = std::numeric_limits<double>::quiet_NaN();
    double highCriterion = std::numeric_limits<double>::quiet_NaN();
    /// Density of log10 σ at the ends of its prior relative to the largest density, for a prior that is
    /// uniform throughout.
    double densityAtLowSigma = 0.0;
    double densityAtHighSigma = 0.0;
    /// Points spread evenly over the posterior, each equally likely; for bands.
    std::vector<ThurstonePoint> draws;
};

/// Returns the standard deviation of log10 σ under the prior alone.
double priorLog10SigmaSd(Task task, const ThurstonePrior& prior) noexcept;

/// Returns the probability of an answer of this kind (see AnswerCount) at difference D.
double answerProbability(Task task, double difference, int kind, const ThurstonePoint& at) noexcept;

/// Computes the posterior on successive grids: over the whole prior first, then over the region with
/// posterior mass, repeated as long as that fills only a small part of σ, criterion or lapse. Unknown without
/// answers, and for adjustment and magnitude. Sums are in a fixed order, so the result is deterministic. The
/// time grows with the number of distinct (difference, kind), not with the counts.
ThurstonePosterior thurstonePosterior(Task task, const std::vector<AnswerCount>& counts,
                                      const ThurstonePrior& prior, int draws = 400);

} // namespace chiron::psychophysics
