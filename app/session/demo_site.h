// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
    int session = 1; ///< from 1
    int of = 1;
    const ScriptedSession& asked;
};

/// The people of a demonstration site; their password is documented, and the database marked *demonstration*.
inline constexpr const char* kDemoPassword = "asclepius-demo";

/// Fills a fresh database: an administrator, a trainer, a researcher, three trainees; four operators on every level of
/// every exercise as the simulated account, and a few attempts of each trainee; each session replayed and scored again.
/// `progress` hears of each session before it runs, on the calling thread. Takes about a minute of one core; `cancel` ends
/// it early (the database is then to be thrown away). Failure: wrongUse if there are people; cancelled; the first failing
/// session's.
core::Result<std::vector<DemoResult>> makeDemoSite(database::Database& database, const catalogue::Catalogue& catalogue,
                                                   std::uint64_t seed,
                                                   const std::function<void(const DemoProgress&)>& progress,
                                                   const std::atomic<bool>* cancel = nullptr);

/// makeDemoSite in a new file, opened for writing and marked *demonstration*. What was made goes again when it fails or is
/// cancelled. Failure: badInput if the file exists (it is left as it is), storage, as makeDemoSite.
core::Result<std::unique_ptr<database::Database>> createDemoSite(const std::string& file, const database::DatabaseOptions& options,
                                                                 const catalogue::Catalogue& catalogue, std::uint64_t seed,
                                                                 const std::function<void(const DemoProgress&)>& progress,
                                                                 const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::session
