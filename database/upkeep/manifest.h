// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/audit/audit_trail.h"

#include <atomic>
#include <cstdint>
#include <map>
#include <string>

namespace chiron::database {

/// manifest.json of a backup or an export: what files belong to it, with their BLAKE2b-256, and the head of
/// the audit chain in the snapshot; signed with the site key.
struct Manifest {
    std::string kind; ///< "backup" or "export"
    std::string createdUtc;
    int schemaVersion = 0;
    AuditHead head;
    std::map<std::string, std::string> files; ///< path inside the folder -> 64 hex digits
    /// Made by the schedule: which of them it is in its folder, from 1; 0: made by hand. Not the clock tells which is older.
    std::int64_t automaticNumber = 0;
};

inline constexpr const char* kSnapshotFile = "chiron.db";
inline constexpr std::int64_t kLargestManifest_bytes = 16 << 20; ///< an export of 100,000 sessions
inline constexpr const char* kErasuresFile = "erasures.json";

core::Result<void> writeManifest(const std::string& folder, const Manifest& manifest, const SiteKey& key);

/// What the manifest says and the key vouches for; the files themselves are not looked at. Failure as readManifest.
core::Result<Manifest> readSignedManifest(const std::string& folder, const SiteKey& key);

/// Reads and checks: signature, and the digest of every file named. Failure: badInput (malformed),
/// doesNotHold (a file is missing or changed, or the signature is not this site's), storage, cancelled.
core::Result<Manifest> readManifest(const std::string& folder, const SiteKey& key, const std::atomic<bool>* cancel = nullptr);

/// BLAKE2b-256 of a file as 64 hex digits. Failure: storage; cancelled.
core::Result<std::string> fileDigest(const std::string& file, const std::atomic<bool>* cancel = nullptr);

} // namespace chiron::database
