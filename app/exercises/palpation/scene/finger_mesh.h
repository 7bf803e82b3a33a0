// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/drawn_mesh.h"

namespace chiron::scene3d {

/// A gloved finger in the tool's frame T, from its pad, which touches the origin from above (−z), to its
/// knuckle towards −y and up, where the hand begins (hand_mesh.h). The dimensions are our own, modelled on a
/// man's index finger: 16 mm wide at the tip.
/// Unit: mm.
TriangleMesh fingerMesh();
/// Bands round the middle phalanx; their number distinguishes several fingers.
TriangleMesh fingerBands(int count);
/// A collar worn by the finger that mouse and keyboard move.
TriangleMesh fingerCollar();

inline constexpr double kPlatformRing_mm = 10.4;  ///< radius of the ring that shows the platform's lean
inline constexpr double kPlatformHeight_mm = 6.0; ///< height of the ring's centre above the pad

} // namespace chiron::scene3d
