// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/scene_feed.h"

#include "desktop/exercise_face.h"
#include "session/level_limits.h"

namespace chiron::desktop {

namespace {

core::Vec3 vectorOf(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

scene3d::ToolView toolOf(const haptics::ToolDisplay& shown, const session::LevelCues& cues) {
    scene3d::ToolView tool;
    tool.present = cues.tool;
    tool.p_WT = vectorOf(shown.p_WT_m);
    tool.p_WProxy = vectorOf(shown.p_WProxy_m);
    tool.q_WT = core::Quat(shown.q_WT[0], shown.q_WT[1], shown.q_WT[2], shown.q_WT[3]);
    tool.force_N = core::toWrench(shown.tissue).force;
    tool.jaw_rad = shown.jaw_rad;
    tool.drawnAtSurface = !shown.rendersForce;
    return tool;
}

} // namespace

scene3d::SceneSetup sceneSetupOf(const catalogue::ExerciseLevel& level, const session::LevelCues& cues,
                                 const Theme& theme, bool leftHanded, std::optional<bool> depthOfField) {
    scene3d::SceneSetup setup;
    setup.exercise = level.exercise;
    setup.parameters = level.parameters;
    setup.forceLimit_N = session::levelLimits(level).force_N;
    setup.cues = {.tool = cues.tool,
                  .arrow = cues.arrow,
                  .object = cues.object,
                  .overview = cues.overview,
                  .guidance = cues.guidance};
    const auto face = exerciseFace(level.exercise);
    if (const auto optics = face ? (*face)->depthOfField(level) : std::nullopt)
        setup.depthOfField = optics->shown(depthOfField);
    setup.colours = {.background = theme.color(Colour::sceneBackground),
                     .field = theme.color(Colour::sceneField),
                     .ink = theme.color(Colour::text),
                     .arrow = theme.color(Colour::accent),
                     .over = theme.color(Colour::bad),
                     .stop = theme.color(Colour::danger),
                     .ghost = theme.color(Colour::ghost),
                     .highContrast = theme.name() == ThemeName::highContrast};
    setup.leftHanded = leftHanded;
    setup.scale = theme.scale();
    setup.family = theme.font(TextStyle::body).family();
    return setup;
}

scene3d::SceneState sceneStateOf(const haptics::DisplayState& shown, const session::LevelCues& cues,
                                 std::int64_t startedAt_ns) {
    scene3d::SceneState state;
    for (std::size_t i = 0; i < state.tool.size() && static_cast<int>(i) < shown.tools; ++i)
        state.tool[i] = toolOf(shown.tool[i], cues);
    state.objectShown = shown.objectShown && cues.object;
    state.p_WObject = vectorOf(shown.p_WObject_m);
    state.exercise = shown.exercise;
    state.time_s = static_cast<double>(shown.now_ns - startedAt_ns) * 1e-9;
    return state;
}

haptics::DisplayState withoutForce(haptics::DisplayState shown) {
    for (haptics::ToolDisplay& tool : shown.tool)
        tool.tissue = tool.commanded = tool.measured = {};
    return shown;
}

} // namespace chiron::desktop
