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

/// The progress of making a demonstration.
struct DemoProgress {
    int step = 1; ///< from 1
    int of = 1;
    std::string doing;      ///< description of the step: the level of an exercise and who does it, or a
                            ///< participant of the study
    std::string exercise{}; ///< the exercise of the step; empty: a participant of the study
    int level = 0;
    std::string person{}; ///< full name; empty: a scripted operator under the simulated account
    int attempt = 1;      ///< of this person at this level
    int attempts = 1;
};

/// The contents of a demonstration.
struct DemoSite {
    std::vector<DemoResult> sessions; ///< sessions of exercises
    DemoStudy study;

    /// Every session and the study's rendered one give the same forces again, every session the same scores,
    /// and every run of the study the same choices.
    bool holds() const;
};

/// Accounts of a demonstration site. Their password is documented, and the database is marked
/// *demonstration*.
inline constexpr const char* kDemoPassword = "asclepius-demo";
inline constexpr const char* kDemoResearcher = "rhea"; ///< author of the studies

/// Fills a new database with an administrator, a trainer, a researcher and three trainees. Four operators do
/// every level of every exercise under the simulated account. One trainee has mastered the exercises; two
/// others learn two of the exercises, with repeated attempts by scripted hands of growing skill. Each session
/// is replayed and scored again. The researcher's studies are made by makeDemoStudy. `progress` is called
/// before each step, on the calling thread. Takes about one minute of one core. `cancel` ends it early; the
/// caller must then discard the database.
/// Errors: wrongUse if there are people; cancelled; that of the first failing session.
core::Result<DemoSite> makeDemoSite(database::Database& database, const catalogue::Catalogue& catalogue,
                                    std::uint64_t seed,
                                    const std::function<void(const DemoProgress&)>& progress,
                                    const std::atomic<bool>* cancel = nullptr);

/// Runs makeDemoSite in a new file that is opened for writing and marked *demonstration*. Removes the file
/// again on failure or cancellation.
/// Errors: badInput if the file exists (it is left unchanged); storage; those of makeDemoSite.
core::Result<std::unique_ptr<database::Database>>
createDemoSite(const std::string& file, const database::DatabaseOptions& options,
               const catalogue::Catalogue& catalogue, std::uint64_t seed,
               const std::function<void(const DemoProgress&)>& progress,
               const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::session
