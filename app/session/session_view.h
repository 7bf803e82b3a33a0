// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/session_reader.h"
#include "recording/recording_reader.h"
#include "scoring/score_card.h"
#include "scoring/trace.h"
#include "session/playback_track.h"
#include "session/session_setup.h"
#include "session/tool_positions.h"

#include <functional>
#include <memory>
#include <span>

namespace chiron::session {

class ExerciseKind;
class TraceAssembler;

/// Hears how much of the recording is read, 0..1; false stops the work.
using ReadProgress = std::function<bool(double)>;
/// Sees the frames of a recording in order, chunk by chunk.
using FrameVisitor = std::function<core::Result<void>(std::span<const core::HapticFrame>)>;

/// One stored session, opened for review: its setup as it was, and everything that its recording tells. Scores, debrief, playback,
/// report, replay and exports look back through it, so that one value is derived in one place. What is derived from the samples is read
/// when it is first asked for and kept; decode() derives all of it from one pass. Lives on the thread, and within the life, of its
/// connection; what trace() and track() give outlives it and may be read on any thread.
class SessionView {
public:
    /// Failure: notFound, notAllowed, badInput (damaged rows), doesNotHold (damaged chunks are named when touched).
    static core::Result<std::unique_ptr<SessionView>> open(database::Connection& connection, const database::Actor& actor,
                                                           database::SessionId session);
    SessionView(const SessionView&) = delete;
    SessionView& operator=(const SessionView&) = delete;

    const database::SessionRecord& record() const noexcept { return m_record; }
    const SessionSetup& setup() const noexcept { return m_setup; }
    const ToolPositions& positions() const noexcept { return *m_positions; }
    recording::RecordingReader& reader() noexcept { return *m_reader; }

    /// Reads the recording once and derives trace and track from it (about a second for a session of ten minutes, on a worker).
    /// Failure: the reader's, doesNotHold naming the damaged chunk; cancelled.
    core::Result<void> decode(const ReadProgress& progress = {});
    /// The trials as metrics see them, truth included. `also` sees every frame of the recording, of the same pass where the trace is not
    /// known yet. Failure: the reader's, or the visitor's.
    core::Result<std::shared_ptr<const scoring::SessionTrace>> trace();
    core::Result<std::shared_ptr<const scoring::SessionTrace>> trace(const FrameVisitor& also);
    /// The session as playback shows it, with everything that happened as marks. Failure: as decode().
    core::Result<std::shared_ptr<const PlaybackTrack>> track(const ReadProgress& progress = {});
    /// Calls `visit` for each chunk's frames in order: for what is written or counted frame by frame. Failure: the reader's, or the visitor's.
    core::Result<void> eachChunk(const FrameVisitor& visit);
    /// How often the whole recording has been decoded through this view.
    int decodings() const noexcept { return m_decodings; }

    /// Computes the scores from the recording. `completed` decides whether gates can be passed.
    core::Result<scoring::ScoreCard> computeScores();
    /// The same under a chosen version of every metric that has it (0: the session's own).
    core::Result<scoring::ScoreCard> computeScores(int metricVersion);
    /// The scores of this session's trace once it is known whether it was completed.
    core::Result<scoring::ScoreCard> scoresOf(const scoring::SessionTrace& trace, bool completed,
                                              int metricVersion = 0) const;

private:
    SessionView() = default;
    core::Result<void> derive(bool trace, bool track, const ReadProgress& progress, const FrameVisitor& also);
    void keep(TraceAssembler& assembler, const ExerciseKind& kind);

    database::SessionRecord m_record;
    SessionSetup m_setup;
    std::unique_ptr<ToolPositions> m_positions;
    std::unique_ptr<recording::ChunkSource> m_chunks;
    std::unique_ptr<recording::RecordingReader> m_reader;
    std::shared_ptr<const scoring::SessionTrace> m_trace;
    std::shared_ptr<const PlaybackTrack> m_track;
    int m_decodings = 0;
};

/// Whether two score cards are the same, bit for bit: ids, versions, values, verdicts.
bool sameScores(const scoring::ScoreCard& a, const scoring::ScoreCard& b);

} // namespace chiron::session
