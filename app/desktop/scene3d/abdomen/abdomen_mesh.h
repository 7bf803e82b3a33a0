// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/triangle_mesh.h"

namespace chiron::scene3d {

/// The floor of the peritoneal cavity: flat (z = 0) over the workspace, rising in folds beyond it. All of these: frame W,
/// millimetres, the same every time; decoration, out of reach of the instruments. Pure; allocate; a few ms.
TriangleMesh peritoneumMesh(double workspace_mm);
/// Loops of small bowel behind, left and right.
TriangleMesh bowelMesh(double workspace_mm);
/// Omentum in front, left and right, low enough to hide nothing.
TriangleMesh fatMesh(double workspace_mm);
/// The fundus of the uterus, behind the middle.
TriangleMesh uterusMesh(double workspace_mm);

} // namespace chiron::scene3d
