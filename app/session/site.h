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

/// A database opened for writing after recovery from a crash. Every program that trains starts in this way.
struct OpenedSite {
    std::unique_ptr<database::Database> database;
    std::vector<RecoveredSession> recovered;
};

/// Opens `file`, creates it (and its folder) if it is missing, and recovers. Reports a file that is damaged
/// so that nobody could log in, and leaves it unchanged.
/// Errors: locked, storage, badInput.
core::Result<OpenedSite> openSite(const std::string& file, const database::DatabaseOptions& options);

/// The specification of a scripted session, as used by `train` and `demo`.
struct ScriptedSession {
    std::string exercise;
    int level = 1;
    std::string operatorName; ///< one of the exercise's operators, or the path of a trace file
    std::uint64_t seed = 1;
    bool realtime = false;
    bool familiarisation = false;
    std::string forceMap{};     ///< one of devices::forceMapIds(); "": the usual one
    std::string mechanism{};    ///< kinematics id of the simulated mechanism; "": the exercise's usual one
    WorkspaceChoice mounting{}; ///< mounting of the bases of the simulated mechanisms
    /// Catalogue id of a driver whose devices somebody holds (MovedBy::person, a handle), instead of
    /// `operatorName`, which is then empty. Its session runs by the device's clock.
    std::string driver{};
    /// Where its devices are connected, one for each tool; empty: as the driver finds them.
    std::vector<std::string> addresses{};
};

/// Checks whether the operator or trace is available, before a database is created for it.
/// Errors: notFound (exercise, level, operator), badInput (trace).
core::Result<void> checkOperator(const catalogue::Catalogue& catalogue, const ScriptedSession& session);

/// Runs the session as `actor`.
/// Errors: notFound (exercise, level, operator); badInput (trace); those of runTraining.
core::Result<TrainingResult> runScripted(database::Database& database, const database::Actor& actor,
                                         const catalogue::Catalogue& catalogue,
                                         const ScriptedSession& session,
                                         const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::session
