// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "desktop/theme/theme.h"
#include "haptics/display_state.h"
#include "session/level_cues.h"

#include <optional>

namespace chiron::desktop {

/// The scene setup of a level in a theme. `depthOfField` is the person's choice; a level with a fixed setting
/// ignores it.
scene3d::SceneSetup sceneSetupOf(const catalogue::ExerciseLevel& level, const session::LevelCues& cues,
                                 const Theme& theme, bool leftHanded, std::optional<bool> depthOfField = {});

/// The scene state for a tick, limited to what the level shows. `startedAt_ns`: now_ns of the first tick.
scene3d::SceneState sceneStateOf(const haptics::DisplayState& shown, const session::LevelCues& cues,
                                 std::int64_t startedAt_ns);

/// The same tick without force, because no force is shown while force is stopped.
haptics::DisplayState withoutForce(haptics::DisplayState shown);

} // namespace chiron::desktop
