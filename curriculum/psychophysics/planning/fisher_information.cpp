// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/planning/fisher_information.h"

#include "core/normal_distribution.h"
#include "psychophysics/measures/discrimination.h"
#include "psychophysics/observers/thurstone.h"
#include "psychophysics/observers/tied_orders.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace chiron::psychophysics {

namespace {

/// Returns the probabilities of the outcomes, without lapses.
std::vector<double> outcomesAt(Task task, double d, bool allCorrectOnly, double tie) {
    const auto two = [](double p) { return std::vector<double>{p, 1.0 - p}; };
    switch (task) {
    case Task::rank3: {
        const auto p = rankProbabilities(d);
        return allCorrectOnly ? two(p[0]) : std::vector<double>(p.begin(), p.end());
    }
    case Task::rank3Ties: {
        const auto p = tiedRankProbabilities(d, tie);
        return allCorrectOnly ? two(p[0]) : std::vector<double>(p.begin(), p.end());
    }
    case Task::twoAfc:
        return two(proportionCorrect({Discrimination::mAfc, 2}, d));
    case Task::threeAfc:
        return two(proportionCorrect({Discrimination::mAfc, 3}, d));
    case Task::oddity:
        return two(proportionCorrect({Discrimination::oddityDifferencing, 3}, d));
    case Task::sameDifferent: {
        const double half = d / std::numbers::sqrt2;
        return two(core::normalCumulative(half - 1.0) + core::normalCumulative(-half - 1.0));
    }
    case Task::yesNo:
        return two(core::normalCumulative(d / std::numbers::sqrt2));
    case Task::adjustment:
    case Task::magnitude:
        break;
    }
    return {};
}

/// Returns the probability of each outcome by guessing.
double guessed(Task task, std::size_t outcome, bool allCorrectOnly) {
    const double right = 1.0 / answers(task);
    return ranksThree(task) && !allCorrectOnly ? right : outcome == 0 ? right : 1.0 - right;
}

} // namespace

double fisherInformation(Task task, double spacing, double lapse, bool allCorrectOnly, double tie) {
    if (task == Task::adjustment)
        return 2.0;
    constexpr double kStep = 1e-3; // of ln σ, and of the tie threshold
    const auto at = [&](double d, double threshold) {
        return outcomesAt(task, d, allCorrectOnly, threshold);
    };
    const std::vector<double> here = at(spacing, tie);
    const std::vector<double> wider = at(spacing * std::exp(-kStep), tie),
                              narrower = at(spacing * std::exp(kStep), tie);
    const bool ties = task == Task::rank3Ties;
    const std::vector<double> more = ties ? at(spacing, tie + kStep) : here,
                              fewer = ties ? at(spacing, std::max(0.0, tie - kStep)) : here;
    const double threshold = tie + kStep - std::max(0.0, tie - kStep);
    double information = 0.0, ofTie = 0.0, shared = 0.0;
    for (std::size_t r = 0; r < here.size(); ++r) {
        const double slope = (1.0 - lapse) * (wider[r] - narrower[r]) / (2.0 * kStep);
        const double slopeOfTie = (1.0 - lapse) * (more[r] - fewer[r]) / threshold;
        const double p = (1.0 - lapse) * here[r] + lapse * guessed(task, r, allCorrectOnly);
        if (!(p > 0.0))
            continue;
        information += slope * slope / p;
        ofTie += slopeOfTie * slopeOfTie / p;
        shared += slope * slopeOfTie / p;
    }
    if (ties && ofTie > 0.0) // the tie threshold has to be estimated from the same answers
        information = std::max(0.0, information - shared * shared / ofTie);
    return task == Task::sameDifferent || task == Task::yesNo ? 0.5 * information : information;
}

BestSpacing bestSpacing(Task task, double lapse, bool allCorrectOnly, double tie) {
    BestSpacing best;
    for (double spacing = 0.2; spacing <= 8.0; spacing += 0.01) {
        const double information = fisherInformation(task, spacing, lapse, allCorrectOnly, tie);
        if (information > best.information)
            best = {spacing, information, 100.0 / information};
    }
    return best;
}

} // namespace chiron::psychophysics
