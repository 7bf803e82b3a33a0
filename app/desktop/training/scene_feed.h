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

/// What a scene is set up with for a level in a theme. `depthOfField`: as the person switched it; a level that fixes it
/// keeps its own.
scene3d::SceneSetup sceneSetupOf(const catalogue::ExerciseLevel& level, const session::LevelCues& cues, const Theme& theme,
                                 bool leftHanded, std::optional<bool> depthOfField = {});

/// What is drawn of a tick: only what the level lets be seen. `startedAt_ns`: now_ns of the first tick.
scene3d::SceneState sceneStateOf(const haptics::DisplayState& shown, const session::LevelCues& cues, std::int64_t startedAt_ns);

/// The same tick with nothing of its force: while force is stopped none is shown either.
haptics::DisplayState withoutForce(haptics::DisplayState shown);

} // namespace chiron::desktop
