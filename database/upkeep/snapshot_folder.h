// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/upkeep/manifest.h"
#include "database/upkeep/upkeep.h"

#include <functional>

namespace chiron::database {

/// Adds further files to a folder that is being written; returns their paths inside it.
using SnapshotExtra =
    std::function<core::Result<std::vector<std::string>>(Connection& snapshot, const std::string& folder)>;

/// Writes a snapshot folder: the database's copy, verified, erasures and extras, then the manifest. The
/// folder has another name until it is complete. `automaticNumber`: as in Manifest.
/// Errors: badInput if the folder exists; doesNotHold if the copy does not verify; cancelled; storage.
core::Result<SnapshotInfo> writeSnapshotFolder(Database& database, Connection& reader,
                                               const std::string& folder, const std::string& kind,
                                               const SnapshotExtra& extra, const std::atomic<bool>* cancel,
                                               std::int64_t automaticNumber = 0);

} // namespace chiron::database
