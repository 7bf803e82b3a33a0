// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "operators/hand/perception_settings.h"

#include <string>

namespace chiron::operators {

/// How a trainee looks for the apex once it has climbed onto something.
enum class ApexTechniqueKind {
    wander,         ///< moves about and remembers where it felt highest
    midpoints,      ///< sweeps across in x, then in y, from slope to slope, and takes the middles
    slopeCrossings, ///< short sweeps to and fro, fits felt slope against felt place, goes where it is zero;
                    ///< repeats
};

/// One scripted trainee: how it moves, presses, searches and when it is content. Assumptions, plausible for
/// people. The noises were set first and never changed; speeds, gains and techniques were revised while the
/// trainees fell off the ball, and the expert's fit once when it did no better than the intermediate
/// (README.md). Nothing is fitted to P2's 14.2 %. SI.
struct SphereApexOperatorSettings {
    std::string name = "expert";
    PerceptionSettings perception;
    mechanisms::HandParameters hand; ///< give it to SimulatedDevice::Configuration::hand
    ApexTechniqueKind technique = ApexTechniqueKind::slopeCrossings;

    double reachSpeed_m_per_s = 0.15;  ///< free movements
    double lowerSpeed_m_per_s = 0.04;  ///< down to the table
    double scanSpeed_m_per_s = 0.08;   ///< lines above the table, looking for something
    double climbSpeed_m_per_s = 0.025; ///< up what was found
    double sweepSpeed_m_per_s = 0.010; ///< over its top

    double startHeight_m = 0.050; ///< how far above the table the tool begins, as the trainee was told
    double scanRadius_m = 0.055;  ///< the exercise's workspace, as the trainee was told
    double scanHeight_m = 0.009;  ///< above where the table was felt
    double scanSpacing_m = 0.020; ///< between lines

    double force_N = 1.0;              ///< that it wants to feel
    bool controlsForce = true;         ///< false: holds a depth instead, whatever that presses
    double pressDepth_m = 0.0;         ///< with controlsForce false: further down than where it stood
    double forceGain_m_per_Ns = 0.006; ///< how fast a wrong force is corrected; bounded by the reaction delay

    double topSlope = 0.34;          ///< felt lateral share of the force that counts as "on top" (20°)
    double edgeSlope = 0.5;          ///< midpoints: where a sweep turns (30°)
    double sweepHalfWidth_m = 0.009; ///< slopeCrossings: of the first cross
    int crosses = 2;                 ///< slopeCrossings: so many, and one more if the last moved the apex far
    double wanderRadius_m = 0.014;   ///< wander: how far about
    double wanderTime_s = 6.0;       ///< wander: for how long
    double settle_s = 0.3;           ///< keeps still before it marks
    double patience_s = 50.0;        ///< then it marks where it is
};

} // namespace chiron::operators
