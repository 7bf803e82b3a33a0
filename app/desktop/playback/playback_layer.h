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

/// A part of a playback that can be switched on and off.
struct PlaybackSwitch {
    const char* key; ///< parameter of the screen's place; the check box is named "playback.<key>"
    QString text;
    QString tip;
    bool on = false; ///< default, if the place does not say
    /// Concerns how the scene is drawn, so the box stands beside the readout; otherwise it concerns what is
    /// examined and stands in its own row.
    bool ofPicture = false;
};

/// The part of a playback that is specific to one exercise: in the scene, the readout and the plots.
/// Thread: constructed on a worker, then used on the GUI thread.
class PlaybackLayer {
public:
    PlaybackLayer() = default;
    PlaybackLayer(const PlaybackLayer&) = delete;
    PlaybackLayer& operator=(const PlaybackLayer&) = delete;
    virtual ~PlaybackLayer() = default;

    /// Why not all of it can be shown although the track is intact; empty if all of it can.
    virtual QString lost() const { return {}; }
    virtual std::vector<PlaybackSwitch> switches() const { return {}; }
    /// `key` is the key of one of switches().
    virtual void turn(std::string_view /*key*/, bool /*on*/) {}
    /// Sets how the scene is drawn, according to the switches.
    virtual void setUp(scene3d::SceneSetup&) const {}
    /// Adds to the scene what it shows at a moment of the track. What the state points to stays valid until
    /// the next call.
    virtual void showIn(scene3d::SceneState&, const session::PlaybackTrack&, const session::PlaybackView&,
                        double /*t_s*/) {}
    /// One line of text about a moment of the track.
    virtual QString readout(const session::PlaybackTrack& track, const session::PlaybackView& view,
                            double t_s, const QLocale& locale) const = 0;
    /// Adds the layer's plots between those of force and speed. It is called each time all plots are drawn.
    virtual void addPlots(PlaybackPlots&) const {}
};

/// The translation context for the texts of playback and its layers.
struct PlaybackTexts {
    Q_DECLARE_TR_FUNCTIONS(chiron::desktop::PlaybackScreen)
};

/// Why time stands still in the exercise; empty while it runs.
QString stillWords(const session::PlaybackMoment& moment);
/// "Trial 2 · force 1.20 N · speed 14.00 mm/s": the readout for any exercise that consists of trials.
QString trialReadout(const session::PlaybackView& view, const QLocale& locale);

} // namespace chiron::desktop
