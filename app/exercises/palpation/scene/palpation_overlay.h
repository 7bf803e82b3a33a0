// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"

#include <array>
#include <cstdint>

namespace chiron::simulation {
class SurfaceMap;
}

namespace chiron::scene3d {

/// What a palpation's screens add to the scene: the map of what was searched and, looking back, what became of each finding.
struct PalpationOverlay {
    const simulation::SurfaceMap* map = nullptr; ///< where was pressed and how hard; owned by the caller, read during show()
    std::uint32_t mapStep = 0;                   ///< changes whenever the map did
    simulation::SurfaceMapKind mapKind = simulation::SurfaceMapKind::coverage;
    std::array<simulation::FindingOutcome, simulation::kMaxFindings> outcome{}; ///< of each finding
    std::uint8_t lumpsMissed = 0;                ///< one bit a lump of the cues that nobody found
};

} // namespace chiron::scene3d
