// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/object_attributes.h"
#include "simulation/geometry/mesh/mesh_source.h"
#include "simulation/yield.h"

#include <string>
#include <vector>

namespace chiron::simulation {

enum class HandlingTask {
    place, ///< lift the object and set it down in the target
    weigh, ///< of several objects that look alike, set the heaviest down in the target
};

/// One level of object handling (P2: mass, deformation, roughness, friction of an ovary; models.md §2.2),
/// filled from content by the catalogue, which also checks the ranges.
struct ObjectHandlingParameters {
    HandlingTask task = HandlingTask::place;
    ObjectAttributes object;   ///< from content/objects, e.g. the ovary
    ObjectAttributes bed;      ///< the surface on which the objects lie
    bool organBed = false;     ///< the bed is a deformable organ, simulated at the slow rate (P2, two rates)
    MeshSource bedMesh;        ///< mesh of the organ
    double bedRate_Hz = 30.0;  ///< rate of the slow model, 30..50
    int bedLatency_ticks = 33; ///< L, 20 to one period; blending takes the same time
    int objects = 1;           ///< 1..3
    /// Each object of a trial draws its mass in [low, high]; both 0: the object's own.
    double massLow_kg = 0.0;
    double massHigh_kg = 0.0;
    double massRatio = 1.5;  ///< weigh: the heaviest is at least this much heavier than the next
    double radius_m = 0.011; ///< of the object, half its thickness between the jaws
    /// Radius, around the middle of the field, in which objects and target are placed.
    double placesRadius_m = 0.035;
    double targetRadius_m = 0.014;
    double squeezeLimit_N = 2.0; ///< a larger grip force counts as over-squeezing
    double jawLength_m = 0.020;  ///< from the joint to the tip; determines the opening of the jaws
    /// Greatest distance of the tip from the object's surface at which it takes hold.
    double graspReach_m = 0.007;
    double releaseClearance_m = 0.002; ///< the jaws let go when they are this much wider than the object
    double liftHeight_m = 0.030;       ///< height to which an object has to be lifted on the way
    double dropSpeed_m_per_s = 0.15;   ///< setting down faster than this counts as a drop
    double hold_s = 1.0;               ///< time at rest in the target, let go

    int trials = 4;
    double trialLimit_s = 60.0;
    double betweenTrials_s = 1.0;
    double maximumForce_N = 4.0;
    YieldLaw yield; ///< when the touched tissue gives way; by default never
    std::vector<std::string> cues;

    int tools() const noexcept { return 1; }
};

} // namespace chiron::simulation
