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

/// Reads sessions, on any connection. Trainees see their own and simulated ones; nobody logged in sees
/// simulated ones. Sittings of a blinded study are listed, without how much was recorded (SessionSummary::sealed), and their comments read; all else of
/// them is closed to everybody (notAllowed) until the study is unblinded.
class SessionReader {
public:
    SessionReader(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    core::Result<std::vector<SessionSummary>> listSessions(const SessionFilter& filter = {});
    /// Sessions still marked running: live ones, and those to recover (setup.ringFile says where the ring
    /// lies).
    core::Result<std::vector<SessionRecord>> listUnfinished();
    core::Result<SessionRecord> session(SessionId id);
    core::Result<std::vector<TrialRecord>> trials(SessionId id);
    core::Result<std::vector<EventRecord>> events(SessionId id);
    core::Result<std::vector<recording::SecondSummary>> secondSummaries(SessionId id);
    core::Result<std::vector<SessionComment>> comments(SessionId id);
    /// The reader's own sessions that somebody commented on, and others' that the reader commented on, newest first, archived ones too.
    core::Result<std::vector<CommentedSession>> commentedSessions(const CommentedFilter& which = {});
    /// Chunks of a session; works on this connection, so on its thread and not beyond it. Failure: notFound
    /// also where the recording was erased.
    core::Result<std::unique_ptr<recording::ChunkSource>> openChunks(SessionId id);

    /// The statement behind listSessions; a test looks at its query plan.
    static std::string listSql(const std::string& where, bool newestFirst);

private:
    core::Result<std::vector<SessionSummary>> summaries(const std::string& where, const std::vector<Value>& values, bool newestFirst);
    core::Result<std::vector<SessionRecord>> records(const std::string& where,
                                                     const std::vector<Value>& values);

    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
