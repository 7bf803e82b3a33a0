// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/triangle_mesh.h"

namespace chiron::scene3d {

/// The gloved hand behind the fingers that palpate, in the frame of its index finger (finger_mesh.h), millimetres: back of the hand,
/// thumb, the fingers that are not used folded above the tissue, wrist and the glove's cuff. `used`: fingers drawn by themselves, index
/// first, 1 or 2. A left hand is the mirror image of a right one. Dimensions are ours, after a man's hand: 82 mm across the knuckles.
TriangleMesh handMesh(int used, bool left);

} // namespace chiron::scene3d
