// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"

namespace chiron::scene3d {

/// A 5 mm laparoscopic grasper in its own frame T: when it is closed, its blunt tip is the origin; the shaft
/// runs along +z; the jaws open about x. The dimensions are our own choice, modelled on common 5 mm
/// instruments.
/// Unit: mm.
inline constexpr double kHinge_mm = 20.0; ///< jaw length of 20 mm, as in the exercises' grasper

/// The clevis and the coated shaft.
TriangleMesh instrumentBody();
/// The jaw on the +y side, with its hinge at its position in T. The other jaw is this one turned by half a
/// turn about z.
TriangleMesh instrumentJaw();
/// This many painted rings on the shaft, which distinguish several instruments.
TriangleMesh instrumentRings(int count);
/// A wide ring that stands off the shaft and marks the instrument that mouse and keyboard move.
TriangleMesh instrumentCollar();

} // namespace chiron::scene3d
