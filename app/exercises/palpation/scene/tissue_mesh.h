// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"
#include "desktop/scene3d/parts/dent.h"
#include "desktop/scene3d/scene_state.h"
#include "simulation/palpation/tissue_surface.h"

#include <array>

namespace chiron::scene3d {

/// The felt surface as triangles of about 1.6 mm, in the disc of `reach_m` round W's origin. Every vertex
/// lies on the surface, and the furrows are darker. Pure function; allocates; takes about 2 ms.
/// Unit: mm.
/// Frame: W.
TriangleMesh tissueMesh(const simulation::TissueSurface& surface, double reach_m);

/// The border of the search area |x| ≤ half.x, |y| ≤ half.y: a ribbon on the surface of width `wide_mm`.
TriangleMesh areaMesh(const simulation::TissueSurface& surface, const core::Vec2& half_m, double wide_mm);

/// The dent of the surface under a finger whose pad has the radius a: as deep as the felt one, about twice as
/// wide as the pad. No dent if the finger is not below the surface, or is drawn on it.
Dent fingerDent(const simulation::TissueSurface& surface, double padRadius_m, const ToolView& tool);

/// The largest height of the surface on the circle of this radius, where the drape lies.
double rimHeight_m(const simulation::TissueSurface& surface, double radius_m);

} // namespace chiron::scene3d
