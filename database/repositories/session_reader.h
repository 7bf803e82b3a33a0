// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/session_types.h"
#include "database/value.h"
#include "recording/trial_sink.h"

#include <memory>
#include <vector>

namespace chiron::database {

/// Reads sessions, on any connection. Trainees see their own and simulated sessions; without a login only
/// simulated ones are visible. Sessions of a blinded study are listed without how much was recorded
/// (SessionSummary::sealed), and their comments can be read; everything else about them is closed to
/// everybody (notAllowed) until the study is unblinded.
class SessionReader {
public:
    SessionReader(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    core::Result<std::vector<SessionSummary>> listSessions(const SessionFilter& filter = {});
    /// Returns the sessions still marked as running: live ones, and those to recover (setup.ringFile says
    /// where the crash ring is).
    core::Result<std::vector<SessionRecord>> listUnfinished();
    core::Result<SessionRecord> session(SessionId id);
    core::Result<std::vector<TrialRecord>> trials(SessionId id);
    core::Result<std::vector<EventRecord>> events(SessionId id);
    core::Result<std::vector<recording::SecondSummary>> secondSummaries(SessionId id);
    core::Result<std::vector<SessionComment>> comments(SessionId id);
    /// Returns the reader's own sessions on which somebody else commented, and other people's sessions on
    /// which the reader commented, newest first, archived ones too.
    core::Result<std::vector<CommentedSession>> commentedSessions(const CommentedFilter& which = {});
    /// Opens the chunks of a session. The source uses this connection, so it is bound to its thread and must
    /// not outlive it.
    /// Errors: notFound, also if the recording was erased.
    core::Result<std::unique_ptr<recording::ChunkSource>> openChunks(SessionId id);

    /// The SQL statement of listSessions; a test examines its query plan.
    static std::string listSql(const std::string& where, bool newestFirst);

private:
    core::Result<std::vector<SessionSummary>> summaries(const std::string& where,
                                                        const std::vector<Value>& values, bool newestFirst);
    core::Result<std::vector<SessionRecord>> records(const std::string& where,
                                                     const std::vector<Value>& values);

    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
