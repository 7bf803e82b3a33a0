// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"

namespace chiron::scene3d {

/// The floor of the peritoneal cavity: flat (z = 0) over the workspace, rising in folds beyond it. The meshes
/// in this file are deterministic decoration out of reach of the instruments. The functions are pure,
/// allocate, and take a few ms.
/// Unit: mm.
/// Frame: W (world).
TriangleMesh peritoneumMesh(double workspace_mm);
/// Loops of small bowel at the back, left and right.
TriangleMesh bowelMesh(double workspace_mm);
/// Omentum at the front, left and right, low enough to hide nothing.
TriangleMesh fatMesh(double workspace_mm);
/// The fundus of the uterus, at the back behind the middle.
TriangleMesh uterusMesh(double workspace_mm);

} // namespace chiron::scene3d
