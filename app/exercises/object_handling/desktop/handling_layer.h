// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"
#include "curriculum/exercises/object_handling/scoring/handling_truth.h"
#include "desktop/playback/playback_layer.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::desktop {

/// The playback of object handling: the positions of the objects and the grip on one of them at any moment,
/// from the recorded quantities, the jaw and the truth of each trial (planned again from content and seed),
/// and the plots of the squeeze with its limit and of the energy balance. Shows everything, including what
/// the level hid.
class HandlingLayer final : public PlaybackLayer {
public:
    HandlingLayer(const simulation::ObjectHandlingParameters& level, std::uint64_t seed);

    /// The state of the objects at a moment of the track; not present between trials.
    core::LaparoscopyCues cuesAt(const session::PlaybackTrack& track,
                                 const session::PlaybackView& view) const;

    void showIn(scene3d::SceneState& state, const session::PlaybackTrack& track,
                const session::PlaybackView& view, double t_s) override;
    QString readout(const session::PlaybackTrack& track, const session::PlaybackView& view, double t_s,
                    const QLocale& locale) const override;
    void addPlots(PlaybackPlots& plots) const override;

private:
    void fillObjects(const session::PlaybackTrack& track, const session::PlaybackView& view,
                     core::LaparoscopyCues& cues) const;

    simulation::ObjectHandlingParameters m_level;
    std::vector<scoring::HandlingTruth> m_truths; ///< one per trial
};

} // namespace chiron::desktop
