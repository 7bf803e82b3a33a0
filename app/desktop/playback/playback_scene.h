// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/playback/playback_layer.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "desktop/theme/theme.h"
#include "session/playback_track.h"
#include "session/session_setup.h"

namespace chiron::desktop {

/// The scene of a playback. It shows everything, including what the level hid during training.
scene3d::SceneSetup sceneSetupOf(const session::SessionSetup& setup, double forceLimit_N, const Theme& theme);

/// The state of the scene at a moment of the recording. `ghost` and `layer` (of the track's exercise) may be
/// null.
scene3d::SceneState sceneStateAt(const session::PlaybackTrack& track, const session::PlaybackTrack* ghost,
                                 double t_s, PlaybackLayer* layer = nullptr);

} // namespace chiron::desktop
