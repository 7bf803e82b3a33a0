// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/laparoscopy_cues.h"
#include "desktop/scene3d/parts/sweep.h"

#include <optional>
#include <vector>

namespace chiron::scene3d {

/// One cross-section of the drawn tube. W, metres.
struct TubeRing {
    core::Vec3 p_W = core::Vec3::Zero();
    double radius_m = 0.0;
    double share = 0.0; ///< of the rest length, from the base: which place of the tube this is
    double pale = 0.0;  ///< 0..1: how far stretched, as blood leaves it
};

struct TubePiece {
    std::vector<TubeRing> rings;
    SweepEnd first = SweepEnd::round;
    SweepEnd last = SweepEnd::round;
};

/// The tube as it is drawn: through every place of the cues, exactly. Between two of them a taut part (longer than at rest) is
/// straight and r √(l/d) thick, so that its volume stays (l at rest, d now); a slack part is r thick and as long as at rest:
/// it hangs in a parabola, turned to the side by as much as the floor stops it. A torn tube parts in the middle of what is
/// stretched most. Pure; the same cues give the same curve; a small change of them a small change of it.
struct TubeCurve {
    std::vector<TubePiece> pieces;

    /// `radius_m`: at rest. `floor_m`: z of the floor.
    static TubeCurve of(const core::LaparoscopyCues& cues, double radius_m, double floor_m = 0.0);
    /// The ring nearest to a place along the tube; nothing where there is no tube.
    std::optional<TubeRing> at(double share) const;
    double length_m() const; ///< of all pieces along their rings
};

} // namespace chiron::scene3d
