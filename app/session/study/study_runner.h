// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/database.h"
#include "psychophysics/observers/observer_spec.h"
#include "session/study/study_limits.h"
#include "session/study/study_progress.h"
#include "simulation/comparison/comparison_parameters.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// A request that a simulated participant does or resumes a study, faster than real time.
struct StudyRunRequest {
    database::StudyNumber study = 0;
    std::string participantCode;
    psychophysics::ObserverSpec observer;
    std::uint64_t seed = 1; ///< of participant and runs; a resumed run keeps its stored seed
    bool seedGiven = false; ///< the seed was given explicitly: a run that began with another one is then
                            ///< refused
    bool quick = false;     ///< no rendering: the observer receives the values directly; trials have no
                            ///< session
    /// Id, or sealed code while blinded; empty: all conditions that are not completed, in the participant's
    /// order.
    std::string condition;
    /// > 0: stops after this number of presentations of a run, like an interruption; another call resumes it.
    int trialsAtMost = 0;
    std::filesystem::path ringFolder; ///< empty: the default
    /// Deliberate faults (psychophysics.md §6).
    simulation::ComparisonControl control = simulation::ComparisonControl::none;
    const std::atomic<bool>* cancel = nullptr;
    std::function<void(int scored, int of)> progress; ///< after each trial; may be empty; any thread
};

struct StudyRunSummary {
    std::string condition; ///< id, or sealed code while blinded
    database::StudyRunNumber run = 0;
    database::SessionId session = 0; ///< the latest session of the run; 0: quick
    int scored = 0;                  ///< of the whole run
    int spoiled = 0;
    bool completed = false;
    std::vector<psychophysics::ProcedureEstimate> estimates;
};

struct StudyRunReport {
    std::vector<StudyRunSummary> runs;
    bool completed = false; ///< every condition of the participant is completed
    /// Of the device at its measured delay; empty for a quick run, which has no device.
    std::optional<RenderingLimits> limits;
};

/// Runs the request through scene, loop, supervisor and simulated device, recorded as sessions of
/// "comparison" under the actor. Trials are stored as soon as they are answered, so a kill or a stop loses at
/// most the current trial, and the next call resumes there. Deterministic: the same study, observer and seed
/// give the same trials.
/// Errors: notFound; notAllowed; wrongUse (not frozen; a person's code; another observer than the one
///   enrolled; an explicit seed other than the one with which a run began; resuming a quick run with
///   rendering, or the reverse); badInput; storage; device (a session ended by itself and presented nothing
///   more).
core::Result<StudyRunReport> runStudyHeadless(database::Database& database, const database::Actor& actor,
                                              const StudyRunRequest& request);

} // namespace chiron::session
