// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/desktop/palpation_replay.h"
#include "desktop/playback/playback_layer.h"

#include <optional>

namespace chiron::desktop {

/// A palpation played back: lumps, findings and maps, how they are looked at, and how the fingers leaned.
class PalpationLayer final : public PlaybackLayer {
public:
    explicit PalpationLayer(PalpationReplay replay) : m_replay(std::move(replay)) {}
    /// Where what was found cannot be told: movement and force do not depend on it.
    explicit PalpationLayer(core::Error why) : m_why(std::move(why)) {}

    PalpationReplay* replay() { return m_replay ? &*m_replay : nullptr; } ///< null where it cannot be told

    QString lost() const override;
    std::vector<PlaybackSwitch> switches() const override;
    void turn(std::string_view key, bool on) override;
    void showIn(scene3d::SceneState& state, const session::PlaybackTrack& track, const session::PlaybackView& view, double t_s) override;
    QString readout(const session::PlaybackTrack& track, const session::PlaybackView& view, double t_s,
                    const QLocale& locale) const override;
    void addPlots(PlaybackPlots& plots) const override;

private:
    std::optional<PalpationReplay> m_replay;
    std::optional<core::Error> m_why;
    PalpationLook m_look;
};

} // namespace chiron::desktop
