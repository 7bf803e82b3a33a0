// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "desktop/theme/theme.h"
#include "desktop/playback/grasp_replay.h"
#include "session/playback_track.h"
#include "session/session_setup.h"

namespace chiron::desktop {

/// The scene of a playback: everything is shown, also what the level hid while it was trained.
scene3d::SceneSetup sceneSetupOf(const session::SessionSetup& setup, double forceLimit_N, const Theme& theme, bool depthOfField = false);

/// What the scene shows at a moment of the recording; `ghost` may be null. Pure.
scene3d::SceneState sceneStateAt(const session::PlaybackTrack& track, const session::PlaybackTrack* ghost, double t_s,
                                 const GraspReplay* grasp = nullptr);

} // namespace chiron::desktop
