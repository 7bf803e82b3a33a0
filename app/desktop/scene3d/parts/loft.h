// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/triangle_mesh.h"

#include <array>
#include <vector>

namespace chiron::scene3d {

using Point_mm = std::array<double, 3>;
using Section = std::vector<Point_mm>; ///< one closed outline, counter-clockwise seen from +z

/// A skin over closed outlines, bottom to top; smooth across its faces, so a hard edge is where one loft ends
/// and the next begins. The ends are closed by flat lids. `steel`: share of bare metal, 0 = coated.
void addLoft(TriangleMesh& mesh, const std::vector<Section>& sections, double steel);

/// A round body about z: pairs of height and radius, bottom to top (a radius of 0 closes it in a point).
void addTurned(TriangleMesh& mesh, const std::vector<std::array<double, 2>>& profile_mm, double steel,
               int sides = 20);

/// A ring about z at height 0.
TriangleMesh ringMesh(double radius_mm, double thickness_mm);

} // namespace chiron::scene3d
