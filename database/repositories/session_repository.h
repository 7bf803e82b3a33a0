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
/// connection. Own sessions only, but for maintenance, which finishes what a crash left open.
class SessionRepository {
public:
    SessionRepository(Connection& connection, Actor actor)
        : m_connection(connection), m_actor(std::move(actor)) {}

    /// Creates a running session of the actor and returns its number. Failure: badInput with field and value; of a study's run:
    /// notAllowed, notFound, wrongUse when it has ended.
    core::Result<SessionId> beginSession(const NewSession& session);

    /// Where the chunks of a running session go. Use it on the writer thread only (IDrainable::drain, jobs);
    /// destroy it before the Database. Each write is one transaction (or part of the job's). Sequences must
    /// follow on without a gap.
    core::Result<std::unique_ptr<recording::TrialSink>> openSink(SessionId session);

    core::Result<void> storeTrial(SessionId session, const TrialRecord& trial);
    core::Result<void> storeEvents(SessionId session, std::span<const EventRecord> events);

    /// Ends a running session with any state but running and voided, seals its recording (a digest over the
    /// digests of all its rows) and puts the seal into the audit chain. Failure: wrongUse when it is not
    /// running.
    core::Result<void> finishSession(SessionId session, const SessionEnd& end);

    /// Keeps everything, counts nothing; the reason is required. Audited. Failure: wrongUse when running or
    /// voided.
    core::Result<void> voidSession(SessionId session, const std::string& reason);
    /// A voided session counts again, as it did before; a reason is required. Voiding and taking back stay on record, each with who, when
    /// and why (SessionRecord::decisions). Audited. Failure: wrongUse when it is not voided.
    core::Result<void> reinstateSession(SessionId session, const std::string& reason);
    core::Result<void> setArchived(SessionId session, bool archived); ///< out of the usual lists; audited
    /// To the session as a whole, or to a moment of its recording (executed tick). Audited. Failure:
    /// badInput, also when an ended session is shorter.
    core::Result<std::int64_t> addComment(SessionId session, const std::string& text,
                                          std::optional<std::uint64_t> tick = {});

private:
    Connection& m_connection;
    Actor m_actor;
};

} // namespace chiron::database
