// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/playback/playback_layer.h"

namespace chiron::desktop {

/// The playback of an endoscope: its picture, the stage of the procedure, and its distance from the canal's
/// centre-line.
class InsertionLayer final : public PlaybackLayer {
public:
    /// `depthOfField`: as set by the level.
    explicit InsertionLayer(bool depthOfField) : m_depthOfField(depthOfField) {}

    std::vector<PlaybackSwitch> switches() const override;
    void turn(std::string_view key, bool on) override;
    void setUp(scene3d::SceneSetup& setup) const override;
    void showIn(scene3d::SceneState& state, const session::PlaybackTrack& track,
                const session::PlaybackView& view, double t_s) override;
    QString readout(const session::PlaybackTrack& track, const session::PlaybackView& view, double t_s,
                    const QLocale& locale) const override;
    void addPlots(PlaybackPlots& plots) const override;

private:
    bool m_depthOfField;
};

} // namespace chiron::desktop
