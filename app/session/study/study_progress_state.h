// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure_spec.h"
#include "session/study/study_progress.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace chiron::session {

/// The state of a run's progress; for study_progress*.cpp only.
struct StudyProgress::State {
    psychophysics::Condition condition;
    psychophysics::TrialRules rules;
    int repeatsAtMost = 5;
    std::uint64_t seed = 0;
    double limit = kNoLimit;
    std::vector<int> allowed; ///< candidates that may be presented
    std::vector<std::unique_ptr<psychophysics::Procedure>> procedures;
    std::vector<int> asked; ///< scored trials of each procedure, including those that the procedure did not
                            ///< receive
    int ordinal = 0;
    int scored = 0;
    int spoiled = 0; ///< repeated trials (database::isRepeated)
    int practised = 0;
    /// Practice trials that ended without an answer (time was up, stopped): they do not count as practice and
    /// are repeated.
    int practiceUnanswered = 0;
    int repeat = 0;         ///< number of times that the current trial was spoiled
    int sameProcedure = -1; ///< after a spoiled trial, its procedure continues
    int breaksTaken = 0;
    bool asksExperimenter = false;
    bool stopped = false;

    bool allDone() const;
    bool practises() const { return practised < rules.practiceTrials; }
    int pickProcedure() const;
    int candidateFor(double x) const;
    /// x of a candidate in the procedures' own scale; not finite if it has none (log of 0).
    double scaled(double difference) const;
    psychophysics::Stimulus stimulusOf(int candidate) const;
    StudyPresentation present() const;
    /// Adopts the log's record that practice is over, because earlier versions also counted practice trials
    /// without an answer.
    void believe(const database::StudyTrial& trial);
    core::Result<void> apply(const database::StudyTrial& trial);
};

} // namespace chiron::session
