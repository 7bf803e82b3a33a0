// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/access/authorise.h"
#include "database/query.h"
#include "database/repositories/session_reader.h"
#include "database/repositories/session_rules.h"
#include "database/repositories/study_blinding.h"

namespace chiron::database {
namespace {

// Returns the rows of one session, each converted to a value.
template <class T, class Make>
core::Result<std::vector<T>> rowsOf(Connection& connection, const Actor& actor, Action action, SessionId id,
                                    const std::string& sql, Make make) {
    auto allowed = authoriseForSession(connection, actor, action, id);
    if (action != Action::comments) { // comments may be read in any case
        allowed = allowed ? mayOpenSitting(connection, actor, id) : allowed;
    }
    CHIRON_TRY(allowed);
    auto query = Query::run(connection, sql, {id});
    CHIRON_TRY(query);
    std::vector<T> values;
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        values.push_back(make(*query));
    }
    CHIRON_TRY(row);
    return values;
}

} // namespace

core::Result<std::vector<TrialRecord>> SessionReader::trials(SessionId id) {
    return rowsOf<TrialRecord>(
        m_connection, m_actor, Action::trials, id,
        "SELECT ordinal, seed, state, first_tick, last_tick, marked, timed_out, scene_json FROM trial "
        "WHERE session_id = ? ORDER BY ordinal",
        [](const Query& row) {
            return TrialRecord{static_cast<int>(row.integer(0)),
                               unsignedFromStored(row.integer(1)),
                               sessionStateFromToken(row.text(2)).value_or(SessionState::faulted),
                               unsignedFromStored(row.integer(3)),
                               unsignedFromStored(row.integer(4)),
                               row.integer(5) != 0,
                               row.integer(6) != 0,
                               row.text(7)};
        });
}

core::Result<std::vector<EventRecord>> SessionReader::events(SessionId id) {
    return rowsOf<EventRecord>(
        m_connection, m_actor, Action::events, id,
        "SELECT tick, time_s, tool, kind, detail_json FROM event WHERE session_id = ? ORDER BY ordinal",
        [](const Query& row) {
            return EventRecord{unsignedFromStored(row.integer(0)), row.real(1),
                               static_cast<int>(row.integer(2)), row.text(3), row.text(4)};
        });
}

core::Result<std::vector<recording::SecondSummary>> SessionReader::secondSummaries(SessionId id) {
    return rowsOf<recording::SecondSummary>(m_connection, m_actor, Action::secondSummaries, id,
                                            "SELECT second, tool, frames, path_length_m, maximum_force_n, "
                                            "mean_force_n, impulse_ns, time_over_limit_s, events "
                                            "FROM second_summary WHERE session_id = ? ORDER BY second, tool",
                                            [](const Query& row) {
                                                return recording::SecondSummary{
                                                    static_cast<std::uint32_t>(row.integer(0)),
                                                    static_cast<std::uint8_t>(row.integer(1)),
                                                    static_cast<std::uint32_t>(row.integer(2)),
                                                    row.real(3),
                                                    row.real(4),
                                                    row.real(5),
                                                    row.real(6),
                                                    row.real(7),
                                                    static_cast<std::uint32_t>(row.integer(8))};
                                            });
}

SessionComment commentOf(const Query& row) {
    SessionComment comment{row.integer(0), row.integer(1), row.text(2), row.text(3), std::nullopt};
    if (!row.isNull(4)) {
        comment.tick = unsignedFromStored(row.integer(4));
    }
    return comment;
}

core::Result<std::vector<SessionComment>> SessionReader::comments(SessionId id) {
    return rowsOf<SessionComment>(
        m_connection, m_actor, Action::comments, id,
        "SELECT id, author_id, utc, text, tick FROM session_comment WHERE session_id = ? ORDER BY id",
        commentOf);
}

} // namespace chiron::database
