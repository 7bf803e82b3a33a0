// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/elastic_tube/scene/tube_curve.h"
#include "desktop/scene3d/drawn_mesh.h"

namespace chiron::scene3d {

/// The surface of the tube, darker towards the floor and blanched where it is stretched. All meshes of this
/// header are in W and millimetres; all functions are pure.
TriangleMesh tubeMesh(const TubeCurve& curve);
/// Painted rings at the places where instruments may grip and at each quarter of the tube's length. They move
/// apart as the tube is stretched.
TriangleMesh tubeMarks(const TubeCurve& curve, const core::LaparoscopyCues& cues);
/// The soft shadow of the tube on the floor; `light` of a vertex is its darkness.
TriangleMesh tubeShade(const TubeCurve& curve, double floor_m);

} // namespace chiron::scene3d
