// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/object_attributes.h"
#include "simulation/yield.h"

#include <string>
#include <vector>

namespace chiron::simulation {

enum class TubeTask {
    hold,      ///< one instrument: hold a tension in a band
    stretch,   ///< one instrument: stretch to the mark, and stay below the tear limit
    twoHanded, ///< an unfixed tube held between two graspers: hold a tension in a band
    transfer,  ///< the free end goes from the right instrument to the left one and on to a target
};

/// One level of the elastic-tube exercise (P2; models.md §2.4), filled from content by the catalogue, which
/// also checks the ranges. The tension is the attributes' elasticity evaluated at the stretch of the whole
/// tube beyond its rest length, and zero when slack.
struct ElasticTubeParameters {
    TubeTask task = TubeTask::hold;
    /// From content/objects: stiffness, stiffening, viscosity along the tube.
    ObjectAttributes tube;
    double stiffnessLow_N_per_m = 0.0; ///< each trial draws k in [low, high]; both 0: the object's own
    double stiffnessHigh_N_per_m = 0.0;
    double restLength_m = 0.045;
    double radius_m = 0.003; ///< of the tube as it is drawn
    /// The fixed end on the floor (z = 0); twoHanded: the middle of the tube as it lies.
    double baseX_m = 0.0;
    double baseY_m = 0.0;
    /// Each trial draws the base from a disc of this radius around that point.
    double baseSpread_m = 0.015;
    double tearRatio = 1.9;        ///< torn beyond this length over rest length
    double overStretchRatio = 1.7; ///< counted as an over-stretch beyond this

    double targetLow_N = 0.8; ///< each trial draws its target tension in [low, high] (hold, twoHanded)
    double targetHigh_N = 1.6;
    double band_N = 0.15;        ///< half width of the band around the target
    double markRatio = 1.4;      ///< stretch: the mark, as length over rest length
    double markTolerance = 0.04; ///< stretch: in either direction
    double targetX_m = -0.035;   ///< transfer: where the free end is brought
    double targetY_m = 0.0;
    double targetZ_m = 0.045;
    double targetRadius_m = 0.008;
    /// transfer: where the second instrument may grip, as a share of the rest length.
    double gripShare = 0.78;
    double hold_s = 3.0; ///< time in the band, at the mark or in the target

    double graspReach_m = 0.007;      ///< how near to a grip the tip has to be to take hold of it
    double graspAngle_rad = 0.20;     ///< the jaw holds below this angle
    double releaseAngle_rad = 0.35;   ///< and lets go above this one
    double instrumentsApart_m = 0.12; ///< between the two entry points, along x (two-handed tasks)

    /// A fold of tissue lies over the tube, and one more instrument has to hold it back; 0: there is none.
    /// Its pull grows with this stiffness as its edge is drawn back.
    double foldStiffness_N_per_m = 0.0;
    /// The tube can be reached while the fold is held back with at least this pull …
    double retractionLow_N = 0.5;
    double retractionHigh_N = 1.0; ///< … and the tissue suffers above this one

    int trials = 4; ///< 1..32
    double trialLimit_s = 45.0;
    double betweenTrials_s = 1.0;
    double maximumForce_N = 4.0; ///< the exercise's cap for the supervisor and the limit of force metrics
    YieldLaw yield;              ///< when the touched tissue gives way; by default never
    std::vector<std::string> cues;

    /// Number of tools that work on the tube: tools 0 …
    int hands() const noexcept { return task == TubeTask::twoHanded || task == TubeTask::transfer ? 2 : 1; }
    bool hasFold() const noexcept { return foldStiffness_N_per_m > 0.0; }
    /// The tool that holds the fold back, where there is one.
    int retractor() const noexcept { return hands(); }
    int tools() const noexcept { return hands() + (hasFold() ? 1 : 0); }
};

} // namespace chiron::simulation
