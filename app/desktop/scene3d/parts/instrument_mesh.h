// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/triangle_mesh.h"

namespace chiron::scene3d {

/// A 5 mm laparoscopic grasper in its own frame T: closed, its blunt tip is the origin; the shaft runs along
/// +z; the jaws open about x. Millimetres. Dimensions are ours, after common 5 mm instruments.
inline constexpr double kHinge_mm = 20.0; ///< jaws of 20 mm, as the exercises' grasper has

/// Clevis, coated shaft.
TriangleMesh instrumentBody();
/// The jaw on the +y side (the other is this one turned half round z), with the hinge where it sits in T.
TriangleMesh instrumentJaw();
/// So many painted rings on the shaft, by which several instruments are told apart.
TriangleMesh instrumentRings(int count);
/// Worn by the one that mouse and keyboard move: a wide ring that stands off the shaft.
TriangleMesh instrumentCollar();

} // namespace chiron::scene3d
