// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"

#include <array>
#include <vector>

namespace chiron::scene3d {

using Point_mm = std::array<double, 3>;
using Section = std::vector<Point_mm>; ///< one closed outline, counter-clockwise seen from +z

/// Adds a surface over closed outlines, from bottom to top. It is smooth across its faces, so a hard edge
/// needs one loft to end and another to begin. Flat lids close the ends. `steel` is the share of bare metal,
/// 0 = coated.
void addLoft(TriangleMesh& mesh, const std::vector<Section>& sections, double steel);

/// Adds a body of revolution about z from pairs of height and radius, bottom to top (a radius of 0 closes it
/// in a point).
void addTurned(TriangleMesh& mesh, const std::vector<std::array<double, 2>>& profile_mm, double steel,
               int sides = 20);

/// A ring about z at height 0.
TriangleMesh ringMesh(double radius_mm, double thickness_mm);

} // namespace chiron::scene3d
