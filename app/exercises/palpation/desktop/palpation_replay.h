// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/session/palpation_presses.h"
#include "app/exercises/palpation/session/palpation_record.h"
#include "desktop/scene3d/scene_state.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "session/playback_track.h"

#include <memory>
#include <optional>
#include <vector>

namespace chiron::desktop {

/// The display options of a palpation in playback.
struct PalpationLook {
    bool truth = true;       ///< show the lumps and the outcomes of the findings
    bool wholeTrial = false; ///< show the map of the whole trial instead of the map up to this moment
    simulation::SurfaceMapKind map = simulation::SurfaceMapKind::coverage;
};

/// The findings and the searched surface at any moment of a recorded palpation, with the truth. The maps
/// follow the track's samples and are extended incrementally during playback.
/// Thread: GUI after construction.
class PalpationReplay {
public:
    PalpationReplay(simulation::PalpationParameters level,
                    std::vector<session::PalpationTrialRecord> records);

    const session::PalpationTrialRecord* record(int trial) const; ///< null: no such trial was started
    /// The cues at a moment as the training screen would show them with every cue on; with `truth`, also the
    /// lumps.
    simulation::PalpationCues cuesAt(const session::PlaybackTrack& track, double t_s, bool truth) const;
    /// Adds the same to the scene; the map stays valid until the next call.
    void showIn(scene3d::SceneState& state, const session::PlaybackTrack& track, double t_s,
                const PalpationLook& look);
    const simulation::PalpationParameters& level() const { return m_level; }

private:
    void addTruth(const session::PalpationTrialRecord& record, simulation::PalpationCues& cues) const;
    static void addOutcomes(const session::PalpationTrialRecord& record, scene3d::SceneState& state);
    const simulation::SurfaceMap& mapAt(const session::PlaybackTrack& track, int trial, double t_s);

    simulation::PalpationParameters m_level;
    simulation::TissueSurface m_surface;
    std::vector<session::PalpationTrialRecord> m_records;
    // The incremental map: the trial to which it belongs, and how many of the track's moments it contains.
    std::optional<session::PalpationPresses> m_presses;
    int m_trial = -1;
    std::size_t m_next = 0;
    std::uint32_t m_shown = 0; ///< incremented whenever another map is shown
    const void* m_last = nullptr;
    std::uint32_t m_lastStep = 0;
};

} // namespace chiron::desktop
