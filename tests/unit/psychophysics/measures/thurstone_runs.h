// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "psychophysics/planning/run_simulator.h"
#include "psychophysics/study/run_estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

// Thurstone observers of known σ, for tests of what is estimated from their answers: independent of
// observers/, so that a mistake in one shows in the other.
namespace thurstone_runs {

using namespace chiron::psychophysics;

inline Condition conditionOf(Task task) {
    Condition condition;
    condition.id = "test";
    condition.task = task;
    condition.stimulus.reference = 200.0;
    for (int i = 0; i < 8; ++i)
        condition.stimulus.differences.push_back(0.02 * std::pow(1.4, i));
    return condition;
}

/// The place farthest from the other two: where the two closest are not.
inline int farthest(const std::vector<double>& felt) {
    std::vector<std::size_t> order(3);
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return felt[a] < felt[b]; });
    return static_cast<int>(felt[order[1]] - felt[order[0]] < felt[order[2]] - felt[order[1]] ? order[2]
                                                                                              : order[0]);
}

/// The order in which the places were felt, as the answers of rank3 count it.
inline int orderSaid(const std::vector<double>& felt) {
    Places said(3);
    for (std::size_t place = 0; place < 3; ++place)
        said[place] = static_cast<int>(
            std::count_if(felt.begin(), felt.end(), [&](double other) { return other < felt[place]; }));
    const auto& orders = arrangements(Task::rank3);
    return static_cast<int>(std::find(orders.begin(), orders.end(), said) - orders.begin());
}

/// The same with ties, as the answers of rank3_ties count it: who is next to whom, less than half an sd
/// apart, is equal.
inline int tiesSaid(const std::vector<double>& felt, double sigma) {
    std::vector<double> sorted = felt;
    std::sort(sorted.begin(), sorted.end());
    Ranking said{};
    for (std::size_t place = 0; place < 3; ++place)
        for (std::size_t i = 1; i < 3; ++i)
            said[place] = static_cast<std::int8_t>(
                said[place] + (felt[place] >= sorted[i] && sorted[i] - sorted[i - 1] >= 0.5 * sigma ? 1 : 0));
    return rankingOf(said);
}

inline int answerOf(Task task, const std::vector<double>& felt, double sigma, double criterion) {
    switch (task) {
    case Task::rank3:
        return orderSaid(felt);
    case Task::rank3Ties:
        return tiesSaid(felt, sigma);
    case Task::twoAfc:
    case Task::threeAfc:
        return static_cast<int>(std::max_element(felt.begin(), felt.end()) - felt.begin());
    case Task::oddity:
        return farthest(felt);
    case Task::sameDifferent:
        return std::abs(felt[0] - felt[1]) > 2.0 * sigma ? 1 : 0;
    case Task::yesNo:
        return felt[0] > criterion ? 1 : 0;
    case Task::adjustment:
    case Task::magnitude:
        break;
    }
    return 0;
}

inline ScoredTrial simulated(Task task, double difference, double sigma, double lapse,
                             chiron::core::Random& random, double criterion = 0.03) {
    ScoredTrial trial;
    trial.difference = difference;
    trial.arrangement = static_cast<int>(random.below(arrangements(task).size()));
    std::vector<double> felt;
    for (const int multiple : arrangements(task)[static_cast<std::size_t>(trial.arrangement)])
        felt.push_back(multiple * difference + sigma * random.normal());
    if (task == Task::yesNo)
        felt[0] -= sigma * random.normal(); // the remembered reference
    trial.answer = answerOf(task, felt, sigma, criterion);
    if (random.uniform() < lapse)
        trial.answer = static_cast<int>(random.below(static_cast<std::uint64_t>(answers(task))));
    trial.outcome = outcomeOf(task, trial.arrangement, trial.answer);
    return trial;
}

inline std::vector<ScoredTrial> runOf(const Condition& condition, int trials, double sigma, double lapse,
                                      chiron::core::Random& random) {
    std::vector<ScoredTrial> run;
    for (int i = 0; i < trials; ++i)
        run.push_back(simulated(condition.task,
                                condition.stimulus.differences[static_cast<std::size_t>(i) %
                                                               condition.stimulus.differences.size()],
                                sigma, lapse, random));
    return run;
}

struct Coverage {
    double covered = 0.0; ///< share of runs whose 95 % interval holds σ
    double bias = 0.0;    ///< mean of log10(estimate/σ)
    double sd = 0.0;
};

inline Coverage coverageOf(Task task, int trials, double sigma, double lapse, int runs) {
    const Condition condition = conditionOf(task);
    double sum = 0.0;
    double squares = 0.0;
    int covered = 0;
    for (int seed = 1; seed <= runs; ++seed) {
        auto random = chiron::core::Random::stream(static_cast<std::uint64_t>(seed), "thurstone run");
        const RunEstimate estimate =
            estimateRun(condition, runOf(condition, trials, sigma, lapse, random), 1);
        const double error = std::log10(estimate.sigma_log10 / sigma);
        covered += estimate.sigma95.low <= sigma && sigma <= estimate.sigma95.high ? 1 : 0;
        sum += error;
        squares += error * error;
    }
    const double mean = sum / runs;
    return {static_cast<double>(covered) / runs, mean, std::sqrt(squares / runs - mean * mean)};
}

/// Runs placed by rank-3 QUEST+ and answered by observers/simulated_observer: 2 % lapses, σ from 0.02 to
/// 0.12.
inline Coverage adaptiveCoverage(int runs, int trials) {
    Condition condition = conditionOf(Task::rank3);
    condition.stimulus.differences.clear();
    Rank3Spec spec;
    for (int i = 0; i < 40; ++i)
        condition.stimulus.differences.push_back(0.01 * std::pow(10.0, i * 0.04));
    spec.differences = condition.stimulus.differences;
    for (int i = 0; i <= 40; ++i)
        spec.log10Sigma.push_back(-2.4 + 0.05 * i);
    spec.stop = {.trials = trials};
    condition.procedures = {spec};
    const auto simulator = RunSimulator::make(condition);
    double sum = 0.0;
    double squares = 0.0;
    int covered = 0;
    for (int seed = 1; simulator && seed <= runs; ++seed) {
        const double sigma = 0.02 * std::pow(6.0, seed % 10 / 9.0);
        const auto answered =
            simulator->run({.weber = std::pow(10.0, 0.9538725524 * sigma) - 1.0, .lapse = 0.02},
                           static_cast<std::uint64_t>(seed));
        const RunEstimate estimate = estimateRun(condition, answered, 1);
        const double error = std::log10(estimate.sigma_log10 / sigma);
        covered += estimate.sigma95.low <= sigma && sigma <= estimate.sigma95.high ? 1 : 0;
        sum += error;
        squares += error * error;
    }
    const double mean = sum / runs;
    return {static_cast<double>(covered) / runs, mean, std::sqrt(squares / runs - mean * mean)};
}

} // namespace thurstone_runs
