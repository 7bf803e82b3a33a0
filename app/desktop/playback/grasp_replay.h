// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laparoscopy_cues.h"
#include "session/playback_track.h"
#include "session/session_setup.h"
#include "simulation/exercises/elastic_tube/elastic_tube_plan.h"
#include "simulation/exercises/object_handling/object_handling_plan.h"

#include <optional>
#include <vector>

namespace chiron::desktop {

/// The scene of a grasping exercise at any moment of a recording: from the recorded quantities, the tools' poses and the truth of
/// each trial (planned again from content and seed). Everything is shown, whatever the level hid. Immutable; any thread.
class GraspReplay {
public:
    /// Of the session's level; nothing where it does not grasp.
    static std::optional<GraspReplay> of(const session::SessionSetup& setup);

    /// What was there at a moment of the track; not present between trials.
    core::LaparoscopyCues cuesAt(const session::PlaybackTrack& track, const session::PlaybackView& view) const;

    /// The target tension of a trial and its half width, N; 0 where the task has none.
    struct Band {
        double low_N = 0.0;
        double high_N = 0.0;
    };
    Band bandOf(int trial) const;
    Band retractionBand() const { return m_tube && m_tube->hasFold() ? Band{m_tube->retractionLow_N, m_tube->retractionHigh_N} : Band{}; }
    double squeezeLimit_N() const { return m_handling ? m_handling->squeezeLimit_N : 0.0; }

private:
    void fillTube(const session::PlaybackTrack& track, const session::PlaybackView& view, core::LaparoscopyCues& cues) const;
    void fillFold(const session::PlaybackTrack& track, const session::PlaybackView& view, core::LaparoscopyCues& cues) const;
    void fillObjects(const session::PlaybackTrack& track, const session::PlaybackView& view, core::LaparoscopyCues& cues) const;

    std::optional<simulation::ElasticTubeParameters> m_tube;
    std::optional<simulation::ObjectHandlingParameters> m_handling;
    std::vector<simulation::ElasticTubeTrial> m_tubeTrials;
    std::vector<simulation::ObjectHandlingTrial> m_handlingTrials;
};

} // namespace chiron::desktop
