// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/run_warnings.h"

#include "psychophysics/measures/exact_tests.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

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

/// The points by size, smallest first: forced choices have the same answers to differences of either sign.
std::vector<CurvePoint> bySize(const std::vector<CurvePoint>& points) {
    std::map<double, CurvePoint> sizes;
    for (const CurvePoint& point : points) {
        CurvePoint& size = sizes[std::abs(point.difference)];
        size.difference = std::abs(point.difference);
        size.right += point.right;
        size.of += point.of;
    }
    std::vector<CurvePoint> result;
    for (const auto& [difference, size] : sizes)
        result.push_back(size);
    return result;
}

/// Returns whether the answers jump from never better than chance to always right, with nothing between.
bool isStep(const std::vector<CurvePoint>& points, double chance) {
    std::size_t wrong = 0;
    while (wrong < points.size() && points[wrong].right <= chance * points[wrong].of)
        ++wrong;
    if (wrong == 0 || wrong == points.size())
        return false;
    return std::all_of(points.begin() + static_cast<std::ptrdiff_t>(wrong), points.end(),
                       [](const CurvePoint& point) { return point.right == point.of; });
}

/// Returns whether the answers at the largest differences are better than guessing, whatever was answered at
/// smaller ones: exact and one-sided, for the best of all ends of the scale, corrected for their number
/// (Bonferroni). `sizes`: ascending.
bool isBetterAtTheTop(const std::vector<CurvePoint>& sizes, double chance, double level) {
    int right = 0, of = 0;
    return std::any_of(sizes.rbegin(), sizes.rend(), [&](const CurvePoint& size) {
        right += size.right;
        of += size.of;
        return binomialUpperTail(right, of, chance) * static_cast<double>(sizes.size()) <= level;
    });
}

/// What the number of right answers says about guessing.
enum class Level {
    better,   ///< guessing is refuted
    guessing, ///< guessing is not refuted, and a clear advantage over it is
    untold    ///< neither is: there are too few answers
};

/// Guessing is refuted by all answers together or by those at the largest differences: whoever perceives only
/// these guesses in all other trials. A clear advantage is a proportion correct half-way between guessing and
/// always right, which is 75 % in 2AFC. The tests are one-sided and exact, at 5 %; the one of the
/// largest differences comes in addition, at 1 %.
Level levelOf(const ScoredAnswers& answers, const std::vector<CurvePoint>& sizes, double chance) {
    constexpr double kLevel = 0.05, kLevelAtTheTop = 0.01;
    if (binomialUpperTail(answers.right, answers.used, chance) <= kLevel ||
        isBetterAtTheTop(sizes, chance, kLevelAtTheTop))
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
        if (isStep(answers.points, chanceOf(task)))
            warnings.push_back({WarningKind::stepFunction});
        return;
    }
    if (answers.right == answers.used)
        warnings.push_back({WarningKind::allRight});
    const std::vector<CurvePoint> sizes = bySize(answers.points);
    switch (levelOf(answers, sizes, chanceOf(task))) {
    case Level::guessing:
        warnings.push_back({WarningKind::chance});
        break;
    case Level::untold:
        warnings.push_back({WarningKind::tooFewToTell});
        break;
    case Level::better:
        // Only answers that are better than guessing can become so at some difference.
        if (isStep(sizes, chanceOf(task)))
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
