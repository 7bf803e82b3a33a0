// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/track_builder.h"

#include "core/contact_bits.h"
#include "session/level_limits.h"
#include "session/session_view.h"
#include "session/trace_mark.h"
#include "session/yield_cause.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

namespace {

constexpr double kContact_N = 0.02;

bool countsErrors(const catalogue::ExerciseLevel& level) {
    return std::any_of(level.metrics.begin(), level.metrics.end(),
                       [](const catalogue::MetricChoice& metric) { return metric.id == "critical_errors"; });
}

double normOf(const core::Array6& wrench) {
    return std::hypot(wrench[0], wrench[1], wrench[2]);
}

} // namespace

TrackBuilder::TrackBuilder(SessionView& session, const TrialSurfaces& surfaces,
                           std::span<const SceneEvent> sceneEvents)
    : m_quantities(session.reader().table()), m_positions(session.positions()), m_surfaces(surfaces),
      m_marks(session.record().setup.forceLimit_N, session.positions().tools(), session.record().setup.felt,
              yieldLawOf(session.setup().level), &session.positions(), sceneEvents,
              countsErrors(session.setup().level)) {
    m_track.session = session.record().summary.id;
    m_track.exercise = session.setup().level.exercise;
    m_track.level = session.setup().level.number;
    m_track.felt = session.record().setup.felt;
    m_track.forceLimit_N =
        std::min(session.record().setup.forceLimit_N, levelLimits(session.setup().level).force_N);
    m_track.toolCount = m_positions.tools();
    m_open.resize(static_cast<std::size_t>(m_track.toolCount));
    for (const RecordedQuantities::Quantity& quantity : m_quantities.list())
        m_track.quantities.push_back({quantity.id, quantity.unit, {}});
}

void TrackBuilder::add(std::span<const core::HapticFrame> frames) {
    for (const core::HapticFrame& frame : frames)
        add(frame);
}

void TrackBuilder::add(const core::HapticFrame& frame) {
    // A sample never extends across the ends of a trial, so that a trial's samples contain exactly what its
    // metrics use.
    if ((frame.header.events & core::event_bits::kTrialStarted) && m_inSample > 0)
        closeSample();
    // A device whose clock stops or steps back adds no time, so that playback time never decreases.
    m_now_s = std::max(m_now_s, m_time.at(frame));
    m_marks.add(frame, m_now_s);
    addTrial(frame);
    addPause(frame.header.paused != 0);
    for (std::size_t i = 0; i < m_open.size(); ++i)
        addForces(m_open[i], frame.tool[i]);
    m_last = frame;
    const bool event = (frame.header.events & kTrialEnds) != 0;
    if (++m_inSample >= PlaybackTrack::kTicksPerSample || event)
        closeSample();
}

PlaybackTrack TrackBuilder::take() {
    if (m_inSample > 0)
        closeSample();
    m_track.duration_s = m_now_s;
    m_track.marks = m_marks.take(m_now_s);
    addSpeeds();
    return std::move(m_track);
}

void TrackBuilder::addForces(PlaybackTool& tool, const core::ToolFrame& frame) {
    const core::Vec3 tissue(frame.tissue[0], frame.tissue[1], frame.tissue[2]);
    if (tissue.squaredNorm() > tool.tissue_N.squaredNorm())
        tool.tissue_N = tissue;
    tool.commanded_N = std::max(tool.commanded_N, normOf(frame.commanded));
    if (frame.status & core::sample_status::kMeasuredForce) {
        tool.measured_N = std::max(tool.measured_N, normOf(frame.measured));
        m_track.measures = true;
    }
}

/// Any reason for a stopped clock counts: a pause, a stop, a fault.
void TrackBuilder::addPause(bool paused) {
    if (paused && !m_paused)
        m_track.paused.push_back({m_now_s, m_now_s});
    if (paused || m_paused)
        m_track.paused.back().end_s = m_now_s;
    m_paused = paused;
}

/// Adds the open sample to the track with the last frame's pose; if no time has passed since the previous
/// sample, it stays open.
void TrackBuilder::closeSample() {
    if (!m_track.moments.empty() && m_now_s <= m_track.moments.back().t_s)
        return;
    const core::TickHeader& header = m_last.header;
    m_track.moments.push_back(
        {m_now_s, header.index, header.trial, header.phase, header.force, header.paused != 0});
    for (std::size_t i = 0; i < m_quantities.size(); ++i)
        m_track.quantities[i].values.push_back(m_quantities.value(i, m_last));
    const bool present = header.phase == core::TrialPhase::ready || header.phase == core::TrialPhase::running;
    for (std::size_t i = 0; i < m_open.size(); ++i) {
        const core::ToolState pose = m_positions.pose(static_cast<int>(i), m_last.tool[i]);
        PlaybackTool& tool = m_open[i];
        tool.p_WT = pose.p_WT;
        tool.q_WT = pose.q_WT;
        tool.jaw_rad = pose.jaw_rad;
        // No surface holds the tool.
        const bool through = core::contactOfStatus(m_last.tool[i].status) & core::contact_bits::kThrough;
        tool.p_WProxy = present && !through ? m_surfaces.surfacePoint(header.trial, pose.p_WT) : pose.p_WT;
        m_track.tools.push_back(tool);
        tool = {};
    }
    m_inSample = 0;
}

void TrackBuilder::addTrial(const core::HapticFrame& frame) {
    using namespace core::event_bits;
    if (frame.header.events & kTrialStarted) {
        PlaybackTrial trial;
        trial.index = frame.header.trial;
        trial.start_s = m_now_s;
        trial.object = m_surfaces.object(trial.index);
        m_track.trials.push_back(trial);
        m_inTrial = true;
    }
    if (!m_inTrial)
        return;
    PlaybackTrial& trial = m_track.trials.back();
    trial.end_s = m_now_s;
    trial.p_WEnd = m_positions.p_WT_m(0, frame.tool[0]);
    if (frame.header.events & kTrialEnds) {
        trial.marked = (frame.header.events & kMarked) != 0 && !isMarkOfTraceEnd(frame);
        trial.completed = (frame.header.events & kCompleted) != 0;
        trial.timedOut = (frame.header.events & kTimedOut) != 0;
        trial.failed = (frame.header.events & kFailed) != 0;
        trial.endedInContact = normOf(frame.tool[0].tissue) > kContact_N;
        m_inTrial = false;
    }
}

/// Central differences over 40 ms: the speed that a person would perceive, without the encoder's steps.
void TrackBuilder::addSpeeds() {
    constexpr std::size_t kHalf = 5;
    const std::size_t n = m_track.moments.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t a = i >= kHalf ? i - kHalf : 0;
        const std::size_t b = std::min(i + kHalf, n - 1);
        const double dt_s = m_track.moments[b].t_s - m_track.moments[a].t_s;
        for (int k = 0; k < m_track.toolCount; ++k) {
            const double d_m = (m_track.tool(b, k).p_WT - m_track.tool(a, k).p_WT).norm();
            auto& tool =
                m_track.tools[i * static_cast<std::size_t>(m_track.toolCount) + static_cast<std::size_t>(k)];
            tool.speed_m_per_s = dt_s > 0.0 ? d_m / dt_s : 0.0;
        }
    }
}

} // namespace chiron::session
