// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/drawn_tool.h"
#include "gui/scene3d/scene_samples.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "simulation/comparison/comparison_parameters.h"

namespace chiron::scene3d::samples {

inline SceneSetup tubeSetup(simulation::TubeTask task = simulation::TubeTask::hold) {
    SceneSetup setup;
    setup.exercise = "elastic_tube";
    simulation::ElasticTubeParameters parameters;
    parameters.task = task;
    setup.parameters = parameters;
    setup.cues = {true, true};
    setup.family = QStringLiteral("Inter");
    return setup;
}

inline SceneSetup handlingSetup() {
    SceneSetup setup;
    setup.exercise = "object_handling";
    setup.parameters = simulation::ObjectHandlingParameters{};
    setup.cues = {true, true};
    setup.family = QStringLiteral("Inter");
    return setup;
}

/// Objects of a study side by side: tubes and weights are taken hold of by a hook, pads are pressed.
inline SceneSetup comparisonSetup(simulation::ComparedAttribute attribute) {
    SceneSetup setup = handlingSetup();
    setup.exercise = "comparison";
    simulation::ComparisonParameters parameters;
    parameters.attribute = attribute;
    setup.parameters = parameters;
    return setup;
}

/// A grasper whose tip is here, its shaft through an entry point of its own.
inline ToolView grasper(const core::Vec3& p_WT, bool left, double jaw_rad) {
    ToolView tool;
    tool.present = true;
    tool.p_WT = tool.p_WProxy = p_WT;
    tool.q_WT = DrawnOrientation::throughEntry(p_WT, left);
    tool.jaw_rad = jaw_rad;
    return tool;
}

/// A tube from the floor to `end`, held there or lying.
inline SceneState tubeState(const core::Vec3& end, bool held) {
    SceneState state;
    core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
    cues.present = cues.objectShown = cues.tube = cues.tensionShown = true;
    cues.step = held ? core::LaparoscopyStep::hold : core::LaparoscopyStep::grasp;
    cues.grips = 2;
    cues.restLength_m = 0.045;
    cues.gripAt = {0.0, 1.0, 0.0};
    cues.gripAnchored[0] = true;
    cues.gripHeldBy[1] = held ? 1 : 0;
    cues.p_WGrip[0] = {-0.006, 0.004, 0.0};
    cues.p_WGrip[1] = {end.x(), end.y(), end.z()};
    const core::Vec3 base(-0.006, 0.004, 0.0);
    cues.stretch_m = std::max(0.0, (end - base).norm() - cues.restLength_m);
    cues.tension_N = 60.0 * cues.stretch_m;
    cues.bandLow_N = 1.05;
    cues.bandHigh_N = 1.35;
    cues.dwell = held ? 0.4 : 0.0;
    state.objectShown = true;
    state.tool[0] = grasper(held ? end : core::Vec3(0.030, -0.020, 0.040), false, held ? 0.10 : 0.7);
    if (held)
        state.tool[0].force_N = cues.tension_N * (base - end).normalized();
    return state;
}

/// The tube between two graspers.
inline SceneState twoHanded(double apart_m) {
    SceneState state = tubeState({0.5 * apart_m, 0.0, 0.042}, true);
    core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
    const core::Vec3 left(-0.5 * apart_m, 0.006, 0.038);
    cues.gripAnchored[0] = false;
    cues.gripHeldBy = {2, 1, 0};
    cues.p_WGrip[0] = {left.x(), left.y(), left.z()};
    cues.stretch_m = std::max(0.0, apart_m - cues.restLength_m);
    cues.tension_N = 60.0 * cues.stretch_m;
    state.tool[1] = grasper(left, true, 0.10);
    state.tool[0].force_N = {-cues.tension_N, 0.0, 0.0};
    state.tool[1].force_N = {cues.tension_N, 0.0, 0.0};
    state.activeTool = 0;
    return state;
}

/// A fold of tissue over the tube, hanging, or drawn back by a third instrument while two hold the tube.
inline SceneState behindAFold(bool back) {
    SceneState state = twoHanded(back ? 0.060 : 0.045);
    core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
    cues.fold = cues.retractionShown = true;
    cues.foldOpen = back;
    cues.foldHeldBy = back ? 4 : 0;
    cues.p_WFoldBase = {0.0, -0.004, 0.0};
    cues.p_WFoldEdge =
        back ? std::array<double, 3>{0.0, 0.030, 0.026} : std::array<double, 3>{0.0, -0.004, 0.010};
    cues.retraction_N = back ? 0.8 : 0.0;
    cues.retractionLow_N = 0.6;
    cues.retractionHigh_N = 1.0;
    if (!back) {
        cues.gripHeldBy = {0, 0, 0};
        cues.p_WGrip[0] = {-0.0225, 0.0, 0.003};
        cues.p_WGrip[1] = {0.0225, 0.0, 0.003};
        state.tool[0] = grasper({0.045, 0.0, 0.050}, false, 0.7);
        state.tool[1] = grasper({-0.045, 0.0, 0.050}, true, 0.7);
    }
    state.tool[2] = grasper(back ? core::Vec3(0.0, 0.030, 0.026) : core::Vec3(0.0, 0.020, 0.050), false,
                            back ? 0.08 : 0.7);
    return state;
}

/// The free end on its way from the right instrument to the left one.
inline SceneState handOver() {
    SceneState state = tubeState({0.022, -0.010, 0.036}, true);
    core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
    cues.step = core::LaparoscopyStep::handOver;
    cues.grips = 3;
    cues.gripAt = {0.0, 0.78, 1.0};
    cues.gripHeldBy = {0, 2, 1};
    cues.p_WGrip[1] = {0.012, -0.004, 0.032};
    cues.p_WGrip[2] = {0.022, -0.010, 0.036};
    cues.targetShown = true;
    cues.p_WTarget = {-0.035, 0.0, 0.045};
    cues.targetRadius_m = 0.008;
    cues.bandLow_N = cues.bandHigh_N = 0.0;
    state.tool[1] = grasper({0.012, -0.004, 0.032}, true, 0.12);
    state.activeTool = 1;
    return state;
}

/// Three ovaries and their dish; `held`: one of them is carried.
/// Three places in a row, of which the middle one is touched.
inline SceneState comparisonState(double height_m) {
    SceneState state;
    core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
    cues.present = cues.objectShown = true;
    cues.bodies = 3;
    for (std::size_t i = 0; i < 3; ++i) {
        cues.body[i].p_W = {0.040 * (static_cast<double>(i) - 1.0), 0.0, height_m};
        cues.body[i].radius_m = 0.009;
    }
    cues.body[1].heldBy = 1;
    state.objectShown = true;
    state.tool[0] = grasper({0.004, -0.003, height_m + 0.006}, false, 0.0);
    return state;
}

inline SceneState handlingState(bool held) {
    SceneState state;
    core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
    cues.present = cues.objectShown = cues.squeezeShown = true;
    cues.step = held ? core::LaparoscopyStep::carry : core::LaparoscopyStep::grasp;
    cues.bodies = 3;
    const double r = 0.011;
    const std::array<core::Vec3, 3> at{core::Vec3(-0.030, 0.016, r), core::Vec3(0.004, 0.030, r),
                                       core::Vec3(0.034, 0.010, r)};
    for (std::size_t i = 0; i < 3; ++i) {
        cues.body[i].p_W = {at[i].x(), at[i].y(), at[i].z()};
        cues.body[i].radius_m = r;
    }
    cues.targetShown = true;
    cues.p_WTarget = {0.004, -0.026, 0.0};
    cues.targetRadius_m = 0.014;
    cues.squeezeLimit_N = 2.0;
    state.objectShown = true;
    const core::Vec3 tip = held ? core::Vec3(0.016, 0.002, 0.034) : core::Vec3(0.040, -0.020, 0.034);
    state.tool[0] = grasper(tip, false, held ? 0.98 : 1.1);
    if (held) {
        cues.body[1].p_W = {tip.x(), tip.y(), tip.z()};
        cues.body[1].heldBy = 1;
        cues.body[1].squeeze_m = 0.0035;
        cues.squeeze_N[0] = 1.3;
        cues.dwell = 0.35;
        state.tool[0].force_N = {0.0, 0.0, -0.1};
    }
    return state;
}

} // namespace chiron::scene3d::samples
