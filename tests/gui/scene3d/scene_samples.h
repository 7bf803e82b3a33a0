// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

#include <cmath>

namespace chiron::scene3d::samples {

inline SceneSetup setup() {
    SceneSetup setup;
    setup.exercise = "sphere_apex";
    simulation::SphereApexParameters parameters;
    parameters.dimpleDepth_m = 0.0015;
    setup.parameters = parameters;
    setup.cues = {true, true};
    setup.family = QStringLiteral("Inter");
    return setup;
}

inline SceneColours dark() {
    return {QColor(24, 29, 35),
            QColor(38, 62, 74),
            QColor(230, 236, 242),
            QColor(90, 190, 240),
            QColor(255, 110, 100),
            QColor(190, 160, 240),
            false};
}

inline SceneColours highContrast() {
    return {QColor(0, 0, 0),
            QColor(20, 20, 20),
            QColor(255, 255, 255),
            QColor(255, 255, 0),
            QColor(255, 80, 255),
            QColor(0, 255, 255),
            true};
}

/// The ball a little right of the middle, tool 0 above it in the air.
inline SceneState inAir() {
    SceneState state;
    state.objectShown = true;
    state.p_WObject = {0.012, 0.006, 0.0};
    state.tool[0].present = true;
    state.tool[0].p_WT = {-0.018, -0.016, 0.034};
    state.tool[0].p_WProxy = state.tool[0].p_WT;
    return state;
}

/// Tool 0 pressed into the ball by this force at 500 N/m, on the flank that faces the camera.
inline SceneState pressed(double force_N) {
    SceneState state = inAir();
    const core::Vec3 normal = core::Vec3(-0.35, -0.45, 0.82).normalized();
    const core::Vec3 surface = state.p_WObject + 0.020 * normal;
    state.tool[0].p_WProxy = surface;
    state.tool[0].p_WT = surface - force_N / 500.0 * normal;
    state.tool[0].force_N = force_N * normal;
    return state;
}

} // namespace chiron::scene3d::samples
