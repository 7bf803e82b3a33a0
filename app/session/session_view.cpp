// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_view.h"

#include "scoring/metric_catalogue.h"
#include "scoring/score_calculator.h"
#include "session/exercise_kind.h"
#include "session/trace_assembler.h"
#include "session/track_builder.h"

#include <algorithm>
#include <bit>

namespace chiron::session {

core::Result<std::unique_ptr<SessionView>> SessionView::open(database::Connection& connection,
                                                             const database::Actor& actor,
                                                             database::SessionId session) {
    std::unique_ptr<SessionView> stored(new SessionView);
    database::SessionReader sessions(connection, actor);
    auto record = sessions.session(session);
    CHIRON_TRY(record);
    stored->m_record = std::move(*record);
    auto setup = setupFromStored(stored->m_record.setup);
    if (!setup)
        return core::fail(setup.error().code,
                          "session " + std::to_string(session) + ": " + setup.error().message);
    stored->m_setup = std::move(*setup);
    auto positions = ToolPositions::create(stored->m_setup);
    CHIRON_TRY(positions);
    stored->m_positions = std::move(*positions);
    auto chunks = sessions.openChunks(session);
    CHIRON_TRY(chunks);
    stored->m_chunks = std::move(*chunks);
    auto reader = recording::RecordingReader::open(*stored->m_chunks);
    CHIRON_TRY(reader);
    stored->m_reader = std::make_unique<recording::RecordingReader>(std::move(*reader));
    return stored;
}

core::Result<void> SessionView::eachChunk(const FrameVisitor& visit) {
    ++m_decodings;
    for (std::size_t i = 0; i < m_reader->chunkCount(); ++i) {
        auto frames = m_reader->framesOf(i);
        CHIRON_TRY(frames);
        CHIRON_TRY(visit(*frames));
    }
    return {};
}

core::Result<void> SessionView::decode(const ReadProgress& progress) {
    return derive({.trace = true, .track = true}, progress);
}

core::Result<std::shared_ptr<const scoring::SessionTrace>> SessionView::trace() {
    CHIRON_TRY(derive({.trace = true}, {}));
    return m_trace;
}

core::Result<std::shared_ptr<const PlaybackTrack>> SessionView::track(const ReadProgress& progress) {
    CHIRON_TRY(derive({.track = true}, progress));
    return m_track;
}

core::Result<std::shared_ptr<const SessionEvents>> SessionView::events() {
    CHIRON_TRY(derive({.events = true}, {}));
    return m_events;
}

core::Result<void> SessionView::derive(Parts wanted, const ReadProgress& progress) {
    const auto kind = exerciseKind(m_setup.level.exercise);
    CHIRON_TRY(kind);
    wanted.track = wanted.track && !m_track;
    wanted.events = wanted.events && !m_events;
    wanted.trace = !m_trace && (wanted.trace || wanted.events || (wanted.track && (*kind)->marksFromTrace()));
    if (!wanted.trace && !wanted.track && !wanted.events)
        return {};
    std::optional<TraceAssembler> assembler;
    if (wanted.trace)
        assembler.emplace(*m_positions, m_positions->tools(), m_positions.get(),
                          RecordedQuantities(m_reader->table()));
    std::unique_ptr<TrialSurfaces> surfaces;
    std::optional<TrackBuilder> track;
    if (wanted.track) {
        surfaces = (*kind)->makeSurfaces(m_setup.level, m_setup.seed);
        track.emplace(*this, *surfaces, (*kind)->sceneEvents());
    }
    std::optional<SessionEventsBuilder> events;
    if (wanted.events)
        events.emplace(m_record.setup.forceLimit_N, m_setup.seed, m_positions->tools(), m_positions.get(),
                       (*kind)->sceneEvents());
    std::size_t read = 0;
    const auto done = eachChunk([&](std::span<const core::HapticFrame> frames) -> core::Result<void> {
        if (progress && !progress(static_cast<double>(read++) / static_cast<double>(m_reader->chunkCount())))
            return core::fail(core::ErrorCode::cancelled, "reading a recording: stopped by the person");
        if (assembler)
            assembler->add(frames);
        if (track)
            track->add(frames);
        if (events)
            events->add(frames);
        return {};
    });
    CHIRON_TRY(done);
    if (assembler)
        keep(*assembler, **kind);
    if (events)
        m_events = std::make_shared<const SessionEvents>(events->take(**kind, *m_trace));
    if (!track)
        return {};
    PlaybackTrack built = track->take();
    CHIRON_TRY((*kind)->addMarks(m_setup, m_trace.get(), built));
    m_track = std::make_shared<const PlaybackTrack>(std::move(built));
    return {};
}

void SessionView::keep(TraceAssembler& assembler, const ExerciseKind& kind) {
    scoring::SessionTrace trace;
    trace.exercise = m_setup.level.exercise;
    trace.forceLimit_N = m_record.setup.forceLimit_N;
    trace.plannedTrials = m_record.setup.plannedTrials;
    trace.trials = assembler.takeTrials();
    if (m_setup.scoring == ScoringRule::finishedTrials && assembler.lastIsCutOff() && !trace.trials.empty())
        trace.trials.back().unfinished = true;
    for (scoring::TrialTrace& trial : trace.trials)
        kind.addTruth(m_setup.level, m_setup.seed, trial);
    m_trace = std::make_shared<const scoring::SessionTrace>(std::move(trace));
}

core::Result<scoring::ScoreCard> SessionView::computeScores() {
    return computeScores(0);
}

core::Result<scoring::ScoreCard> SessionView::computeScores(int metricVersion) {
    const auto session = trace();
    CHIRON_TRY(session);
    const bool completed = m_record.summary.state == database::SessionState::completed ||
                           m_record.stateBeforeVoid == database::SessionState::completed;
    return scoresOf(**session, completed, metricVersion);
}

core::Result<scoring::ScoreCard> SessionView::scoresOf(const scoring::SessionTrace& trace, bool completed,
                                                       int metricVersion) const {
    std::vector<scoring::MetricRequest> requests;
    const auto& metrics = m_setup.level.metrics;
    const bool known = std::any_of(metrics.begin(), metrics.end(), [&](const auto& metric) {
        return scoring::findMetric(metric.id, metricVersion);
    });
    for (const catalogue::MetricChoice& metric : metrics) {
        int version = metricVersion > 0 ? metricVersion : metric.version;
        while (known && metricVersion > 0 && version > 1 && !scoring::findMetric(metric.id, version))
            // A metric that did not change in a version keeps its older version number.
            --version;
        requests.push_back({metric.id, version});
    }
    return scoring::calculateScore(trace, requests, m_setup.level.gates, completed);
}

namespace {

bool sameMetrics(const std::vector<scoring::MetricValue>& a, const std::vector<scoring::MetricValue>& b) {
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool sameValue = a[i].value.has_value() == b[i].value.has_value() &&
                               (!a[i].value || std::bit_cast<std::uint64_t>(*a[i].value + 0.0) ==
                                                   std::bit_cast<std::uint64_t>(*b[i].value + 0.0));
        if (!sameValue || a[i].id != b[i].id || a[i].version != b[i].version || a[i].unit != b[i].unit ||
            a[i].passed != b[i].passed)
            return false;
    }
    return true;
}

} // namespace

bool sameScores(const scoring::ScoreCard& a, const scoring::ScoreCard& b) {
    if (a.passed != b.passed || a.trials.size() != b.trials.size() || !sameMetrics(a.metrics, b.metrics))
        return false;
    for (std::size_t i = 0; i < a.trials.size(); ++i) {
        if (!sameMetrics(a.trials[i], b.trials[i]))
            return false;
    }
    return true;
}

} // namespace chiron::session
