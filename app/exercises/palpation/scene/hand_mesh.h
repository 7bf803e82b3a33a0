// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"

namespace chiron::scene3d {

/// The gloved hand behind the palpating fingers, in the frame of its index finger (finger_mesh.h): back of
/// the hand, thumb, the unused fingers folded above the tissue, wrist and the glove's cuff. `used`: number of
/// fingers that are drawn separately, index first, 1 or 2. A left hand is the mirror image of a right one.
/// The dimensions are our own, modelled on a man's hand: 82 mm across the knuckles.
/// Unit: mm.
TriangleMesh handMesh(int used, bool left);

} // namespace chiron::scene3d
