// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/result.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "scoring/trace.h"

#include <optional>
#include <span>
#include <vector>

namespace chiron::scoring {

/// A lump that was present. W, m.
struct LumpTruth {
    core::Vec3 place_W = core::Vec3::Zero(); ///< the surface point above it
    double depth_m = 0.0;                    ///< of its centre
    double radius_m = 0.0;
    int hardness = 0; ///< correct answer, 1..5; 0: not recorded
};

/// The force band of a trial, which a trace may record without the rest of the truth. Empty where it does
/// not.
struct PalpationBand {
    std::optional<double> low_N;
    std::optional<double> high_N;
};

/// The truth of one palpation trial (TrialTrace::truth). Area and regions: |x| ≤ half.x, |y| ≤ half.y around
/// W's origin.
struct PalpationTruth {
    std::vector<LumpTruth> lumps; ///< at most simulation::kMaxShownLumps
    core::Vec2 areaHalf_m{0.04, 0.04};
    int regionColumns = 3;
    int regionRows = 3;
    double hitRadius_m = 0.012;
    double bandLow_N = 0.0; ///< high ≤ low: the trace has no band
    double bandHigh_N = 0.0;
    double coverForce_N = 0.0;
    bool introduction = false; ///< has a lump because the level prescribes it, and is left out of d′, c and
                               ///< the ROC
    bool asksSize = false;
    bool asksHardness = false;
};

/// Reads the truth from the named values of a trial. The band, the cover force and the questions asked may be
/// missing.
/// Errors: badInput naming the field that is missing or impossible.
core::Result<PalpationTruth> palpationTruthOf(std::span<const NamedValue> values);
/// The band alone.
PalpationBand palpationBandOf(std::span<const NamedValue> values);
/// The named values of the truth, in the order in which they are stored and exported. The inverse of
/// palpationTruthOf().
std::vector<NamedValue> valuesOf(const PalpationTruth& truth);

} // namespace chiron::scoring
