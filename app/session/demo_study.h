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

/// One simulated participant of the demonstration's study, as it came out.
struct DemoStudyRun {
    std::string participant; ///< code
    std::string observer;    ///< what it is made of
    database::SessionId session = 0; ///< its recording; 0: not rendered, the observer was told the values
    psychophysics::RunEstimate estimate;
    bool choicesSame = false; ///< the log chooses the same stimuli again
};

/// The studies of a demonstration site.
struct DemoStudy {
    database::StudyNumber study = 0; ///< frozen, with data
    database::StudyNumber draft = 0;
    std::string key;       ///< of `study`
    std::string condition; ///< its only one
    std::vector<DemoStudyRun> runs;
    psychophysics::GroupEstimate group;
    bool replayIdentical = false; ///< forces of the rendered sitting, simulated again
};

/// Participants of the demonstration's study: so many steps does making it take.
int demoStudyParticipants();

/// The content's ranking of stiffness, frozen, done by simulated participants with Weber fractions of their own: all but the last without
/// rendering (their estimates carry not_rendered), the last through the scene, recorded and replayed. Beside it a draft of the surgeons'
/// study. Nobody consents: nobody takes part. `author`: a researcher. `progress` hears in words of each participant before it begins, on the
/// calling thread. Deterministic by seed. Failure: cancelled; the content's; the repository's; a run that is not complete.
core::Result<DemoStudy> makeDemoStudy(database::Database& database, const database::Actor& author, std::uint64_t seed,
                                      const std::function<void(const std::string& doing)>& progress,
                                      const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::session
