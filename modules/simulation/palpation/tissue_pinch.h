// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/palpation/tissue_contact.h"

namespace chiron::simulation {

/// A grasper that palpates tissue between its jaws (P3's seventh degree of freedom is the grasp). Everything
/// except the tissue is an ASSUMPTION.
struct PinchParameters {
    double jawLength_m = 0.020; ///< from the joint to the tips, as for the laparoscopic grasper
    double widest_rad = 1.6;    ///< a wider angle counts as this one
    double friction = 0.3;      ///< of smooth jaws on moist tissue, at each of two faces
    /// Length of the pressing faces: from this depth on they press with all of it; smoothstep from 0.
    double fullDepth_m = 0.004;
};

/// State that a jaw keeps from tick to tick; one instance per hand.
struct PinchTouch {
    bool inside = false;                       ///< the tips were in the tissue in the previous tick
    double between_m = 0.0;                    ///< w, the largest opening since the jaws went in
    core::Vec3 stretch_m = core::Vec3::Zero(); ///< of the tissue that the jaws hold, relative to the tool
    core::Vec3 previous_W = core::Vec3::Zero();
    void release() noexcept { *this = PinchTouch{}; }
};

/// Effect of the tissue between the jaws.
/// Unit: SI.
/// Frame: W.
struct PinchResponse {
    /// N, the force of each jaw, ≥ 0; acts on the index finger's pad.
    double force_N = 0.0;
    /// Force on the tool by the tissue that it pulls along, ≤ 2 μ N.
    core::Vec3 hold = core::Vec3::Zero();
    /// Energy of the hold; the work of squeezing goes through the handle.
    double energy_J = 0.0;
    double compression_m = 0.0;            ///< c
    double stiffness_N_per_m = 0.0;        ///< bound on how fast `hold` changes as the tool moves
    double squeezeStiffness_N_per_m = 0.0; ///< bound on how fast N changes as the tool moves
    /// A face is nearer to a lump than the lump's law has been checked.
    bool beyondChecked = false;
};

/// Computes pinch palpation. The jaws open across the finger, along x_T, and their tips are at the tool's
/// position. Tissue that came between them while they were open is squeezed as they close; a jaw that was
/// closed when it went in has nothing between its faces:
///   w = max over the contact of o,  o = 2 L sin(α/2),  c = w − o ≥ 0,
///   N = k (1 + G) s(d/d₁) c/2,
///   G = mean over the two faces of Σ χ at q = p + ½ min(d, d₁) z_T ± ½ o x_T.
/// Here p is the tips' position, k the tissue's own stiffness against a flat face as wide as the pad, s a
/// smoothstep, and χ the lumps' law (lump_law.h) with the squeeze's direction x_T in place of n. N is 0
/// without contact and at d = 0, continuous in position, orientation and opening, and defined everywhere. The
/// held tissue resists as an anchored spring of its tangential stiffness, clipped at friction's 2 μ N; this
/// spring creates no energy, and it lets go as N falls. `touched` is the tissue's response to the tool in
/// this tick. Source: P3 §2.2 (grasping motion); P3's contact and models.md §3 for k and χ; gripLimit_N.
/// Thread: haptic; allocates nothing.
PinchResponse pinchTissue(const TissueContact& tissue, const PinchParameters& parameters,
                          const core::ToolState& tool, const TissueResponse& touched,
                          PinchTouch& touch) noexcept;

} // namespace chiron::simulation
