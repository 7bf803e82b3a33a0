// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"

namespace chiron::scene3d {

/// The sterile drape with its round opening about z: a rolled edge, then cloth in soft folds that fall away
/// to beyond the picture. Height 0 is the plane of the field.
/// Unit: mm.
TriangleMesh drapeMesh(double opening_mm);

} // namespace chiron::scene3d
