// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"
#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

namespace chiron::scene3d {

/// The marks over the endoscope's round picture, in its own coordinates (radius 1, y up), the same in 3D and
/// in the flat view. Marks that the level hides are off.
struct ScopeMarks {
    bool pictureShown = false; ///< the camera's picture is on

    bool guided = false;        ///< the position of the lumen is known and the level marks it
    core::Vec2 lumen{0.0, 0.0}; ///< position of the ring; within kRim
    /// The ring's position once the endoscope points along the canal at its tip. In a bend this is beside the
    /// middle of the picture: an endoscope with the lumen in the middle looks ahead of the bend and would cut
    /// its corner. The ring therefore asks for the alignment that is measured and assessed.
    core::Vec2 target{0.0, 0.0};
    bool beyond = false;  ///< the lumen lies outside the picture: the ring becomes an arrowhead at the
                          ///< rim
    bool aligned = false; ///< the ring is on its target: it is drawn double

    /// 0..1: elapsed fraction of the holding time of the landmark in view; only with guidance.
    double dwell = 0.0;

    bool force = false;            ///< the force across the shaft is drawn
    core::Vec2 forceWay{1.0, 0.0}; ///< unit vector of the direction in which it pushes the tip
    double forceShare = 0.0;       ///< fraction of the limit
    bool over = false;

    static ScopeMarks of(const SceneSetup& setup, const UrethraDrawing& drawing, const SceneState& state);

    static constexpr double kRim = 0.80; ///< the ring stays within this radius
    /// Within this distance from its target (2.8° with the usual camera) the ring counts as aligned.
    static constexpr double kAligned = 0.07;
    /// Longest arrow, relative to that of the limit; the bar shows larger forces.
    static constexpr double kLongest = 1.4;
    static constexpr double kLeast_N = 0.02; ///< no arrow below this force
};

} // namespace chiron::scene3d
