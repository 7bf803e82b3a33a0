// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/elastic_tube/scene/tube_curve.h"
#include "desktop/scene3d/triangle_mesh.h"

namespace chiron::scene3d {

/// The skin of the tube, darker towards the floor, blanched where it is stretched. All of these: W, millimetres; pure.
TriangleMesh tubeMesh(const TubeCurve& curve);
/// Painted rings where instruments may take hold, and at each quarter of its length: they come apart as the tube is stretched.
TriangleMesh tubeMarks(const TubeCurve& curve, const core::LaparoscopyCues& cues);
/// The soft shade of the tube on the floor; `light` of a vertex is how dark.
TriangleMesh tubeShade(const TubeCurve& curve, double floor_m);

} // namespace chiron::scene3d
