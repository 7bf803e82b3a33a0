// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "desktop/scene3d/scene_state.h"
#include "app/exercises/palpation/session/palpation_presses.h"
#include "app/exercises/palpation/session/palpation_record.h"
#include "session/playback_track.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <memory>
#include <optional>
#include <vector>

namespace chiron::desktop {

/// How a palpation is looked at in playback.
struct PalpationLook {
    bool truth = true;      ///< lumps, and what became of the findings
    bool wholeTrial = false; ///< the map of the whole trial, not up to this moment
    simulation::SurfaceMapKind map = simulation::SurfaceMapKind::coverage;
};

/// What was found and searched at any moment of a recorded palpation, beside the truth. Maps follow the track's samples and go on
/// from where they were while the recording is played. GUI thread, once made.
class PalpationReplay {
public:
    PalpationReplay(simulation::PalpationParameters level, std::vector<session::PalpationTrialRecord> records);

    const session::PalpationTrialRecord* record(int trial) const; ///< null: no such trial was begun
    /// What is there at a moment, as the training screen would show it with every cue, and the truth as lumps where it is looked at.
    simulation::PalpationCues cuesAt(const session::PlaybackTrack& track, double t_s, bool truth) const;
    /// Puts it into the scene; its map stays valid until the next call.
    void showIn(scene3d::SceneState& state, const session::PlaybackTrack& track, double t_s, const PalpationLook& look);
    const simulation::PalpationParameters& level() const { return m_level; }

private:
    void addTruth(const session::PalpationTrialRecord& record, simulation::PalpationCues& cues) const;
    static void addOutcomes(const session::PalpationTrialRecord& record, scene3d::SceneState& state);
    const simulation::SurfaceMap& mapAt(const session::PlaybackTrack& track, int trial, double t_s);

    simulation::PalpationParameters m_level;
    simulation::TissueSurface m_surface;
    std::vector<session::PalpationTrialRecord> m_records;
    // The map that follows: of which trial, and how many of the track's moments are in it.
    std::optional<session::PalpationPresses> m_presses;
    int m_trial = -1;
    std::size_t m_next = 0;
    std::uint32_t m_shown = 0; ///< counts whenever another map is shown
    const void* m_last = nullptr;
    std::uint32_t m_lastStep = 0;
};

} // namespace chiron::desktop
