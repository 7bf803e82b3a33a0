// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/palpation/tissue_contact.h"

namespace chiron::simulation {

/// Tissue between the jaws of a grasper that palpates (P3's seventh degree of freedom is the grasp). Everything but the tissue is an ASSUMPTION.
struct PinchParameters {
    double jawLength_m = 0.020;  ///< from the joint to the tips, as the laparoscopic grasper's
    double widest_rad = 1.6;     ///< a wider jaw counts as this
    double friction = 0.3;       ///< of smooth jaws on moist tissue, each of two faces
    double fullDepth_m = 0.004;  ///< length of the faces that press: in so deep, all of them does; smoothstep from 0
};

/// What a jaw keeps from tick to tick. One object a hand.
struct PinchTouch {
    bool inside = false;                          ///< the tips were in the tissue at the tick before
    double between_m = 0.0;                       ///< w, as wide as the jaws have been open since they went in
    core::Vec3 stretch_m = core::Vec3::Zero();    ///< of the tissue that the jaws hold against the tool
    core::Vec3 previous_W = core::Vec3::Zero();
    void release() noexcept { *this = PinchTouch{}; }
};

/// What the tissue between the jaws does. W, SI.
struct PinchResponse {
    double force_N = 0.0;                         ///< N, with which each jaw presses, ≥ 0; on the index finger's pad
    core::Vec3 hold = core::Vec3::Zero();         ///< on the tool: what is held is pulled along, ≤ 2 μ N
    double energy_J = 0.0;                        ///< of the hold; squeezing goes through the handle
    double compression_m = 0.0;                   ///< c
    double stiffness_N_per_m = 0.0;               ///< bounds how fast `hold` changes as the tool moves
    double squeezeStiffness_N_per_m = 0.0;        ///< bounds how fast N changes as the tool moves
    bool beyondChecked = false;                   ///< a face is nearer to a lump than the lump's law is checked
};

/// Pinch palpation: the jaws open across the finger, along x_T, their tips at the tool's. What came between them while they were open is
/// squeezed as they close; a jaw that was closed when it went in has nothing between it:
///   w = max over the contact of o,  o = 2 L sin(α/2),  c = w − o ≥ 0,
///   N = k (1 + G) s(d/d₁) c/2,      G = mean over the two faces of Σ χ at q = p + ½ min(d, d₁) z_T ± ½ o x_T,
/// p the tips, k the tissue's own stiffness against a flat face as wide as the pad, s a smoothstep, χ the lumps' law (lump_law.h) with the squeeze's direction x_T in place
/// of n. So N is 0 without contact and at d = 0, continuous in place, turn and opening, and defined everywhere. What is held resists as an anchored spring
/// of the tissue's tangential stiffness, clipped at friction's 2 μ N: it makes no energy, and as N falls it lets go. `touched`: of the tool at this tick.
/// No allocation; haptic thread. Source: P3 §2.2 (grasping motion); P3's contact and models.md §3 for k and χ; gripLimit_N.
PinchResponse pinchTissue(const TissueContact& tissue, const PinchParameters& parameters, const core::ToolState& tool, const TissueResponse& touched,
                          PinchTouch& touch) noexcept;

} // namespace chiron::simulation
