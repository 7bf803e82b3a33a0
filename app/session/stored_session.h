// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/session_reader.h"
#include "recording/recording_reader.h"
#include "scoring/score_card.h"
#include "scoring/trace.h"
#include "session/session_setup.h"
#include "session/tool_positions.h"

#include <functional>
#include <memory>
#include <span>

namespace chiron::session {

/// One stored session, opened for review: setup as it was, samples, trace. Everything that looks back (scores, replay,
/// export, report, playback) goes through here. Lives on the thread, and within the life, of its connection.
class StoredSession {
public:
    /// Failure: notFound, notAllowed, badInput (damaged rows), doesNotHold (damaged chunks are named when touched).
    static core::Result<std::unique_ptr<StoredSession>> open(database::Connection& connection,
                                                             const database::Actor& actor,
                                                             database::SessionId session);
    StoredSession(const StoredSession&) = delete;
    StoredSession& operator=(const StoredSession&) = delete;

    const database::SessionRecord& record() const noexcept { return m_record; }
    const SessionSetup& setup() const noexcept { return m_setup; }
    const ToolPositions& positions() const noexcept { return *m_positions; }
    recording::RecordingReader& reader() noexcept { return *m_reader; }

    /// Calls `visit` for each chunk's frames in order. Failure: the reader's, or the visitor's.
    core::Result<void>
    eachChunk(const std::function<core::Result<void>(std::span<const core::HapticFrame>)>& visit);
    /// The trials as metrics see them, truth included.
    core::Result<scoring::SessionTrace> trace();
    /// Computes the scores from the recording. `completed` decides whether gates can be passed.
    core::Result<scoring::ScoreCard> computeScores();
    /// The same under a chosen version of every metric that has it (0: the session's own).
    core::Result<scoring::ScoreCard> computeScores(int metricVersion);
    /// The scores of this session's trace once it is known whether it was completed.
    core::Result<scoring::ScoreCard> scoresOf(const scoring::SessionTrace& trace, bool completed,
                                              int metricVersion = 0) const;

private:
    StoredSession() = default;

    database::SessionRecord m_record;
    SessionSetup m_setup;
    std::unique_ptr<ToolPositions> m_positions;
    std::unique_ptr<recording::ChunkSource> m_chunks;
    std::unique_ptr<recording::RecordingReader> m_reader;
};

/// Whether two score cards are the same, bit for bit: ids, versions, values, verdicts.
bool sameScores(const scoring::ScoreCard& a, const scoring::ScoreCard& b);

} // namespace chiron::session
