// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/triangle_mesh.h"

namespace chiron::scene3d {

/// A gloved finger in the tool's frame T, millimetres, from its pad, which touches the origin from above (−z), to its knuckle towards
/// −y and up, where the hand begins (hand_mesh.h). Dimensions are ours, after a man's index finger: 16 mm wide at the tip.
TriangleMesh fingerMesh();
/// So many bands round the middle bone, by which several fingers are told apart.
TriangleMesh fingerBands(int count);
/// Worn by the one that mouse and keyboard move.
TriangleMesh fingerCollar();

inline constexpr double kPlatformRing_mm = 10.4; ///< radius of the ring that shows the platform's lean
inline constexpr double kPlatformHeight_mm = 6.0; ///< of its middle over the pad

} // namespace chiron::scene3d
