// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/site.h"

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

/// The people of a demonstration site; their password is documented, and the database marked *demonstration*.
inline constexpr const char* kDemoPassword = "asclepius-demo";

/// Fills a fresh database: an administrator, a trainer, a researcher, three trainees; four operators on every level of
/// every exercise as the simulated account, and a few attempts of each trainee; each session replayed and scored again.
/// `progress` hears one line a session. Failure: badInput if the database exists; the first failing session's.
core::Result<std::vector<DemoResult>> makeDemoSite(database::Database& database, const catalogue::Catalogue& catalogue,
                                                   std::uint64_t seed,
                                                   const std::function<void(const std::string&)>& progress);

} // namespace chiron::session
