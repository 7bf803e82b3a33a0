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

/// One kind of lump that a level draws from, each with the same chance.
struct LumpKind {
    double radius_m = 0.0075;
    double depth_m = 0.012;
    double ratio = 10.0;
    int hardness = 5; ///< what a person should call it, 1..5
};

/// For research and tests only: conditions under which nothing can be found, or must be found elsewhere.
struct PalpationControl {
    bool forceOff = false;           ///< the tissue answers nothing
    double moveAfter_s = 0.0;        ///< > 0: every lump moves by `move_m` so long after its trial began, at the next tick out of contact
    core::Vec2 move_m = core::Vec2::Zero();
};

/// One level of palpation (P3; models.md §3), filled from content by the catalogue, which also checks the ranges.
struct PalpationParameters {
    TissueParameters tissue;          ///< content/tissues
    std::vector<LumpKind> kinds{{}};  ///< at least one
    int lumpsLow = 1;                 ///< each trial that is not a catch trial draws its number of lumps in [low, high]
    int lumpsHigh = 1;                ///< ≤ TissueParameters::kMaxLumps
    int catchTrials = 0;              ///< of `trials`, without a lump; which ones is drawn
    bool lumpFirst = false;           ///< the first trial has a lump, whatever is drawn: an introduction, left out of d′
    double depthSpread_m = 0.0;       ///< each lump's depth is its kind's ± this
    double spacing_m = 0.025;         ///< between two lumps, and from a distractor's middle, at least

    core::Vec2 areaHalf_m{0.040, 0.040}; ///< the search area |x| ≤ , |y| ≤ round W's origin
    int regionColumns = 3;            ///< the units of detection: d′ counts regions of the search area
    int regionRows = 3;
    double hitRadius_m = 0.012;       ///< a mark so near to a lump found it (at least its radius)

    double bandLow_N = 0.8;           ///< how hard to press: the force band
    double bandHigh_N = 2.5;
    double coverForce_N = 0.5;        ///< a spot pressed so hard was searched
    bool asksSize = false;
    bool asksHardness = false;
    bool asksConfidence = true;

    int hands = 1;                    ///< 1..2 (P3: an arm each)
    int fingers = 1;                  ///< 1..2 a hand: index and middle, side by side
    double fingerSpacing_m = 0.018;

    int trials = 4;
    double trialLimit_s = 90.0;
    double betweenTrials_s = 1.0;
    double maximumForce_N = 4.0;
    YieldLaw yield;                   ///< when the tissue gives way under one finger; content of before has none
    std::optional<PinchParameters> pinch; ///< jaws that squeeze tissue; content of before has none, and its jaws do nothing
    PalpationControl control;
    std::vector<std::string> cues;

    int tools() const noexcept { return hands * fingers; }
};

} // namespace chiron::simulation
