// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/drawn_mesh.h"

#include <array>
#include <vector>

namespace chiron::scene3d {

/// The fold of tissue over a tube as a sheet. Its rows run from the line behind the tube where the fold meets
/// the floor, over its edge, to the hem that hangs down in front while nobody holds the fold. It is as wide
/// as the part that it covers, and narrower where it is gripped. The shape in which it hangs is our own
/// design; only its edge takes part in the force.
/// Unit: m.
/// Frame: W.
struct FoldSheet {
    static constexpr int kColumns = 13;         ///< across, in x
    static constexpr std::size_t kEdgeRow = 12; ///< the rows after this one are the hem
    std::vector<std::array<core::Vec3, kColumns>> rows;

    static FoldSheet of(const core::LaparoscopyCues& cues); ///< no rows if the screen shows no fold
};

/// Both sides of the sheet; `pale` makes it paler where it is under tension.
/// Unit: mm.
/// Frame: W.
TriangleMesh foldMesh(const FoldSheet& sheet, double pale);

} // namespace chiron::scene3d
