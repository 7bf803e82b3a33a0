// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/playback_scene.h"

#include "cues/laparoscopy_cues.h"
#include "session/playback_ghost.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

scene3d::ToolView viewOf(const session::PlaybackTool& tool, bool felt) {
    scene3d::ToolView view;
    view.present = true;
    view.p_WT = tool.p_WT;
    view.p_WProxy = tool.p_WProxy;
    view.q_WT = tool.q_WT;
    view.force_N = tool.tissue_N;
    view.jaw_rad = tool.jaw_rad;
    view.drawnAtSurface = !felt;
    return view;
}

} // namespace

scene3d::SceneSetup sceneSetupOf(const session::SessionSetup& setup, double forceLimit_N,
                                 const Theme& theme) {
    scene3d::SceneSetup scene;
    scene.exercise = setup.level.exercise;
    scene.parameters = setup.level.parameters;
    scene.forceLimit_N = forceLimit_N;
    scene.cues.tool = true;
    scene.cues.arrow = true;
    scene.cues.overview = true;
    scene.cues.guidance = true;
    scene.colours.background = theme.color(Colour::sceneBackground);
    scene.colours.field = theme.color(Colour::sceneField);
    scene.colours.ink = theme.color(Colour::text);
    scene.colours.arrow = theme.color(Colour::accent);
    scene.colours.over = theme.color(Colour::bad);
    scene.colours.stop = theme.color(Colour::danger);
    scene.colours.ghost = theme.color(Colour::ghost);
    scene.colours.highContrast = theme.name() == ThemeName::highContrast;
    scene.leftHanded = !setup.mappings.empty() && setup.mappings.front().leftHanded;
    scene.scale = theme.scale();
    scene.family = theme.font(TextStyle::body).family();
    return scene;
}

scene3d::SceneState sceneStateAt(const session::PlaybackTrack& track, const session::PlaybackTrack* ghost,
                                 double t_s, PlaybackLayer* layer) {
    scene3d::SceneState state;
    const session::PlaybackView view = track.at(t_s);
    state.time_s = t_s;
    for (std::size_t i = 0; i < std::min(view.tools.size(), state.tool.size()); ++i)
        state.tool[i] = viewOf(view.tools[i], track.felt);
    if (view.object) {
        state.objectShown = true;
        state.p_WObject = view.object->p_WObject;
        state.exercise.own<core::LaparoscopyCues>().body[0].q_W = {
            std::cos(0.5 * view.object->turn_rad), 0.0, 0.0, std::sin(0.5 * view.object->turn_rad)};
        state.dimpleShown = view.object->dimpleCentre_m.has_value();
        state.dimpleCentre_m = view.object->dimpleCentre_m.value_or(core::Vec2::Zero());
    }
    const session::PlaybackTrial* trial = track.trial(view.moment.trial);
    if (trial && trial->marked && t_s >= trial->end_s) {
        state.marked = true;
        state.p_WMark = trial->p_WEnd;
    }
    for (const session::PlaybackMark& mark : track.marks)
        if (mark.p_W && mark.trial == static_cast<int>(view.moment.trial) && mark.t_s <= t_s)
            state.p_WYielded.push_back(*mark.p_W);
    if (layer)
        layer->showIn(state, track, view, t_s);
    if (ghost) {
        if (const auto found = session::ghostAt(track, *ghost, t_s))
            state.ghost = viewOf(found->tool, ghost->felt);
    }
    return state;
}

} // namespace chiron::desktop
