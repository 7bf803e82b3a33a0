// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"
#include "database/integrity/row_digest.h"

#include <cstdint>

namespace chiron::database {

/// Returns BLAKE2b-256 over the row digests of a session's chunks, trials, events and per-second summaries,
/// in order, each group with its count. The audit chain stores this seal when a session ends.
core::Result<RowDigest> sessionSeal(Connection& connection, SessionId session);

/// Returns BLAKE2b-256 over the row digests of a set of scores, in order.
core::Result<RowDigest> scoreSeal(Connection& connection, std::int64_t scoreSetId);

} // namespace chiron::database
