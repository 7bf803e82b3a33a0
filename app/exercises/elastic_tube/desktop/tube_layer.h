// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"
#include "curriculum/exercises/elastic_tube/scoring/tube_truth.h"
#include "desktop/playback/playback_layer.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"

#include <cstdint>
#include <vector>

namespace chiron::desktop {

/// The playback of an elastic tube: its position and grips at any moment, from the recorded quantities, the
/// tools' poses and the truth of each trial (planned again from content and seed), and the plots of its
/// tension with the band and of the energy balance. Shows everything, including what the level hid.
class TubeLayer final : public PlaybackLayer {
public:
    TubeLayer(const simulation::ElasticTubeParameters& level, std::uint64_t seed);

    /// The state of the tube at a moment of the track; not present between trials.
    core::LaparoscopyCues cuesAt(const session::PlaybackTrack& track,
                                 const session::PlaybackView& view) const;

    /// The range of the target tension of a trial, N; 0 if the task has none.
    struct Band {
        double low_N = 0.0;
        double high_N = 0.0;
    };
    Band bandOf(int trial) const;
    Band retractionBand() const {
        return m_level.hasFold() ? Band{m_level.retractionLow_N, m_level.retractionHigh_N} : Band{};
    }

    void showIn(scene3d::SceneState& state, const session::PlaybackTrack& track,
                const session::PlaybackView& view, double t_s) override;
    QString readout(const session::PlaybackTrack& track, const session::PlaybackView& view, double t_s,
                    const QLocale& locale) const override;
    void addPlots(PlaybackPlots& plots) const override;

private:
    void fillTube(const session::PlaybackTrack& track, const session::PlaybackView& view,
                  core::LaparoscopyCues& cues) const;
    void fillFold(const session::PlaybackTrack& track, const session::PlaybackView& view,
                  core::LaparoscopyCues& cues) const;
    void addTension(PlaybackPlots& plots) const;
    void addRetraction(PlaybackPlots& plots) const;

    simulation::ElasticTubeParameters m_level;
    std::vector<simulation::ElasticTubeTrial> m_trials;
    std::vector<scoring::TubeTruth> m_truths; ///< one per trial
};

} // namespace chiron::desktop
