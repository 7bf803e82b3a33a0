// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "operators/laparoscopy/grasp_perception_settings.h"
#include "operators/laparoscopy/grasp_reach.h"

#include <string>

namespace chiron::operators {

/// One scripted laparoscopist at the elastic tube: how it moves, grasps and minds tension. Assumptions, plausible for people; no
/// gate of a level is tuned to them (README.md). SI.
struct ElasticTubeOperatorSettings {
    std::string name = "expert";
    GraspPerceptionSettings perception;
    mechanisms::HandParameters hand; ///< give it to SimulatedDevice::Configuration::hand
    GraspReachSettings reach;

    double attention_s = 0.05;      ///< decides anew so often; in between it goes on with what it does
    double reachSpeed_m_per_s = 0.06;
    double moveGain_per_s = 2.0;    ///< of what is left of a free movement
    double aim_m = 0.003;           ///< closes the jaw this near to the grip
    double settle_s = 0.15;         ///< keeps still there before it does
    double jawSpeed_rad_per_s = 2.0;
    double openJaw_rad = 0.7;
    double heldJaw_rad = 0.05;      ///< how tightly it keeps the jaw shut …
    double jawUnsteadySd_rad = 0.0; ///< … and how much that wanders over three seconds: a loose hand lets slip

    double pullSpeed_m_per_s = 0.015;   ///< stretches with this speed at most
    double correctionRate_per_s = 1.3;  ///< of a wrong tension, in its own time: bounded by the reaction delay
    double assumedStiffness_N_per_m = 40.0; ///< what it takes a tube to be like …
    bool learnsStiffness = true;        ///< … unless it notices how this one answers
    double deadZone = 0.15;             ///< leaves a wrong tension alone below this share of the band
    double searchSpeed_m_per_s = 0.005; ///< pulls slowly where it has to find out what is wanted
    double longestRatio = 1.65;         ///< goes no further than so long, over its rest length
    double bringSpeed_m_per_s = 0.03;   ///< leads the end to its target
    double retractShare = 0.5;          ///< how hard it holds a fold back: 0 the low, 1 the high end of its band
};

} // namespace chiron::operators
