// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/planning/run_simulator.h"

#include "core/random.h"
#include "psychophysics/observers/simulated_observer.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

constexpr std::size_t kMostTrials = 10'000;

/// Runs one trial at a candidate: draws the arrangement and asks the observer.
ScoredTrial present(const Condition& condition, int candidate, SimulatedObserver& observer,
                    core::Random& random) {
    const std::vector<double>& differences = condition.stimulus.differences;
    ScoredTrial trial;
    trial.difference = differences[static_cast<std::size_t>(candidate)];
    trial.arrangement = static_cast<int>(random.below(arrangements(condition.task).size()));
    std::vector<double> places;
    for (const int multiple : arrangements(condition.task)[static_cast<std::size_t>(trial.arrangement)])
        places.push_back(multiple * trial.difference);
    if (condition.task == Task::adjustment)
        trial.value =
            condition.stimulus.reference * std::pow(10.0, observer.adjust(std::min(differences.front(), -1.0),
                                                                          std::max(differences.back(), 1.0)));
    else if (condition.task == Task::magnitude)
        trial.value = observer.magnitude(trial.difference);
    trial.answer = observer.answer(condition.task, places);
    trial.outcome = trial.value ? 1 : outcomeOf(condition.task, trial.arrangement, trial.answer);
    return trial;
}

} // namespace

int scoredOutcome(Task task, int outcome, int outcomesOfProcedure) noexcept {
    return ranksThree(task) && outcomesOfProcedure == 2 ? (outcome == 0 ? 1 : 0) : outcome;
}

double differenceOf(ProcedureScale scale, double x) noexcept {
    return scale == ProcedureScale::logDifference ? std::pow(10.0, x) : x;
}

double scaledDifference(ProcedureScale scale, double difference) noexcept {
    if (scale == ProcedureScale::difference)
        return difference;
    return difference > 0.0 ? std::max(std::log10(difference), -20.0) : -20.0;
}

int nearestCandidate(const std::vector<double>& candidates, double difference) noexcept {
    const auto nearest =
        std::min_element(candidates.begin(), candidates.end(), [difference](double a, double b) {
            return std::abs(a - difference) < std::abs(b - difference);
        });
    return nearest == candidates.end() ? -1 : static_cast<int>(nearest - candidates.begin());
}

bool showsDifference(Task task, int arrangement) noexcept {
    return (task != Task::sameDifferent && task != Task::yesNo) || correctAnswer(task, arrangement) == 1;
}

core::Result<RunSimulator> RunSimulator::make(const Condition& condition) {
    if (condition.procedures.empty())
        return fail(ErrorCode::badInput, "condition " + condition.id + ": procedures: expected at least one");
    if (condition.stimulus.differences.empty())
        return fail(ErrorCode::badInput,
                    "condition " + condition.id + ": differences: expected at least one");
    RunSimulator simulator;
    simulator.m_condition = condition;
    for (const ProcedureSpec& spec : condition.procedures) {
        auto factory = procedureFactory(spec);
        CHIRON_TRY(factory);
        simulator.m_factories.push_back(std::move(*factory));
    }
    return simulator;
}

std::vector<ScoredTrial> RunSimulator::run(const ObserverSpec& spec, std::uint64_t seed) const {
    std::vector<std::unique_ptr<Procedure>> procedures;
    for (std::size_t i = 0; i < m_factories.size(); ++i)
        procedures.push_back(m_factories[i](core::Random::mix(seed, "procedure." + std::to_string(i))));
    SimulatedObserver observer(spec, core::Random::mix(seed, "observer"));
    core::Random random = core::Random::stream(seed, "run");
    std::vector<ScoredTrial> trials;
    while (trials.size() < kMostTrials) {
        std::vector<int> running;
        for (std::size_t i = 0; i < procedures.size(); ++i)
            if (!procedures[i]->done())
                running.push_back(static_cast<int>(i));
        if (running.empty())
            break;
        const int chosen = running[random.below(running.size())];
        Procedure& procedure = *procedures[static_cast<std::size_t>(chosen)];
        const double wanted = differenceOf(m_condition.scale, procedure.next().stimulus[0]);
        ScoredTrial trial = present(m_condition, nearestCandidate(m_condition.stimulus.differences, wanted),
                                    observer, random);
        trial.procedure = chosen;
        trials.push_back(trial);
        if (showsDifference(m_condition.task, trial.arrangement) &&
            !procedure.record(scoredOutcome(m_condition.task, trial.outcome, procedure.outcomes()),
                              {scaledDifference(m_condition.scale, trial.difference)}))
            break; // the answer is impossible for every observer of the procedure's grid
    }
    return trials;
}

} // namespace chiron::psychophysics
