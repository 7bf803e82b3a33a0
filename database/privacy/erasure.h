// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"

#include <string>
#include <vector>

namespace chiron::database {

/// What is left of an erased person.
struct Erasure {
    PersonId person = 0;
    /// created_utc of the person's row. A restore gives a number out again that the backup does not know yet,
    /// so the number alone does not tell who was meant. Empty in lists written before it was kept.
    std::string personCreated_utc;
    std::string utc;
    std::string reason;
    PersonId administrator = 0;
    bool recordingsWithdrawn = false;
    std::string digestsJson; ///< digests of what was overwritten
    /// Of a participant of a study, erased by the code alone (person is 0 then): codes are never given out twice.
    std::string participantCode{};
};

/// Whether it is about the person with this number who was created then ("" on either side: not known).
inline bool isAbout(const Erasure& erasure, PersonId person, const std::string& created_utc) {
    const bool unknown = erasure.personCreated_utc.empty() || created_utc.empty();
    return erasure.person == person && (unknown || erasure.personCreated_utc == created_utc);
}

/// Puts an erasure into a list, in the place of an older one of the same person or participant.
void putErasure(std::vector<Erasure>& list, const Erasure& erasure);

/// Overwrites a person's name, code, credentials and free texts (and recordings, if withdrawn), erases who of
/// the participants of studies it was, stores the tombstone and audits it on behalf of byWhom. In the running transaction. Row digests of trials, chunks and
/// comments, and seals, stay as they were: they cover payloads and texts through their hashes. Failure:
/// notFound, storage.
core::Result<Erasure> overwritePerson(Connection& connection, const Actor& byWhom, Erasure erasure);

/// "<site folder>/erasures.json": what a restore must erase again. Adds (or renews) one. Failure: storage,
/// badInput if the file is malformed.
core::Result<void> writeErasureList(const std::string& siteFolder, const Erasure& erasure);
/// A list as written above or found in a backup; empty where there is no file. Failure: badInput.
core::Result<std::vector<Erasure>> readErasureList(const std::string& file);
core::Result<void> saveErasureList(const std::string& file, const std::vector<Erasure>& erasures);

/// Overwrites the samples of a session and marks it; adds its seal to `digestsJson` (`"3":"..."`). Failure: storage.
core::Result<void> overwriteRecording(Connection& connection, const Actor& byWhom, SessionId session,
                                      std::string& digestsJson);

/// The tombstones in a database, people's before participants'.
core::Result<std::vector<Erasure>> storedErasures(Connection& connection);

inline std::string erasureListFile(const std::string& siteFolder) {
    return siteFolder + "/erasures.json";
}

} // namespace chiron::database
