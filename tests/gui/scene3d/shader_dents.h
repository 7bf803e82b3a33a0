// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "desktop/scene3d/drawn_mesh.h"
#include "desktop/scene3d/parts/dent.h"

#include <QString>
#include <vector>

namespace chiron::scene3d {

/// Where the scene's own vertex shader puts these vertices under these dents (at most 4), read back by
/// transform feedback. Metres. Empty, with `error` set, where OpenGL 3.2 or the shader fails.
std::vector<core::Vec3> displacedByShader(const TriangleMesh& mesh, const std::vector<Dent>& dents,
                                          QString& error);

} // namespace chiron::scene3d
