// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/object_attributes.h"
#include "simulation/yield.h"

#include <string>
#include <vector>

namespace chiron::simulation {

enum class TubeTask {
    hold,      ///< one instrument: hold a tension in a band
    stretch,   ///< one instrument: to the mark, not to the tear limit
    twoHanded, ///< an unfixed tube held between two graspers: hold a tension in a band
    transfer,  ///< the free end goes from the right instrument to the left one and on to a target
};

/// One level of the elastic-tube exercise (P2; models.md §2.4), filled from content by the catalogue, which also checks the
/// ranges. Tension is the attributes' elasticity over the stretch of the whole tube beyond its rest length, zero when slack.
struct ElasticTubeParameters {
    TubeTask task = TubeTask::hold;
    ObjectAttributes tube;               ///< content/objects: stiffness, stiffening, viscosity along it
    double stiffnessLow_N_per_m = 0.0;   ///< each trial draws k in [low, high]; both 0: the object's own
    double stiffnessHigh_N_per_m = 0.0;
    double restLength_m = 0.045;
    double radius_m = 0.003;             ///< of the tube as it is drawn
    double baseX_m = 0.0;                ///< the fixed end on the floor (z = 0); twoHanded: the middle of where it lies
    double baseY_m = 0.0;
    double baseSpread_m = 0.015;         ///< each trial draws the base in a disc of this radius about it
    double tearRatio = 1.9;              ///< torn beyond this length over rest length
    double overStretchRatio = 1.7;       ///< counted as an over-stretch beyond this

    double targetLow_N = 0.8;            ///< each trial draws its target tension in [low, high] (hold, twoHanded)
    double targetHigh_N = 1.6;
    double band_N = 0.15;                ///< half width of the band about it
    double markRatio = 1.4;              ///< stretch: the mark, as length over rest length
    double markTolerance = 0.04;         ///< stretch: either way
    double targetX_m = -0.035;           ///< transfer: where the free end is brought
    double targetY_m = 0.0;
    double targetZ_m = 0.045;
    double targetRadius_m = 0.008;
    double gripShare = 0.78;             ///< transfer: where the second instrument may grip, share of the rest length
    double hold_s = 3.0;                 ///< in the band, at the mark, in the target

    double graspReach_m = 0.007;         ///< how near to a grip the tip has to be to take hold of it
    double graspAngle_rad = 0.20;        ///< the jaw holds below this angle
    double releaseAngle_rad = 0.35;      ///< and lets go above this one
    double instrumentsApart_m = 0.12;    ///< between the two entry points, along x (two-handed tasks)

    /// A fold of tissue lies over the tube, and one more instrument has to hold it back; 0: none. Its pull grows by so much over the way
    /// that its edge is drawn.
    double foldStiffness_N_per_m = 0.0;
    double retractionLow_N = 0.5;        ///< held back with this pull, the tube can be reached …
    double retractionHigh_N = 1.0;       ///< … and with more, the tissue suffers

    int trials = 4;                      ///< 1..32
    double trialLimit_s = 45.0;
    double betweenTrials_s = 1.0;
    double maximumForce_N = 4.0;         ///< the exercise's cap for the supervisor and the limit of force metrics
    YieldLaw yield; ///< when what is touched gives way; by default never
    std::vector<std::string> cues;

    int hands() const noexcept { return task == TubeTask::twoHanded || task == TubeTask::transfer ? 2 : 1; } ///< that work on the tube: tools 0 …
    bool hasFold() const noexcept { return foldStiffness_N_per_m > 0.0; }
    int retractor() const noexcept { return hands(); } ///< the tool that holds the fold back, where there is one
    int tools() const noexcept { return hands() + (hasFold() ? 1 : 0); }
};

} // namespace chiron::simulation
