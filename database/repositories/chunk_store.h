// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"
#include "recording/trial_sink.h"

#include <memory>

namespace chiron::database {

/// Makes the sink of a running session on the writer's connection; it continues after the existing chunks.
/// Repositories provide it after checking the actor.
core::Result<std::unique_ptr<recording::TrialSink>> makeChunkSink(Connection& connection, SessionId session);

/// Makes the source of a session's chunks on any connection.
core::Result<std::unique_ptr<recording::ChunkSource>> makeChunkSource(Connection& connection,
                                                                      SessionId session);

} // namespace chiron::database
