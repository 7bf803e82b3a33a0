// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/demo_study.h"
#include "session/site.h"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace chiron::session {

/// One line of the demonstration's table of results.
struct DemoResult {
    std::string person;
    ScriptedSession asked;
    TrainingResult result;
    bool replayIdentical = false;
    bool scoreSame = false;
};

/// How far the making of a demonstration is.
struct DemoProgress {
    int step = 1; ///< from 1
    int of = 1;
    std::string doing; ///< what the step is: an exercise's level and who does it, a study's participant
    std::string exercise{}; ///< the same in parts; empty: the study's
    int level = 0;
    std::string person{}; ///< full name; empty: an operator as the simulated account
    int attempt = 1;      ///< of this person at this level
    int attempts = 1;
};

/// What a demonstration holds.
struct DemoSite {
    std::vector<DemoResult> sessions; ///< of exercises
    DemoStudy study;
};

/// The people of a demonstration site; their password is documented, and the database marked *demonstration*.
inline constexpr const char* kDemoPassword = "asclepius-demo";
inline constexpr const char* kDemoResearcher = "rhea"; ///< whose the studies are

/// Fills a fresh database: an administrator, a trainer, a researcher, three trainees; four operators on every level of
/// every exercise as the simulated account, and attempts of each trainee: one of them can do it, two learn two of the exercises, one attempt after the
/// other with scripted hands of growing skill; each session replayed and scored again; the researcher's studies (makeDemoStudy). `progress` hears of each step before it runs, on the calling thread. Takes about a minute of one core; `cancel` ends
/// it early (the database is then to be thrown away). Failure: wrongUse if there are people; cancelled; the first failing
/// session's.
core::Result<DemoSite> makeDemoSite(database::Database& database, const catalogue::Catalogue& catalogue,
                                    std::uint64_t seed, const std::function<void(const DemoProgress&)>& progress,
                                    const std::atomic<bool>* cancel = nullptr);

/// makeDemoSite in a new file, opened for writing and marked *demonstration*. What was made goes again when it fails or is
/// cancelled. Failure: badInput if the file exists (it is left as it is), storage, as makeDemoSite.
core::Result<std::unique_ptr<database::Database>> createDemoSite(const std::string& file, const database::DatabaseOptions& options,
                                                                 const catalogue::Catalogue& catalogue, std::uint64_t seed,
                                                                 const std::function<void(const DemoProgress&)>& progress,
                                                                 const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::session
