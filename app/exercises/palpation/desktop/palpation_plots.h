// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::desktop {

class PlaybackPlots;

/// How far the force leaned and how deep the fingers were, over time. None where it was not recorded.
void addPalpationPlots(PlaybackPlots& plots);

} // namespace chiron::desktop
