// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "session/playback_track.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <string_view>
#include <vector>

namespace chiron::desktop {

class PlaybackPlots;

/// Something of a playback that can be switched on and off.
struct PlaybackSwitch {
    const char* key; ///< in the screen's place; its box is called "playback.<key>"
    QString text;
    QString tip;
    bool on = false;        ///< unless the place says otherwise
    bool ofPicture = false; ///< of how the scene is drawn, so beside the readout; else of what is looked at, in a row of its own
};

/// What a playback shows of one exercise alone: in the scene, the readout and the plots. Made on a worker, then of the GUI thread.
class PlaybackLayer {
public:
    PlaybackLayer() = default;
    PlaybackLayer(const PlaybackLayer&) = delete;
    PlaybackLayer& operator=(const PlaybackLayer&) = delete;
    virtual ~PlaybackLayer() = default;

    /// Why not all of it can be shown, although the track holds; empty where it can.
    virtual QString lost() const { return {}; }
    virtual std::vector<PlaybackSwitch> switches() const { return {}; }
    /// `key`: of one of switches().
    virtual void turn(std::string_view /*key*/, bool /*on*/) {}
    /// How the scene is drawn, by the switches of the picture.
    virtual void setUp(scene3d::SceneSetup&) const {}
    /// Adds to what the scene shows at a moment of the track; what it points to stays valid until the next call.
    virtual void showIn(scene3d::SceneState&, const session::PlaybackTrack&, const session::PlaybackView&, double /*t_s*/) {}
    /// One line about a moment of the track.
    virtual QString readout(const session::PlaybackTrack& track, const session::PlaybackView& view, double t_s,
                            const QLocale& locale) const = 0;
    /// Adds its plots between those of force and speed, each time that all are drawn.
    virtual void addPlots(PlaybackPlots&) const {}
};

/// The translation context of what playback and its layers say.
struct PlaybackTexts {
    Q_DECLARE_TR_FUNCTIONS(chiron::desktop::PlaybackScreen)
};

/// Why nothing runs: empty while it does.
QString stillWords(const session::PlaybackMoment& moment);
/// "Trial 2 · force 1.20 N · speed 14.00 mm/s": what there is to say of every exercise that is done in trials.
QString trialReadout(const session::PlaybackView& view, const QLocale& locale);

} // namespace chiron::desktop
