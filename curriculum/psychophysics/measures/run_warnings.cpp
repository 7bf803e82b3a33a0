// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/run_warnings.h"

#include "psychophysics/measures/exact_tests.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

namespace {

constexpr double kAtEdge = 0.147; ///< density at the end of the prior against the largest: within the 95 % likelihood region
constexpr double kTouchesEdge = 0.02;
constexpr double kManyLapses = 0.1;

void warnOfSize(std::vector<std::string>& warnings, const ScoredAnswers& answers) {
    if (answers.leftOut > 0)
        warnings.push_back("left_out: " + std::to_string(answers.leftOut) + " trials have no usable difference or answer and were left out");
    if (answers.used == 0)
        warnings.emplace_back("no_trials: there is no scored trial, so there is nothing to estimate");
    else if (answers.used < kFewTrials)
        warnings.push_back("few_trials: only " + std::to_string(answers.used) + " trials; the interval is wide and leans on the prior");
    if (answers.used > 0 && answers.levels == 0)
        warnings.emplace_back("no_difference: the objects never differed, so nothing can be told about differences");
    else if (answers.levels == 1)
        warnings.emplace_back("one_level: only one difference was presented; lapses cannot be told from a high threshold");
    if (answers.binned)
        warnings.emplace_back("binned: very many different differences were presented; neighbouring ones were put together");
}

void warnOfLevel(std::vector<std::string>& warnings, Task task, const ScoredAnswers& answers) {
    if (task == Task::yesNo || task == Task::sameDifferent) {
        const bool oneAnswer = std::all_of(answers.points.begin(), answers.points.end(), [](const CurvePoint& p) { return p.right == 0; }) ||
                               std::all_of(answers.points.begin(), answers.points.end(), [](const CurvePoint& p) { return p.right == p.of; });
        if (oneAnswer)
            warnings.emplace_back("one_answer: the same answer was given every time; the data say nothing about sensitivity");
        return;
    }
    if (answers.right == answers.used) {
        warnings.emplace_back("all_right: every answer was right; the threshold is below the smallest difference, how far is not known");
        return;
    }
    const double chance = task == Task::rank3 ? 1.0 / 6.0 : 1.0 / psychophysics::answers(task);
    if (binomialUpperTail(answers.right, answers.used, chance) > 0.05)
        warnings.emplace_back("chance: no better than guessing; the threshold may be above the largest difference presented");
}

/// From never better than chance to always right with nothing between.
bool isStep(const ScoredAnswers& answers, double chance) {
    std::size_t wrong = 0;
    while (wrong < answers.points.size() && answers.points[wrong].right <= chance * answers.points[wrong].of)
        ++wrong;
    if (wrong == 0 || wrong == answers.points.size())
        return false;
    return std::all_of(answers.points.begin() + static_cast<std::ptrdiff_t>(wrong), answers.points.end(),
                       [](const CurvePoint& point) { return point.right == point.of; });
}

void warnOfPosterior(std::vector<std::string>& warnings, const ThurstonePosterior& posterior) {
    const double atEdge = std::max(posterior.densityAtLowSigma, posterior.densityAtHighSigma);
    const char* end = posterior.densityAtLowSigma > posterior.densityAtHighSigma ? "lower" : "upper";
    if (atEdge >= kAtEdge)
        warnings.push_back(std::string("prior_edge: the data say nothing at the ") + end + " end: the estimate is where the prior put it");
    else if (atEdge >= kTouchesEdge)
        warnings.push_back(std::string("prior_bound: the ") + end + " end of the interval is set by the prior, not by the data");
    if (posterior.meanLapse > kManyLapses)
        warnings.emplace_back("lapses: more than a tenth of the answers look like guesses even where the difference was easy");
}

} // namespace

void warnOfAnswers(std::vector<std::string>& warnings, Task task, const ScoredAnswers& answers, const ThurstonePosterior& posterior) {
    warnOfSize(warnings, answers);
    if (answers.used == 0)
        return;
    warnOfLevel(warnings, task, answers);
    if (isStep(answers, task == Task::yesNo || task == Task::sameDifferent ? 0.0 : 1.0 / psychophysics::answers(task)))
        warnings.emplace_back("step_function: answers jump from guessing to always right between two neighbouring differences; the slope is "
                              "not known");
    if (posterior.known)
        warnOfPosterior(warnings, posterior);
}

void warnOfPlaces(std::vector<std::string>& warnings, Task task, const std::vector<ScoredTrial>& trials) {
    if (task != Task::twoAfc && task != Task::threeAfc && task != Task::oddity)
        return;
    const int places = placesOf(task);
    std::vector<double> said(static_cast<std::size_t>(places), 0.0);
    std::vector<double> expected = said;
    for (const ScoredTrial& trial : trials) {
        if (trial.arrangement < 0 || trial.arrangement >= static_cast<int>(arrangements(task).size()) || trial.answer < 0 ||
            trial.answer >= places)
            continue;
        const int correct = correctAnswer(task, trial.arrangement);
        if (trial.answer == correct)
            continue;
        said[static_cast<std::size_t>(trial.answer)] += 1.0;
        for (int place = 0; place < places; ++place)
            expected[static_cast<std::size_t>(place)] += place == correct ? 0.0 : 1.0 / (places - 1);
    }
    double sum = 0.0;
    double wrong = 0.0;
    for (std::size_t place = 0; place < said.size(); ++place) {
        wrong += said[place];
        if (expected[place] > 0.0)
            sum += (said[place] - expected[place]) * (said[place] - expected[place]) / expected[place];
    }
    if (wrong >= 10.0 && chiSquareUpperTail(sum, places - 1) < 0.001)
        warnings.emplace_back("position_bias: wrong answers fall on one place much more often than chance allows");
}

} // namespace chiron::psychophysics
