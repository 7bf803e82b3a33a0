// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_progress_state.h"

#include "core/random.h"
#include "psychophysics/planning/run_simulator.h"
#include "session/study/presentation_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::session {

double StudyProgress::State::scaled(double difference) const {
    return condition.scale == psychophysics::ProcedureScale::difference ? difference : std::log10(difference);
}

bool StudyProgress::State::allDone() const {
    return stopped || std::all_of(procedures.begin(), procedures.end(),
                                  [](const auto& procedure) { return procedure->done(); });
}

/// Picks at random among the unfinished procedures, depending on the presentation's number, so that a resumed
/// run makes the same choice.
int StudyProgress::State::pickProcedure() const {
    if (sameProcedure >= 0 && !procedures[static_cast<std::size_t>(sameProcedure)]->done())
        return sameProcedure;
    std::vector<int> open;
    for (std::size_t i = 0; i < procedures.size(); ++i)
        if (!procedures[i]->done())
            open.push_back(static_cast<int>(i));
    if (open.empty())
        return 0;
    core::Random random = core::Random::stream(seed, "study.interleave " + std::to_string(ordinal));
    return open[static_cast<std::size_t>(random.below(open.size()))];
}

/// The nearest candidate; of two equally near ones, the first.
int StudyProgress::State::candidateFor(double x) const {
    int best = allowed.front();
    double nearest = std::numeric_limits<double>::infinity();
    for (const int candidate : allowed) {
        const double away =
            std::abs(scaled(condition.stimulus.differences[static_cast<std::size_t>(candidate)]) - x);
        if (away < nearest) {
            nearest = away;
            best = candidate;
        }
    }
    return best;
}

psychophysics::Stimulus StudyProgress::State::stimulusOf(int candidate) const {
    return {scaled(condition.stimulus.differences[static_cast<std::size_t>(candidate)])};
}

StudyPresentation StudyProgress::State::present() const {
    StudyPresentation next;
    next.practice = practises();
    next.trial = scored;
    next.ordinal = ordinal;
    next.repeat = repeat;
    next.procedure = next.practice ? 0 : pickProcedure();
    const auto& procedure = *procedures[static_cast<std::size_t>(next.procedure)];
    if (next.practice) {
        next.candidate = allowed.back();
        next.entropyMargin = std::numeric_limits<double>::quiet_NaN();
    } else {
        const psychophysics::Choice choice = procedure.next();
        next.candidate = candidateFor(choice.stimulus.empty() ? 0.0 : choice.stimulus.front());
        next.entropyMargin = choice.entropyMargin;
    }
    next.arrangement = balancedArrangement(
        condition.task, seed,
        {next.procedure, asked[static_cast<std::size_t>(next.procedure)], ordinal, repeat, next.practice});
    next.difference = condition.stimulus.differences[static_cast<std::size_t>(next.candidate)];
    for (const int multiple :
         psychophysics::arrangements(condition.task)[static_cast<std::size_t>(next.arrangement)])
        next.values.push_back(condition.stimulus.reference * std::pow(10.0, multiple * next.difference));
    next.ofAtMost = trialsAtMost(condition);
    return next;
}

void StudyProgress::State::believe(const database::StudyTrial& trial) {
    if (trial.practice || practised >= rules.practiceTrials ||
        practised + practiceUnanswered < rules.practiceTrials)
        return;
    practised = rules.practiceTrials;
    repeat = 0;
}

/// Processes a trial as it was logged, in the same way live, on resuming and on re-running.
core::Result<void> StudyProgress::State::apply(const database::StudyTrial& trial) {
    if (trial.candidate < 0 ||
        static_cast<std::size_t>(trial.candidate) >= condition.stimulus.differences.size() ||
        trial.procedure < 0 || static_cast<std::size_t>(trial.procedure) >= procedures.size())
        return core::fail(core::ErrorCode::badInput, "trial " + std::to_string(trial.ordinal) +
                                                         ": candidate or procedure is not of this condition");
    auto& procedure = *procedures[static_cast<std::size_t>(trial.procedure)];
    believe(trial);
    if (trial.practice && trial.answer < 0) {
        ++practiceUnanswered;
        ++repeat;
        // A participant who takes an answer back to reconsider it causes no concern.
        asksExperimenter = repeat >= repeatsAtMost && trial.spoiled != "taken_back";
    } else if (trial.practice) {
        ++practised;
        repeat = 0;
    } else if (!trial.spoiled.empty()) {
        procedure.spoiled();
        spoiled += database::isRepeated(trial) ? 1 : 0;
        ++repeat;
        sameProcedure = trial.procedure;
        asksExperimenter = repeat >= repeatsAtMost;
    } else {
        // If the arrangement showed no difference, the answer contains no information about the requested
        // difference: the trial is kept, and the procedure asks again.
        const int told = psychophysics::scoredOutcome(condition.task, trial.outcome, procedure.outcomes());
        if (psychophysics::showsDifference(condition.task, trial.arrangement))
            CHIRON_TRY(procedure.record(told, stimulusOf(trial.candidate)));
        ++scored;
        ++asked[static_cast<std::size_t>(trial.procedure)];
        repeat = 0;
        sameProcedure = -1;
    }
    ordinal = trial.ordinal + 1;
    return {};
}

core::Result<ReplayedChoices> rerunChoices(const psychophysics::StudyDesign& design,
                                           const database::StudyRun& run,
                                           const std::vector<database::StudyTrial>& trials) {
    constexpr double kTie = 1e-9; // nats (psychophysics.md §6)
    auto progress =
        StudyProgress::begin(design, run.condition, run.seed, StudyProgress::limitOf(run.procedures));
    CHIRON_TRY(progress);
    ReplayedChoices replayed;
    replayed.sameProcedures = progress->procedureIds() == run.procedures;
    for (const database::StudyTrial& trial : trials) {
        if (progress->needsExperimenter())
            progress->experimenterSays(true);
        progress->m_state->believe(trial);
        const StudyPresentation shown = progress->next();
        ++replayed.trials;
        const bool sameOtherwise = shown.arrangement == trial.arrangement &&
                                   shown.procedure == trial.procedure && shown.practice == trial.practice;
        if (sameOtherwise && shown.candidate == trial.candidate)
            ++replayed.same;
        // Only the candidate is chosen by entropy.
        else if (sameOtherwise && trial.entropyMargin < kTie)
            ++replayed.ties;
        else if (replayed.firstDifference < 0)
            replayed.firstDifference = trial.ordinal;
        CHIRON_TRY(progress->m_state->apply(trial));
    }
    return replayed;
}

} // namespace chiron::session
