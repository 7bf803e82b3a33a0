// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/privacy/erasure.h"

#include <cstdint>
#include <string>
#include <vector>

namespace chiron::database {

/// Returns the participants of studies whose key names this person.
/// Errors: storage.
core::Result<std::vector<std::int64_t>> participantsOf(Connection& connection, PersonId person);

/// Returns the (not simulated) participant with this code; 0 if there is none.
/// Errors: storage.
core::Result<std::int64_t> participantWithCode(Connection& connection, const std::string& code);

/// Overwrites a participant's identity (key row) and every answer to questionnaires, and the recordings if
/// `erasure` says so or if the participant wished it at withdrawal. Stores the tombstone and audits it on
/// behalf of byWhom, all in the running transaction. Runs and trials remain, under the code. If the
/// participant is erased already, any remaining data is overwritten, too. Returns the tombstone (by code).
/// Errors: notFound; wrongUse for a simulated participant; storage.
core::Result<Erasure> overwriteParticipant(Connection& connection, const Actor& byWhom,
                                           std::int64_t participant, Erasure erasure);

/// Returns the tombstones of participants; none in a file from before studies existed.
/// Errors: storage.
core::Result<std::vector<Erasure>> storedParticipantErasures(Connection& connection);

} // namespace chiron::database
