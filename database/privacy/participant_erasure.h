// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/privacy/erasure.h"

#include <cstdint>
#include <string>
#include <vector>

namespace chiron::database {

/// Participants of studies whose key names this person. Failure: storage.
core::Result<std::vector<std::int64_t>> participantsOf(Connection& connection, PersonId person);

/// The participant (not simulated) with this code; 0: none. Failure: storage.
core::Result<std::int64_t> participantWithCode(Connection& connection, const std::string& code);

/// Overwrites who a participant was (key row) and every answer to questionnaires, and the recordings if `erasure` says so or if the
/// participant wished it at withdrawal; stores the tombstone and audits it on behalf of byWhom. In the running transaction. Runs and
/// trials stay, under the code. Of an erased one again: what is left is overwritten, too. Returns the tombstone (by code). Failure:
/// notFound; wrongUse for a simulated participant; storage.
core::Result<Erasure> overwriteParticipant(Connection& connection, const Actor& byWhom, std::int64_t participant, Erasure erasure);

/// The tombstones of participants; none in a file from before studies. Failure: storage.
core::Result<std::vector<Erasure>> storedParticipantErasures(Connection& connection);

} // namespace chiron::database
