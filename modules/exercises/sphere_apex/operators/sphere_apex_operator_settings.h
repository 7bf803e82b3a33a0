// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "operators/hand/perception_settings.h"

#include <string>

namespace chiron::operators {

/// How a trainee searches for the apex once it has climbed onto something.
enum class ApexTechniqueKind {
    wander,    ///< moves about and remembers where it felt highest
    midpoints, ///< sweeps across in x, then in y, from slope to slope, and takes the middles
    /// Short sweeps to and fro, fits felt slope against felt position, goes where it is zero; repeats.
    slopeCrossings,
};

/// One scripted trainee: how it moves, presses and searches, and when it is satisfied. The values are
/// assumptions that are plausible for people. The perceptual noises were set first and never changed. Speeds,
/// gains and techniques were revised while the trainees still fell off the ball, and the expert's fit was
/// revised once, when it did no better than the intermediate (README.md). Nothing is fitted to P2's 14.2 %.
/// Unit: SI.
struct SphereApexOperatorSettings {
    std::string name = "expert";
    PerceptionSettings perception;
    mechanisms::HandParameters hand; ///< pass it on as SimulatedDevice::Configuration::hand
    ApexTechniqueKind technique = ApexTechniqueKind::slopeCrossings;

    double reachSpeed_m_per_s = 0.15;  ///< free movements
    double lowerSpeed_m_per_s = 0.04;  ///< down to the table
    double scanSpeed_m_per_s = 0.08;   ///< along lines above the table, searching for something
    double climbSpeed_m_per_s = 0.025; ///< up what it found
    double sweepSpeed_m_per_s = 0.010; ///< over the top

    double startHeight_m = 0.050; ///< height above the table at which the tool begins; the trainee was told
    double scanRadius_m = 0.055;  ///< radius of the exercise's workspace; the trainee was told
    double scanHeight_m = 0.009;  ///< above the height at which the table was felt
    double scanSpacing_m = 0.020; ///< between lines

    double force_N = 1.0;              ///< force that it wants to feel
    bool controlsForce = true;         ///< false: holds a depth instead, whatever force results
    double pressDepth_m = 0.0;         ///< with controlsForce false: depth below where it stood
    double forceGain_m_per_Ns = 0.006; ///< how fast a wrong force is corrected; bounded by the reaction delay

    double topSlope = 0.34;          ///< felt lateral share of the force that counts as "on top" (20°)
    double edgeSlope = 0.5;          ///< midpoints: where a sweep turns (30°)
    double sweepHalfWidth_m = 0.009; ///< slopeCrossings: of the first cross
    /// slopeCrossings: number of crosses; one more if the last moved the apex far.
    int crosses = 2;
    double wanderRadius_m = 0.014; ///< wander: radius of the area
    double wanderTime_s = 6.0;     ///< wander: duration
    double settle_s = 0.3;         ///< keeps still before it marks
    double patience_s = 50.0;      ///< after this time it marks where it is
};

} // namespace chiron::operators
