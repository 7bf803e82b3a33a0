// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/scored_answers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace chiron::psychophysics {

namespace {

constexpr double kLargestDifference = 12.0; ///< log10 units: no physical difference is larger

struct Sorted {
    double difference = 0.0;
    int kind = 0;
    bool right = false;
};

bool isOneOf(int value, int of) {
    return value >= 0 && value < of;
}

/// Sorts one usable trial; returns false for others.
bool sortOne(Task task, const ScoredTrial& trial, Sorted& sorted) {
    if (!std::isfinite(trial.difference) || std::abs(trial.difference) > kLargestDifference)
        return false;
    const bool placed = isOneOf(trial.arrangement, static_cast<int>(arrangements(task).size()));
    const bool answered = placed && isOneOf(trial.answer, answers(task));
    const int outcome = answered ? outcomeOf(task, trial.arrangement, trial.answer) : trial.outcome;
    if (!isOneOf(outcome, outcomes(task)))
        return false;
    sorted = {trial.difference, outcome, ranksThree(task) ? outcome == 0 : outcome == 1};
    if (task != Task::yesNo && task != Task::sameDifferent)
        return true;
    if (!placed)
        return false;
    const int correct = correctAnswer(task, trial.arrangement);
    sorted.kind = 2 * correct + (sorted.right ? correct : 1 - correct);
    return true;
}

/// Returns the position of an answer on the curve, and whether it counts as right ("yes", "different") there.
std::pair<double, bool> onCurve(Task task, const Sorted& answer) {
    if (task != Task::yesNo && task != Task::sameDifferent)
        return {answer.difference, answer.right};
    return {answer.kind >= 2 ? answer.difference : 0.0, answer.kind % 2 == 1};
}

/// Merges many distinct differences (more than a table of candidates has) into bins with equal numbers of
/// trials.
void putTogether(std::vector<Sorted>& sorted) {
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Sorted& a, const Sorted& b) { return a.difference < b.difference; });
    const std::size_t bin = (sorted.size() + kMostLevels - 1) / kMostLevels;
    for (std::size_t first = 0; first < sorted.size(); first += bin) {
        const std::size_t last = std::min(sorted.size(), first + bin);
        double sum = 0.0;
        for (std::size_t i = first; i < last; ++i)
            sum += sorted[i].difference;
        for (std::size_t i = first; i < last; ++i)
            sorted[i].difference = sum / static_cast<double>(last - first);
    }
}

void count(Task task, const std::vector<Sorted>& sorted, ScoredAnswers& result) {
    std::map<std::pair<double, int>, int> kinds;
    std::map<double, std::pair<int, int>> points;
    std::set<double> levels;
    for (const Sorted& answer : sorted) {
        ++kinds[{answer.difference, answer.kind}];
        const auto [x, right] = onCurve(task, answer);
        points[x].first += right ? 1 : 0;
        ++points[x].second;
        result.right += answer.right ? 1 : 0;
        if (answer.difference != 0.0)
            levels.insert(std::abs(answer.difference));
    }
    for (const auto& [key, n] : kinds)
        result.counts.push_back({key.first, key.second, static_cast<double>(n)});
    for (const auto& [x, n] : points)
        result.points.push_back({x, n.first, n.second});
    result.levels = static_cast<int>(levels.size());
    if (!levels.empty()) {
        result.smallestDifference = *levels.begin();
        result.largestDifference = *levels.rbegin();
    }
}

} // namespace

ScoredAnswers sortAnswers(Task task, const std::vector<ScoredTrial>& trials) {
    ScoredAnswers result;
    if (task == Task::adjustment || task == Task::magnitude)
        return result;
    std::vector<Sorted> sorted;
    std::set<double> differences;
    for (const ScoredTrial& trial : trials) {
        Sorted one;
        if (!sortOne(task, trial, one)) {
            ++result.leftOut;
            continue;
        }
        sorted.push_back(one);
        if (differences.size() <= kMostLevels)
            differences.insert(one.difference);
    }
    result.used = static_cast<int>(sorted.size());
    result.binned = differences.size() > kMostLevels;
    if (result.binned)
        putTogether(sorted);
    count(task, sorted, result);
    return result;
}

} // namespace chiron::psychophysics
