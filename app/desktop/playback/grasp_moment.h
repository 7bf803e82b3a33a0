// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/scene_state.h"
#include "report/report_data.h"
#include "session/playback_track.h"

#include <QLocale>
#include <QString>
#include <array>
#include <string>

namespace chiron::desktop {

class PlaybackPlots;

// Shared by the playbacks of exercises in which something is grasped.

/// The value of a named quantity at the moment; 0 if it was not recorded.
double quantityAt(const session::PlaybackTrack& track, const session::PlaybackView& view,
                  const std::string& id);
/// A position in W, from the three quantities "<name>_x_m" and so on.
std::array<double, 3> placeAt(const session::PlaybackTrack& track, const session::PlaybackView& view,
                              const std::string& name);
/// Whether the object was present, the step of the task and the fraction of the step that was done; not
/// present between trials.
core::LaparoscopyCues graspCuesAt(const session::PlaybackTrack& track, const session::PlaybackView& view);
/// Puts the cues into the scene.
void showGrasp(scene3d::SceneState& state, const core::LaparoscopyCues& cues);
/// One line of text about a moment; `held` describes the grasp ("squeeze 1.20 N").
QString graspReadout(const session::PlaybackView& view, const QString& held, const QLocale& locale);
/// The time spans in which more energy is stored than was supplied, beyond the rounding of the recording;
/// each runs from the first to the last such sample. The three vectors have the same length.
/// Unit: s, J.
std::vector<report::TimeSpan> excessEnergy(const std::vector<double>& t_s, const std::vector<double>& in,
                                           const std::vector<double>& held);
/// Adds the plot of the energy balance: energy supplied and energy stored. Adds nothing if the energies were
/// not recorded.
void addEnergyPlot(PlaybackPlots& plots);

} // namespace chiron::desktop
