// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "scoring/trace.h"

#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// A lump that was there. W, m.
struct LumpTruth {
    core::Vec3 place_W = core::Vec3::Zero(); ///< the surface point above it
    double depth_m = 0.0;                    ///< of its centre
    double radius_m = 0.0;
    int hardness = 0; ///< what a person should call it, 1..5; 0: not told
};

/// What is true of one trial of a palpation (TrialTrace::truth). Area and regions: |x| ≤ half.x, |y| ≤ half.y round W's origin.
struct PalpationTruth {
    std::vector<LumpTruth> lumps; ///< at most simulation::kMaxShownLumps
    core::Vec2 areaHalf_m{0.04, 0.04};
    int regionColumns = 3;
    int regionRows = 3;
    double hitRadius_m = 0.012;
    double bandLow_N = 0.0; ///< high ≤ low: the trace has no band
    double bandHigh_N = 0.0;
    double coverForce_N = 0.0;
    bool introduction = false; ///< had a lump because the level says so, and is left out of d′, c and the ROC
    bool asksSize = false;
    bool asksHardness = false;
};

/// Nothing where the trace does not say it all (band, cover force and what is asked may lack), or says what cannot be.
std::optional<PalpationTruth> palpationTruthOf(std::span<const NamedValue> truth);

} // namespace chiron::scoring
