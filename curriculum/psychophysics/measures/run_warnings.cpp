// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/run_warnings.h"

#include "psychophysics/measures/exact_tests.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

namespace {

/// Relative density at the end of the prior above which it lies within the 95 % likelihood region.
constexpr double kAtEdge = 0.147;
constexpr double kTouchesEdge = 0.02;
constexpr double kManyLapses = 0.1;

void warnOfSize(std::vector<Warning>& warnings, const ScoredAnswers& answers) {
    if (answers.leftOut > 0)
        warnings.push_back({WarningKind::leftOutTrials, answers.leftOut});
    if (answers.used == 0)
        warnings.push_back({WarningKind::noTrials});
    else if (answers.used < kFewTrials)
        warnings.push_back({WarningKind::fewTrials, answers.used});
    if (answers.used > 0 && answers.levels == 0)
        warnings.push_back({WarningKind::noDifference});
    else if (answers.levels == 1)
        warnings.push_back({WarningKind::oneLevel});
    if (answers.binned)
        warnings.push_back({WarningKind::binned});
}

/// Returns the proportion correct of an observer who perceives no difference; 0 if that depends on a
/// criterion. An observer who never calls objects equal guesses one of six orders; one who does is right less
/// often.
double chanceOf(Task task) {
    if (task == Task::yesNo || task == Task::sameDifferent)
        return 0.0;
    return 1.0 / (ranksThree(task) ? kStrictRankings : psychophysics::answers(task));
}

/// Returns whether the answers jump from never better than chance to always right, with nothing between.
bool isStep(const ScoredAnswers& answers, double chance) {
    std::size_t wrong = 0;
    while (wrong < answers.points.size() && answers.points[wrong].right <= chance * answers.points[wrong].of)
        ++wrong;
    if (wrong == 0 || wrong == answers.points.size())
        return false;
    return std::all_of(answers.points.begin() + static_cast<std::ptrdiff_t>(wrong), answers.points.end(),
                       [](const CurvePoint& point) { return point.right == point.of; });
}

/// What the number of right answers says about guessing.
enum class Level {
    better,   ///< guessing is refuted
    guessing, ///< guessing is not refuted, and a clear advantage over it is
    untold    ///< neither is: there are too few answers
};

/// A clear advantage is a proportion correct half-way between guessing and always right, which is 75 % in
/// 2AFC. Both tests are one-sided and exact, at 5 %.
Level levelOf(const ScoredAnswers& answers, double chance) {
    constexpr double kLevel = 0.05;
    if (binomialUpperTail(answers.right, answers.used, chance) <= kLevel)
        return Level::better;
    const double halfway = 0.5 * (1.0 + chance);
    return binomialLowerTail(answers.right, answers.used, halfway) <= kLevel ? Level::guessing
                                                                             : Level::untold;
}

void warnOfLevel(std::vector<Warning>& warnings, Task task, const ScoredAnswers& answers) {
    if (task == Task::yesNo || task == Task::sameDifferent) {
        const bool oneAnswer = std::all_of(answers.points.begin(), answers.points.end(),
                                           [](const CurvePoint& p) { return p.right == 0; }) ||
                               std::all_of(answers.points.begin(), answers.points.end(),
                                           [](const CurvePoint& p) { return p.right == p.of; });
        if (oneAnswer)
            warnings.push_back({WarningKind::oneAnswer});
        if (isStep(answers, chanceOf(task)))
            warnings.push_back({WarningKind::stepFunction});
        return;
    }
    if (answers.right == answers.used)
        warnings.push_back({WarningKind::allRight});
    switch (levelOf(answers, chanceOf(task))) {
    case Level::guessing:
        warnings.push_back({WarningKind::chance});
        break;
    case Level::untold:
        warnings.push_back({WarningKind::tooFewToTell});
        break;
    case Level::better:
        // Only answers that are better than guessing can become so at some difference.
        if (isStep(answers, chanceOf(task)))
            warnings.push_back({WarningKind::stepFunction});
        break;
    }
}

void warnOfEnd(std::vector<Warning>& warnings, double density, WarningKind edge, WarningKind bound) {
    if (density >= kAtEdge)
        warnings.push_back({edge});
    else if (density >= kTouchesEdge)
        warnings.push_back({bound});
}

void warnOfPosterior(std::vector<Warning>& warnings, const ThurstonePosterior& posterior) {
    using enum WarningKind;
    warnOfEnd(warnings, posterior.densityAtLowSigma, priorEdgeLow, priorBoundLow);
    warnOfEnd(warnings, posterior.densityAtHighSigma, priorEdgeHigh, priorBoundHigh);
    if (posterior.meanLapse > kManyLapses)
        warnings.push_back({WarningKind::lapses});
}

} // namespace

void warnOfAnswers(std::vector<Warning>& warnings, Task task, const ScoredAnswers& answers,
                   const ThurstonePosterior& posterior) {
    warnOfSize(warnings, answers);
    if (answers.used == 0 || answers.levels == 0) // nothing more is said of nothing
        return;
    warnOfLevel(warnings, task, answers);
    if (posterior.known)
        warnOfPosterior(warnings, posterior);
}

void warnOfPlaces(std::vector<Warning>& warnings, Task task, const std::vector<ScoredTrial>& trials) {
    if (task != Task::twoAfc && task != Task::threeAfc && task != Task::oddity)
        return;
    const int places = placesOf(task);
    std::vector<double> said(static_cast<std::size_t>(places), 0.0);
    std::vector<double> expected = said, offered = said;
    double wrong = 0.0, shown = 0.0;
    for (const ScoredTrial& trial : trials) {
        if (trial.arrangement < 0 || trial.arrangement >= static_cast<int>(arrangements(task).size()) ||
            trial.answer < 0 || trial.answer >= places)
            continue;
        const int correct = correctAnswer(task, trial.arrangement);
        shown += 1.0;
        for (int place = 0; place < places; ++place)
            offered[static_cast<std::size_t>(place)] += place == correct ? 0.0 : 1.0;
        if (trial.answer == correct)
            continue;
        wrong += 1.0;
        said[static_cast<std::size_t>(trial.answer)] += 1.0;
        for (int place = 0; place < places; ++place)
            expected[static_cast<std::size_t>(place)] += place == correct ? 0.0 : 1.0 / (places - 1);
    }
    // With two positions a wrong answer leaves no choice. There the expected numbers follow from how often
    // each position was the wrong one.
    if (places == 2 && shown > 0.0)
        expected = {wrong * offered[0] / shown, wrong * offered[1] / shown};
    double sum = 0.0;
    for (std::size_t place = 0; place < said.size(); ++place)
        if (expected[place] > 0.0)
            sum += (said[place] - expected[place]) * (said[place] - expected[place]) / expected[place];
    if (wrong >= 10.0 && chiSquareUpperTail(sum, places - 1) < 0.001)
        warnings.push_back({WarningKind::positionBias});
}

} // namespace chiron::psychophysics
