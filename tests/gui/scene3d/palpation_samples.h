// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "core/units.h"
#include "gui/scene3d/scene_samples.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "simulation/palpation/surface_map.h"
#include "simulation/palpation/tissue_surface.h"

#include <cmath>

namespace chiron::scene3d::samples {

enum class Tissue { pad, prostate, breast };

/// Parameters as the levels have them, made by hand.
inline simulation::PalpationParameters palpationParameters(Tissue tissue) {
    simulation::PalpationParameters parameters;
    auto& shape = parameters.tissue.shape;
    if (tissue == Tissue::pad) {
        parameters.tissue.layers = {{"silicone", 1.0, 49e3}};
    } else if (tissue == Tissue::prostate) {
        shape.planeHeight_m = -0.004;
        shape.bumps = {{{-0.010, 0.0}, {0.020, 0.026}, 0.0, 0.006},
                       {{0.010, 0.0}, {0.020, 0.026}, 0.0, 0.006}};
        parameters.areaHalf_m = {0.028, 0.024};
    } else {
        parameters.tissue.layers = {{"fat", 0.010, 18e3}, {"gland", 1.0, 28e3}};
        parameters.tissue.regions = {{"areola", {0.0, 0.0}, {0.014, 0.014}, 0.0, 0.35}};
        shape.planeHeight_m = -0.022;
        shape.bumps = {{{0.0, 0.0}, {0.075, 0.075}, 0.0, 0.024}, {{0.0, 0.0}, {0.016, 0.016}, 0.0, 0.0008}};
        parameters.areaHalf_m = {0.045, 0.045};
        parameters.regionColumns = parameters.regionRows = 4;
    }
    return parameters;
}

inline SceneSetup palpationSetup(Tissue tissue, int hands = 1, int fingers = 1) {
    SceneSetup setup;
    setup.exercise = "palpation";
    simulation::PalpationParameters parameters = palpationParameters(tissue);
    parameters.hands = hands;
    parameters.fingers = fingers;
    setup.parameters = parameters;
    setup.cues = {true, true};
    setup.family = QStringLiteral("Inter");
    return setup;
}

/// A finger pressed so deep at (x, y), with this force along the normal and beside it.
inline void pressFinger(SceneState& state, const SceneSetup& setup, std::size_t tool, const core::Vec2& xy_m,
                        double depth_m, const core::Vec2& lateral_N = core::Vec2::Zero()) {
    const auto& parameters = setup.parameters.as<simulation::PalpationParameters>();
    const simulation::TissueSurface surface(parameters.tissue.shape);
    const core::Vec3 normal = surface.normalAt(xy_m);
    ToolView& view = state.tool[tool];
    view.present = true;
    view.p_WProxy = surface.pointAt(xy_m);
    view.p_WT = view.p_WProxy - depth_m * normal;
    view.force_N = 500.0 * std::max(0.0, depth_m) * normal + core::Vec3(lateral_N.x(), lateral_N.y(), 0.0);
    simulation::PalpationCues& cues = state.exercise.own<simulation::PalpationCues>();
    cues.present = cues.bandShown = true;
    cues.bandLow_N = parameters.bandLow_N;
    cues.bandHigh_N = parameters.bandHigh_N;
    cues.depth_m[tool] = std::max(0.0, depth_m);
    cues.lean_rad[tool] = depth_m > 0.0 ? std::atan2(lateral_N.norm(), 500.0 * depth_m) : 0.0;
    if (cues.lean_rad[tool] > 30.0 * core::kPi / 180.0)
        cues.leanSaturated |= static_cast<std::uint8_t>(1U << tool);
}

inline void addFinding(SceneState& state, const SceneSetup& setup, std::size_t i, const core::Vec2& xy_m,
                       simulation::FindingOutcome outcome) {
    const core::Vec3 p =
        simulation::TissueSurface(setup.parameters.as<simulation::PalpationParameters>().tissue.shape)
            .pointAt(xy_m);
    state.exercise.own<simulation::PalpationCues>().present = true;
    state.exercise.own<simulation::PalpationCues>().finding[i] = {true, {p.x(), p.y(), p.z()}, 0.006, 4, 3};
    state.exercise.own<simulation::PalpationCues>().selected = static_cast<int>(i);
    state.overlay.own<PalpationOverlay>().outcome[i] = outcome;
}

inline void addLump(SceneState& state, const SceneSetup& setup, const core::Vec2& xy_m, double depth_m,
                    double radius_m, bool missed) {
    const simulation::TissueSurface surface(
        setup.parameters.as<simulation::PalpationParameters>().tissue.shape);
    const core::Vec3 p = surface.pointAt(xy_m) - depth_m * surface.normalAt(xy_m);
    const int i = state.exercise.own<simulation::PalpationCues>().lumps++;
    state.exercise.own<simulation::PalpationCues>().lump[std::size_t(i)] = {{p.x(), p.y(), p.z()}, radius_m};
    if (missed)
        state.overlay.own<PalpationOverlay>().lumpsMissed |= static_cast<std::uint8_t>(1U << i);
}

/// A search in strips over `share` of the area, its force between 0.3 N and 4.6 N.
inline simulation::SurfaceMap searched(const SceneSetup& setup, double share) {
    const auto& parameters = setup.parameters.as<simulation::PalpationParameters>();
    simulation::SurfaceMap map(parameters.areaHalf_m, parameters.tissue.contactRadius_m,
                               parameters.coverForce_N);
    const core::Vec2 half = parameters.areaHalf_m;
    int step = 0;
    for (double y = half.y(); y > half.y() * (1.0 - 2.0 * share); y -= 0.008)
        for (double x = -half.x(); x <= half.x(); x += 0.0025, ++step)
            map.press({x, y},
                      std::max(0.3, 1.8 + 1.4 * std::sin(0.21 * step) + 1.5 * std::sin(0.067 * step)));
    return map;
}

} // namespace chiron::scene3d::samples
