// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "core/result.h"
#include "database/database.h"
#include "session/recovery.h"
#include "session/training_run.h"

#include <memory>
#include <string>
#include <vector>

namespace chiron::session {

/// A database opened for writing with what a crash left behind brought in: how every program that trains starts.
struct OpenedSite {
    std::unique_ptr<database::Database> database;
    std::vector<RecoveredSession> recovered;
};

/// Opens `file`, making it (and its folder) if it is missing, and recovers. A file that is
/// damaged where nobody could log in is told so, and left as it is. Failure: locked, storage, badInput.
core::Result<OpenedSite> openSite(const std::string& file, const database::DatabaseOptions& options);

/// A scripted session in words: what `train` and `demo` ask for.
struct ScriptedSession {
    std::string exercise;
    int level = 1;
    std::string operatorName; ///< one of the exercise's operators, or the path of a trace file
    std::uint64_t seed = 1;
    bool realtime = false;
    bool familiarisation = false;
    mechanisms::PolarMap map = mechanisms::PolarMap::exact; ///< of the simulated gimbal
    std::string mechanism{}; ///< kinematics id of the simulated mechanism; "": the exercise's usual one
    WorkspaceChoice mounting{}; ///< how the bases of the simulated mechanisms stand
};

/// Whether its operator, or trace, can be had at all: asked before a database is made for it. Failure: notFound (exercise,
/// level, operator), badInput (trace).
core::Result<void> checkOperator(const catalogue::Catalogue& catalogue, const ScriptedSession& session);

/// Runs it as `actor`. Failure: notFound (exercise, level, operator), badInput (trace), as runTraining.
core::Result<TrainingResult> runScripted(database::Database& database, const database::Actor& actor,
                                         const catalogue::Catalogue& catalogue, const ScriptedSession& session,
                                         const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::session
