// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure_spec.h"
#include "session/study/study_progress.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace chiron::session {

/// What a run's progress holds: for study_progress*.cpp alone.
struct StudyProgress::State {
    psychophysics::Condition condition;
    psychophysics::TrialRules rules;
    int repeatsAtMost = 5;
    std::uint64_t seed = 0;
    double limit = kNoLimit;
    std::vector<int> allowed; ///< candidates that may be presented
    std::vector<std::unique_ptr<psychophysics::Procedure>> procedures;
    std::vector<int> asked; ///< scored trials of each procedure, also those that it was not told of
    int ordinal = 0;
    int scored = 0;
    int spoiled = 0;
    int practised = 0;
    int practiceUnanswered = 0; ///< practice that ended without an answer (time was up, stopped): no practice, it comes again
    int repeat = 0;        ///< how often the present trial was spoiled
    int sameProcedure = -1; ///< after a spoiled trial its procedure goes on
    int breaksTaken = 0;
    bool asksExperimenter = false;
    bool stopped = false;

    bool allDone() const;
    int pickProcedure() const;
    int candidateFor(double x) const;
    double scaled(double difference) const; ///< x of a candidate in the procedures' own scale; not finite where it has none (log of 0)
    psychophysics::Stimulus stimulusOf(int candidate) const;
    StudyPresentation present() const;
    /// Takes the log's word that practice is over. Earlier versions counted practice without an answer, too.
    void believe(const database::StudyTrial& trial);
    core::Result<void> apply(const database::StudyTrial& trial);
};

} // namespace chiron::session
