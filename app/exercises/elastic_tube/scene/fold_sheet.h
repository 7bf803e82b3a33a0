// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/laparoscopy_cues.h"
#include "desktop/scene3d/triangle_mesh.h"

#include <array>
#include <vector>

namespace chiron::scene3d {

/// The fold of tissue over a tube as a sheet: rows from where it grows out of the floor behind the tube, over its edge, to the hem that hangs down
/// in front while nobody holds it. It is drawn as wide as what it covers, narrower where it is gripped. Places in W, m. How it hangs is ours; felt is
/// its edge alone.
struct FoldSheet {
    static constexpr int kColumns = 13;          ///< across, in x
    static constexpr std::size_t kEdgeRow = 12;  ///< rows beyond it are the hem
    std::vector<std::array<core::Vec3, kColumns>> rows;

    static FoldSheet of(const core::LaparoscopyCues& cues); ///< no rows where the screen shows no fold
};

/// Both of its sides, paler where it is drawn tight. W, mm.
TriangleMesh foldMesh(const FoldSheet& sheet, double pale);

} // namespace chiron::scene3d
