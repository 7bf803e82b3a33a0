// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/palpation/tissue_parameters.h"
#include "simulation/palpation/tissue_pinch.h"
#include "simulation/yield.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::simulation {

/// One type of lump. A level draws its lumps from its types with equal probability.
struct LumpKind {
    double radius_m = 0.0075;
    double depth_m = 0.012;
    double ratio = 10.0;
    int hardness = 5; ///< the rating that a person should give, 1..5
};

/// For research and tests only: conditions under which nothing can be found, or has to be found elsewhere.
struct PalpationControl {
    bool forceOff = false; ///< the tissue exerts no force
    /// > 0: every lump moves by `move_m` this long after its trial began, at the next tick out of contact.
    double moveAfter_s = 0.0;
    core::Vec2 move_m = core::Vec2::Zero();
};

/// One level of palpation (P3; models.md §3), filled from content by the catalogue, which also checks the
/// ranges.
struct PalpationParameters {
    TissueParameters tissue;         ///< from content/tissues
    std::vector<LumpKind> kinds{{}}; ///< at least one
    int lumpsLow = 1;    ///< each trial that is not a catch trial draws its number of lumps in [low, high]
    int lumpsHigh = 1;   ///< ≤ TissueParameters::kMaxLumps
    int catchTrials = 0; ///< number of `trials` without a lump; which ones is drawn
    /// The first trial always has a lump: an introduction that is left out of d′.
    bool lumpFirst = false;
    double depthSpread_m = 0.0; ///< each lump's depth is that of its kind ± this
    /// Least distance between two lumps, and from the middle of a distractor.
    double spacing_m = 0.025;

    core::Vec2 areaHalf_m{0.040, 0.040}; ///< the search area |x| ≤ , |y| ≤ around W's origin
    int regionColumns = 3;               ///< the units of detection: d′ counts regions of the search area
    int regionRows = 3;
    /// A mark within this distance of a lump counts as a hit (at least the lump's radius).
    double hitRadius_m = 0.012;

    double bandLow_N = 0.8; ///< force band for pressing
    double bandHigh_N = 2.5;
    double coverForce_N = 0.5; ///< a spot that was pressed with this force counts as searched
    bool asksSize = false;
    bool asksHardness = false;
    bool asksConfidence = true;

    int hands = 1;   ///< 1..2 (P3: one arm each)
    int fingers = 1; ///< 1..2 per hand: index and middle finger, side by side
    double fingerSpacing_m = 0.018;

    int trials = 4;
    double trialLimit_s = 90.0;
    double betweenTrials_s = 1.0;
    double maximumForce_N = 4.0;
    YieldLaw yield; ///< when the tissue gives way under one finger; older content has none
    /// Jaws that squeeze tissue; older content has none, and its jaws do nothing.
    std::optional<PinchParameters> pinch;
    PalpationControl control;
    std::vector<std::string> cues;

    int tools() const noexcept { return hands * fingers; }
};

} // namespace chiron::simulation
