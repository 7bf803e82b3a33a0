// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"

#include <array>
#include <cstdint>

namespace chiron::simulation {
class SurfaceMap;
}

namespace chiron::scene3d {

/// The additions of a palpation's screens to the scene: the map of the searched surface and, in review, the
/// outcome of each finding.
struct PalpationOverlay {
    const simulation::SurfaceMap* map = nullptr; ///< where and how hard the tissue was pressed; owned by the
                                                 ///< caller, read during show()
    std::uint32_t mapStep = 0;                   ///< changes whenever the map changes
    simulation::SurfaceMapKind mapKind = simulation::SurfaceMapKind::coverage;
    std::array<simulation::FindingOutcome, simulation::kMaxFindings> outcome{}; ///< of each finding
    std::uint8_t lumpsMissed = 0; ///< one bit per lump of the cues that was not found
};

} // namespace chiron::scene3d
