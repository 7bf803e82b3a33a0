// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/database.h"
#include "psychophysics/observers/observer_spec.h"
#include "session/study/study_limits.h"
#include "session/study/study_progress.h"
#include "modules/exercises/comparison/simulation/comparison_parameters.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// A simulated participant does a study, or goes on with it, as fast as the machine can.
struct StudyRunRequest {
    database::StudyNumber study = 0;
    std::string participantCode;
    psychophysics::ObserverSpec observer;
    std::uint64_t seed = 1;   ///< of participant and runs; the stored seed of a run that is resumed holds
    bool seedGiven = false;   ///< asked for by name: a run that was begun with another one is then refused
    bool quick = false;       ///< no rendering: the observer is told the values; trials have no session
    std::string condition;    ///< id, or sealed code while blinded; empty: all that are not completed, in the participant's order
    int trialsAtMost = 0;     ///< > 0: stops after so many presentations of a run, as an interruption does (it is resumed by another call)
    std::filesystem::path ringFolder; ///< empty: the default
    simulation::ComparisonControl control = simulation::ComparisonControl::none; ///< deliberate faults (psychophysics.md §6)
    const std::atomic<bool>* cancel = nullptr;
    std::function<void(int scored, int of)> progress; ///< after each trial; may be empty; any thread
};

struct StudyRunSummary {
    std::string condition; ///< id, or sealed code while blinded
    database::StudyRunNumber run = 0;
    database::SessionId session = 0; ///< of this sitting; 0: quick
    int scored = 0;     ///< of the whole run
    int spoiled = 0;
    bool completed = false;
    std::vector<psychophysics::ProcedureEstimate> estimates;
};

struct StudyRunReport {
    std::vector<StudyRunSummary> runs;
    bool completed = false; ///< every condition of the participant is
    std::optional<RenderingLimits> limits; ///< of the device, at its measured delay; nothing: a quick run has none
};

/// Through scene, loop, supervisor and simulated device, recorded as sessions of "comparison" under the actor; trials are stored as they are
/// answered, so a kill or a stop loses the trial at hand at most, and the next call resumes there. Deterministic: same study, observer
/// and seed, same trials. Failure: notFound, notAllowed, wrongUse (not frozen; a person's code;
/// another observer than the one enrolled, another seed, where one is given, than a run was begun with; a quick run that is to go on rendered, or the other way round), badInput, storage.
core::Result<StudyRunReport> runStudyHeadless(database::Database& database, const database::Actor& actor, const StudyRunRequest& request);

} // namespace chiron::session
