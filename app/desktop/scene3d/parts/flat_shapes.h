// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"

namespace chiron::scene3d {

/// Flat triangles in the picture's own coordinates (−1..1, y up), facing +z. Texture coordinates run 0..1
/// over the picture.
TriangleMesh roundPicture();           ///< the disc that the camera's picture fills
TriangleMesh roundWindow();            ///< the rest of the square outside the disc, in front of everything
TriangleMesh flatSquare(double depth); ///< −1..1, at this depth (−1 near .. 1 far)

/// Shapes for marks, about the origin. On round shapes texture x is the share of a turn.
TriangleMesh flatRing(double radius, double half);
TriangleMesh flatBar(double half);  ///< from (0,0) to (1,0)
TriangleMesh flatHead(double half); ///< from the base at (0,0) to the point (1,0)
TriangleMesh flatTick(double half);

} // namespace chiron::scene3d
