// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"
#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"

namespace chiron::scene3d {

/// What is marked over the endoscope's round picture, in its own coordinates (radius 1, y up): the same in 3D and in the flat
/// view. Nothing of it where the level hides it.
struct ScopeMarks {
    bool pictureShown = false; ///< the camera's picture is on

    bool guided = false;         ///< the middle of the lumen is known and the level marks it
    core::Vec2 lumen{0.0, 0.0};  ///< where its ring lies; within kRim
    /// Where the ring lies once the endoscope points the way the canal runs at its tip: in a bend beside the middle of the picture, for an
    /// endoscope with the lumen in the middle looks ahead of the bend and would cut its corner. So the ring asks for what is measured and judged.
    core::Vec2 target{0.0, 0.0};
    bool beyond = false;         ///< it lies outside the picture: the ring is an arrow's point at the rim
    bool aligned = false;        ///< it lies on its target: the ring is double

    double dwell = 0.0; ///< 0..1: the landmark in view has had this much of its holding time; with guidance only

    bool force = false;            ///< the force across the shaft is drawn
    core::Vec2 forceWay{1.0, 0.0}; ///< unit: which way it pushes the tip
    double forceShare = 0.0;       ///< of the limit
    bool over = false;

    static ScopeMarks of(const SceneSetup& setup, const UrethraDrawing& drawing, const SceneState& state);

    static constexpr double kRim = 0.80;      ///< the ring's place is held within this
    static constexpr double kAligned = 0.07;  ///< nearer to its target than this, 2.8° with the usual camera: aligned
    static constexpr double kLongest = 1.4;   ///< of the limit's length; beyond, the bar tells
    static constexpr double kLeast_N = 0.02;  ///< below, no arrow
};

} // namespace chiron::scene3d
