// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/desktop/palpation_replay.h"
#include "desktop/playback/playback_layer.h"

#include <optional>

namespace chiron::desktop {

/// The playback of a palpation: lumps, findings and maps, the switches for them, and the inclination of the
/// fingers.
class PalpationLayer final : public PlaybackLayer {
public:
    explicit PalpationLayer(PalpationReplay replay) : m_replay(std::move(replay)) {}
    /// For a recording whose findings cannot be read; movement and force are still shown, because they do not
    /// depend on them.
    explicit PalpationLayer(core::Error why) : m_why(std::move(why)) {}

    /// Null if the findings could not be read.
    PalpationReplay* replay() { return m_replay ? &*m_replay : nullptr; }

    QString lost() const override;
    std::vector<PlaybackSwitch> switches() const override;
    void turn(std::string_view key, bool on) override;
    void showIn(scene3d::SceneState& state, const session::PlaybackTrack& track,
                const session::PlaybackView& view, double t_s) override;
    QString readout(const session::PlaybackTrack& track, const session::PlaybackView& view, double t_s,
                    const QLocale& locale) const override;
    void addPlots(PlaybackPlots& plots) const override;

private:
    std::optional<PalpationReplay> m_replay;
    std::optional<core::Error> m_why;
    PalpationLook m_look;
};

} // namespace chiron::desktop
