// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::desktop {

class PlaybackPlots;

/// Adds the plots of the inclination of the force and of the fingers' depth over time, if these were
/// recorded.
void addPalpationPlots(PlaybackPlots& plots);

} // namespace chiron::desktop
