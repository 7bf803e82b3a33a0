// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"

#include <string>
#include <vector>

namespace chiron::database {

/// The tombstone of an erased person or participant.
struct Erasure {
    PersonId person = 0;
    /// created_utc of the person's row. After a restore, a number that the backup does not know is assigned
    /// again, so the number alone does not identify the person. Empty in lists written before this was kept.
    std::string personCreated_utc;
    std::string utc;
    std::string reason;
    PersonId administrator = 0;
    bool recordingsWithdrawn = false;
    std::string digestsJson; ///< digests of the overwritten data
    /// For a participant of a study who was erased only by code (person is then 0). Codes are never assigned
    /// twice.
    std::string participantCode{};
};

/// Returns whether the erasure is about the person with this number and creation time ("" on either side: not
/// known).
inline bool isAbout(const Erasure& erasure, PersonId person, const std::string& created_utc) {
    const bool unknown = erasure.personCreated_utc.empty() || created_utc.empty();
    return erasure.person == person && (unknown || erasure.personCreated_utc == created_utc);
}

/// Puts an erasure into a list, replacing an older one of the same person or participant.
void putErasure(std::vector<Erasure>& list, const Erasure& erasure);

/// Overwrites a person's name, code, credentials and free texts (and recordings, if withdrawn), erases the
/// identity of the participants of studies that the person was, stores the tombstone and audits it on behalf
/// of byWhom, all in the running transaction. Row digests of trials, chunks and comments, and seals, do not
/// change, because they cover payloads and texts through their hashes.
/// Errors: notFound, storage.
core::Result<Erasure> overwritePerson(Connection& connection, const Actor& byWhom, Erasure erasure);

/// Adds (or renews) an erasure in "<site folder>/erasures.json", the list of what a restore must erase again.
/// Errors: storage; badInput if the file is malformed.
core::Result<void> writeErasureList(const std::string& siteFolder, const Erasure& erasure);
/// Reads a list as written above or found in a backup; empty if there is no file.
/// Errors: badInput.
core::Result<std::vector<Erasure>> readErasureList(const std::string& file);
core::Result<void> saveErasureList(const std::string& file, const std::vector<Erasure>& erasures);

/// Overwrites the samples of a session and marks it; adds its seal to `digestsJson` (`"3":"..."`).
/// Errors: storage.
core::Result<void> overwriteRecording(Connection& connection, const Actor& byWhom, SessionId session,
                                      std::string& digestsJson);

/// Returns the tombstones in a database, those of people before those of participants.
core::Result<std::vector<Erasure>> storedErasures(Connection& connection);

inline std::string erasureListFile(const std::string& siteFolder) {
    return siteFolder + "/erasures.json";
}

} // namespace chiron::database
