// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/repositories/session_types.h"
#include "recording/trial_sink.h"

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace chiron::database {

/// Writes sessions: begin -> sink, trials, events -> finish -> scores (ScoreRepository). Only on the writer's
/// connection, and only for the actor's own sessions, except that maintenance finishes those that a crash
/// left open.
class SessionRepository {
public:
    SessionRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Creates a running session of the actor and returns its number.
    /// Errors: badInput with field and value; for the run of a study: notAllowed, notFound, wrongUse if it
    /// has ended.
    core::Result<SessionId> beginSession(const NewSession& session);

    /// Opens the sink for the chunks of a running session. Use it only on the writer thread
    /// (IDrainable::drain, jobs), and destroy it before the Database. Each write is one transaction (or part
    /// of the job's). Sequence numbers must follow one another without a gap.
    core::Result<std::unique_ptr<recording::TrialSink>> openSink(SessionId session);

    core::Result<void> storeTrial(SessionId session, const TrialRecord& trial);
    core::Result<void> storeEvents(SessionId session, std::span<const EventRecord> events);

    /// Ends a running session with any state except running and voided, seals its recording (a digest over
    /// the digests of all its rows) and adds the seal to the audit chain.
    /// Errors: wrongUse if the session is not running.
    core::Result<void> finishSession(SessionId session, const SessionEnd& end);

    /// Voids a session: all data is kept, but the session no longer counts. The reason is required. Audited.
    /// Errors: wrongUse if the session is running or voided.
    core::Result<void> voidSession(SessionId session, const std::string& reason);
    /// Makes a voided session count again, as before; a reason is required. Each voiding and reinstatement
    /// stays on record with person, time and reason (SessionRecord::decisions). Audited.
    /// Errors: wrongUse if the session is not voided.
    core::Result<void> reinstateSession(SessionId session, const std::string& reason);
    /// Hides it from the usual lists; audited.
    core::Result<void> setArchived(SessionId session, bool archived);
    /// Adds a comment to the session as a whole, or to a moment of its recording (executed tick). Audited.
    /// Errors: badInput, also if an ended session is shorter.
    core::Result<std::int64_t> addComment(SessionId session, const std::string& text,
                                          std::optional<std::uint64_t> tick = {});

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
