// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/arrangement.h"

#include <limits>
#include <vector>

namespace chiron::psychophysics {

/// So many answers of one kind at one difference D (log10 of the ratio). Kinds: rank3, rank3_ties: the outcome; same_different: 2·(the two
/// differed) + (said "different"); yes_no: 2·(multiple shown) + (said yes); 2afc, 3afc, oddity: 1 right, 0 wrong.
struct AnswerCount {
    double difference = 0.0;
    int kind = 0;
    double count = 0.0;
};

/// Ends of the prior of log10 σ; and of the uniform one of the criterion (yes_no: log10 units; same_different, rank3_ties: in σ). That of log10 σ is
/// even up to `evenUpTo`; an observer with a larger σ is near guessing at every difference, and the prior is even in how far answers are from guessing
/// there: in (D/σ), or in its square where the task does not tell the sign of a difference (oddity, same_different).
struct ThurstonePrior {
    double lowLog10Sigma = -3.0;
    double highLog10Sigma = 0.0;
    double evenUpTo = std::numeric_limits<double>::infinity(); ///< log10 of the largest difference D presented
    double lowCriterion = 0.0;
    double highCriterion = 0.0;
};

/// One point of the posterior.
struct ThurstonePoint {
    double log10Sigma = 0.0;
    double lapse = 0.0;
    double criterion = 0.0;
};

/// Posterior of a Thurstone observer (case V: every observation has independent noise of sd σ, in log10 units): an answer is a guess among
/// all with probability λ (prior Beta(1, 30) below 0.3: mean 0.03), else follows the task's rule: rank3 by size (rank3_ties: neighbours nearer than the criterion are equal); 2afc and 3afc the
/// largest; oddity the farthest from the others; same_different "different" beyond a criterion; yes_no yes where it
/// exceeds the remembered reference (felt with the same noise) by a criterion.
struct ThurstonePosterior {
    bool known = false;
    double medianLog10Sigma = std::numeric_limits<double>::quiet_NaN();
    double meanLog10Sigma = std::numeric_limits<double>::quiet_NaN();
    double sdLog10Sigma = std::numeric_limits<double>::quiet_NaN();
    double lowLog10Sigma = std::numeric_limits<double>::quiet_NaN();  ///< of the central 95 % interval
    double highLog10Sigma = std::numeric_limits<double>::quiet_NaN();
    double meanLapse = std::numeric_limits<double>::quiet_NaN();
    double criterion = std::numeric_limits<double>::quiet_NaN(); ///< median, with its central 95 % interval
    double lowCriterion = std::numeric_limits<double>::quiet_NaN();
    double highCriterion = std::numeric_limits<double>::quiet_NaN();
    double densityAtLowSigma = 0.0;  ///< of log10 σ at the ends of its prior, were that even throughout, as a share of the largest
    double densityAtHighSigma = 0.0;
    std::vector<ThurstonePoint> draws; ///< spread evenly over the posterior, equally likely each; for bands
};

/// Standard deviation of log10 σ under the prior alone.
double priorLog10SigmaSd(Task task, const ThurstonePrior& prior) noexcept;

/// Probability of an answer of that kind (see AnswerCount) at difference D.
double answerProbability(Task task, double difference, int kind, const ThurstonePoint& at) noexcept;

/// By passes over a grid: the whole prior, then where the posterior lies, again as long as it fills little of σ, criterion or lapse. Unknown without answers or for adjustment and magnitude. Sums
/// in a fixed order: deterministic. Time grows with the number of different (difference, kind), not with the counts.
ThurstonePosterior thurstonePosterior(Task task, const std::vector<AnswerCount>& counts, const ThurstonePrior& prior, int draws = 400);

} // namespace chiron::psychophysics
