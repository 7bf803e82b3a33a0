// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/parts/sweep.h"

#include <optional>
#include <vector>

namespace chiron::scene3d {

/// One cross-section of the drawn tube.
/// Unit: m.
/// Frame: W.
struct TubeRing {
    core::Vec3 p_W = core::Vec3::Zero();
    double radius_m = 0.0;
    double share = 0.0; ///< position along the tube, as a fraction of the rest length from the base
    double pale = 0.0;  ///< 0..1: degree of stretch, since stretched tissue loses blood
};

struct TubePiece {
    std::vector<TubeRing> rings;
    SweepEnd first = SweepEnd::round;
    SweepEnd last = SweepEnd::round;
};

/// The centre-line of the drawn tube. It passes exactly through every grip of the cues. Between two of them,
/// a taut part (longer than at rest) is straight and has the radius r √(l/d), so that its volume is constant
/// (l at rest, d now). A slack part has the radius r and its rest length; it hangs in a parabola, turned to
/// the side where the floor would stop it. A torn tube parts in the middle of the most stretched part. Pure:
/// the same cues give the same curve, and a small change of the cues gives a small change of the curve.
struct TubeCurve {
    std::vector<TubePiece> pieces;

    /// `radius_m`: at rest. `floor_m`: z of the floor.
    static TubeCurve of(const core::LaparoscopyCues& cues, double radius_m, double floor_m = 0.0);
    /// The ring nearest to a position along the tube; empty if there is no tube.
    std::optional<TubeRing> at(double share) const;
    double length_m() const; ///< of all pieces, measured along their rings
};

} // namespace chiron::scene3d
