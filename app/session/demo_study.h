// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/actor.h"
#include "database/database.h"
#include "session/study/study_analysis.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace chiron::session {

/// The results of one simulated participant of the demonstration's study.
struct DemoStudyRun {
    std::string participant;         ///< code
    std::string observer;            ///< parameters of the simulated observer
    database::SessionId session = 0; ///< its recording; 0: not rendered, the observer received the values
                                     ///< directly
    psychophysics::RunEstimate estimate;
    bool choicesSame = false; ///< replaying the log chooses the same stimuli
};

/// The studies of a demonstration site.
struct DemoStudy {
    database::StudyNumber study = 0; ///< frozen, with data
    database::StudyNumber draft = 0;
    std::string key;       ///< key of `study`
    std::string condition; ///< its only condition
    std::vector<DemoStudyRun> runs;
    psychophysics::GroupEstimate group;
    bool replayIdentical = false; ///< the forces of the rendered session agree when simulated again
};

/// Number of participants of the demonstration's study, which is the number of steps that making it takes.
int demoStudyParticipants();

/// Creates the content's ranking study of stiffness, frozen and done by simulated participants who each have
/// their own Weber fraction. All but the last run without rendering (their estimates carry not_rendered); the
/// last one runs through the scene and is recorded and replayed. Also creates a draft of the surgeons' study.
/// There is no consent, because no person takes part. `author` is a researcher. `progress` receives a
/// description of each participant before that participant begins, on the calling thread. Deterministic for a
/// given seed.
/// Errors: cancelled; those of the content; those of the repository; a run that is not complete.
core::Result<DemoStudy> makeDemoStudy(database::Database& database, const database::Actor& author,
                                      std::uint64_t seed,
                                      const std::function<void(const std::string& doing)>& progress,
                                      const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::session
