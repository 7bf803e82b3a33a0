// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "database/connection.h"
#include "recording/trial_sink.h"

#include <memory>

namespace chiron::database {

/// The sink of a running session on the writer's connection; continues after the chunks that are there.
/// Repositories hand it out after checking the actor.
core::Result<std::unique_ptr<recording::TrialSink>> makeChunkSink(Connection& connection, SessionId session);

/// The chunks of a session on any connection.
core::Result<std::unique_ptr<recording::ChunkSource>> makeChunkSource(Connection& connection,
                                                                      SessionId session);

} // namespace chiron::database
