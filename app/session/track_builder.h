// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "session/device_time.h"
#include "session/playback_mark.h"
#include "session/playback_track.h"
#include "session/recorded_quantities.h"
#include "session/tool_positions.h"
#include "session/trial_surfaces.h"

#include <span>
#include <vector>

namespace chiron::session {

class SessionView;

/// Accumulates the frames of a recording, in order, into the samples, trials and marks of a track. A session
/// without frames gives an empty track. Marks that need the whole trial are added afterwards
/// (ExerciseKind::addMarks).
class TrackBuilder {
public:
    /// `surfaces`: the geometry that could be touched in each trial. It must outlive the builder, as must the
    /// view. `sceneEvents`: those of the exercise.
    TrackBuilder(SessionView& session, const TrialSurfaces& surfaces,
                 std::span<const SceneEvent> sceneEvents);
    void add(std::span<const core::HapticFrame> frames);
    PlaybackTrack take();

private:
    void add(const core::HapticFrame& frame);
    void addForces(PlaybackTool& tool, const core::ToolFrame& frame);
    void addPause(bool paused);
    void closeSample();
    void addTrial(const core::HapticFrame& frame);
    void addSpeeds();

    RecordedQuantities m_quantities;
    const ToolPositions& m_positions;
    const TrialSurfaces& m_surfaces;
    MarkExtractor m_marks;
    PlaybackTrack m_track;
    std::vector<PlaybackTool> m_open; ///< the sample that is being accumulated
    core::HapticFrame m_last;
    int m_inSample = 0;
    bool m_inTrial = false;
    bool m_paused = false;
    DeviceTime m_time;
    double m_now_s = 0.0;
};

} // namespace chiron::session
