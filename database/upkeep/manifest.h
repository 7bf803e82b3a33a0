// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/audit/audit_trail.h"

#include <atomic>
#include <cstdint>
#include <map>
#include <string>

namespace chiron::database {

/// manifest.json of a backup or an export: the files that belong to it, with their BLAKE2b-256, and the head
/// of the audit chain in the snapshot; signed with the site key.
struct Manifest {
    std::string kind; ///< "backup" or "export"
    std::string createdUtc;
    int schemaVersion = 0;
    AuditHead head;
    std::map<std::string, std::string> files; ///< path inside the folder -> 64 hex digits
    /// Sequence number of a scheduled backup in its folder, from 1; 0: made by hand. This number, and not the
    /// clock, determines which backup is older.
    std::int64_t automaticNumber = 0;
};

inline constexpr const char* kSnapshotFile = "chiron.db";
inline constexpr std::int64_t kLargestManifest_bytes = 16 << 20; ///< enough for an export of 100,000 sessions
inline constexpr const char* kErasuresFile = "erasures.json";

core::Result<void> writeManifest(const std::string& folder, const Manifest& manifest, const SiteKey& key);

/// Returns the signed content of the manifest without checking the files themselves.
/// Errors: as readManifest.
core::Result<Manifest> readSignedManifest(const std::string& folder, const SiteKey& key);

/// Reads the manifest and checks its signature and the digest of every file named in it.
/// Errors: badInput (malformed); doesNotHold (a file is missing or changed, or the signature is not this
/// site's); storage; cancelled.
core::Result<Manifest> readManifest(const std::string& folder, const SiteKey& key,
                                    const std::atomic<bool>* cancel = nullptr);

/// Returns the BLAKE2b-256 of a file as 64 hex digits.
/// Errors: storage; cancelled.
core::Result<std::string> fileDigest(const std::string& file, const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::database
