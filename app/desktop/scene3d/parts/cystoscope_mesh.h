// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"

namespace chiron::scene3d {

/// A rigid cystoscope in its own frame T: the lens at the origin, the sheath of this radius along +z with a
/// ring every 50 mm, then the bridge and the eyepiece. The lengths are our own choice, modelled on common
/// instruments.
/// Unit: mm.
TriangleMesh cystoscopeMesh(double radius_mm);

} // namespace chiron::scene3d
