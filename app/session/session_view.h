// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/session_reader.h"
#include "recording/recording_reader.h"
#include "scoring/score_card.h"
#include "scoring/trace.h"
#include "session/playback_track.h"
#include "session/session_events.h"
#include "session/session_setup.h"
#include "session/tool_positions.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace chiron::session {

class ExerciseKind;
class TraceAssembler;

/// Receives the fraction of the recording that has been read, 0..1; returning false stops the work.
using ReadProgress = std::function<bool(double)>;
/// Receives the frames of a recording in order, chunk by chunk.
using FrameVisitor = std::function<core::Result<void>(std::span<const core::HapticFrame>)>;

/// One stored session, opened for review: its setup at the time, and everything derived from its recording.
/// Scores, debrief, playback, report, replay and exports all use it, so that each value is derived in one
/// place. Data derived from the samples are computed on first use and cached; decode() derives what debrief,
/// playback and report need in one pass. It belongs to the thread of its connection and must not outlive the
/// connection. The results of trace(), track() and events() outlive it and may be read on any thread.
class SessionView {
public:
    /// Opens a session.
    /// Errors: notFound, notAllowed, badInput (damaged rows), doesNotHold (damaged chunks are named when they
    ///   are read).
    static core::Result<std::unique_ptr<SessionView>>
    open(database::Connection& connection, const database::Actor& actor, database::SessionId session);
    SessionView(const SessionView&) = delete;
    SessionView& operator=(const SessionView&) = delete;

    const database::SessionRecord& record() const noexcept { return m_record; }
    const SessionSetup& setup() const noexcept { return m_setup; }
    const ToolPositions& positions() const noexcept { return *m_positions; }
    recording::RecordingReader& reader() noexcept { return *m_reader; }

    /// Reads the recording once and derives trace and track from it. Takes about one second for a session of
    /// ten minutes, so call it on a worker.
    /// Errors: those of the reader; doesNotHold naming the damaged chunk; cancelled.
    core::Result<void> decode(const ReadProgress& progress = {});
    /// The trials as the metrics see them, truth included.
    /// Errors: those of the reader.
    core::Result<std::shared_ptr<const scoring::SessionTrace>> trace();
    /// The truth of each trial that was begun, as the exercise's own struct, by the function that reads it:
    /// truths(scoring::tubeTruthOf).
    /// Errors: those of trace(); those of `read`, with the trial.
    template <class Truth>
    core::Result<std::vector<Truth>>
        truths(core::Result<Truth> (*read)(std::span<const scoring::NamedValue>));
    /// Events, trials and end of the session by its recording; concludeSession() stores them. Derives the
    /// trace in the same pass, because outcomes of answers need it.
    /// Errors: those of the reader.
    core::Result<std::shared_ptr<const SessionEvents>> events();
    /// The session for playback, with all events as marks.
    /// Errors: those of decode().
    core::Result<std::shared_ptr<const PlaybackTrack>> track(const ReadProgress& progress = {});
    /// Calls `visit` for the frames of each chunk in order, for output or counting frame by frame.
    /// Errors: those of the reader or of the visitor.
    core::Result<void> eachChunk(const FrameVisitor& visit);
    /// Number of times that this view has decoded the whole recording.
    int decodings() const noexcept { return m_decodings; }

    /// Computes the scores from the recording. Gates can be passed only if the session is `completed`.
    core::Result<scoring::ScoreCard> computeScores();
    /// The same with a chosen version of every metric that has this version (0: the session's own).
    core::Result<scoring::ScoreCard> computeScores(int metricVersion);
    /// The scores for a given trace of this session, once it is known whether the session was completed.
    core::Result<scoring::ScoreCard> scoresOf(const scoring::SessionTrace& trace, bool completed,
                                              int metricVersion = 0) const;

private:
    SessionView() = default;
    struct Parts {
        bool trace = false;
        bool track = false;
        bool events = false;
    };
    core::Result<void> derive(Parts wanted, const ReadProgress& progress);
    void keep(TraceAssembler& assembler, const ExerciseKind& kind);

    database::SessionRecord m_record;
    SessionSetup m_setup;
    std::unique_ptr<ToolPositions> m_positions;
    std::unique_ptr<recording::ChunkSource> m_chunks;
    std::unique_ptr<recording::RecordingReader> m_reader;
    std::shared_ptr<const scoring::SessionTrace> m_trace;
    std::shared_ptr<const PlaybackTrack> m_track;
    std::shared_ptr<const SessionEvents> m_events;
    int m_decodings = 0;
};

template <class Truth>
core::Result<std::vector<Truth>>
SessionView::truths(core::Result<Truth> (*read)(std::span<const scoring::NamedValue>)) {
    const auto session = trace();
    CHIRON_TRY(session);
    std::vector<Truth> truths;
    for (const scoring::TrialTrace& trial : (*session)->trials) {
        auto truth = read(trial.truth);
        if (!truth)
            return core::fail(truth.error().code,
                              "trial " + std::to_string(trial.trial + 1) + ": " + truth.error().message);
        truths.push_back(std::move(*truth));
    }
    return truths;
}

/// True if two score cards are equal bit for bit: ids, versions, values, verdicts.
bool sameScores(const scoring::ScoreCard& a, const scoring::ScoreCard& b);

} // namespace chiron::session
