// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laparoscopy_cues.h"
#include "desktop/scene3d/scene_state.h"
#include "report/report_data.h"
#include "session/playback_track.h"

#include <QLocale>
#include <QString>
#include <array>
#include <string>

namespace chiron::desktop {

class PlaybackPlots;

// What playbacks of exercises share in which something is grasped.

/// A quantity of the moment by its name; 0 where it was not recorded.
double quantityAt(const session::PlaybackTrack& track, const session::PlaybackView& view, const std::string& id);
/// A place of W, from the three quantities "<name>_x_m" and so on.
std::array<double, 3> placeAt(const session::PlaybackTrack& track, const session::PlaybackView& view, const std::string& name);
/// Whether the object was there, the step of the task and how much of it was done; not present between trials.
core::LaparoscopyCues graspCuesAt(const session::PlaybackTrack& track, const session::PlaybackView& view);
/// Puts them into the scene.
void showGrasp(scene3d::SceneState& state, const core::LaparoscopyCues& cues);
/// One line about a moment; `held`: with what the object is held ("squeeze 1.20 N").
QString graspReadout(const session::PlaybackView& view, const QString& held, const QLocale& locale);
/// Where more energy is held than was put in, beyond what recording rounds: from the first to the last such sample. J; all of one length.
std::vector<report::TimeSpan> excessEnergy(const std::vector<double>& t_s, const std::vector<double>& in, const std::vector<double>& held);
/// The books of energy: what was put in and what is held. None where they were not kept.
void addEnergyPlot(PlaybackPlots& plots);

} // namespace chiron::desktop
