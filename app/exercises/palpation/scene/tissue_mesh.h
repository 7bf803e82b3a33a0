// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_state.h"
#include "desktop/scene3d/parts/dent.h"
#include "desktop/scene3d/triangle_mesh.h"
#include "simulation/palpation/tissue_surface.h"

#include <array>

namespace chiron::scene3d {

/// The felt surface as triangles, about 1.6 mm apart, in the disc of `reach_m` round W's origin; every vertex lies on it. Darker
/// in its furrows. W, millimetres. Pure; allocates; about 2 ms.
TriangleMesh tissueMesh(const simulation::TissueSurface& surface, double reach_m);

/// The border of the search area |x| ≤ half.x, |y| ≤ half.y: a ribbon on the surface, `wide_mm` wide.
TriangleMesh areaMesh(const simulation::TissueSurface& surface, const core::Vec2& half_m, double wide_mm);

/// How the surface gives way under a finger whose pad has the radius a: as deep as it is felt, about twice as wide as the pad.
/// Nothing where the finger is not below the surface, or is drawn on it.
Dent fingerDent(const simulation::TissueSurface& surface, double padRadius_m, const ToolView& tool);

/// The highest place of the surface on the circle of this radius: there a drape lies.
double rimHeight_m(const simulation::TissueSurface& surface, double radius_m);

} // namespace chiron::scene3d
