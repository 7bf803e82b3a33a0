// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "operators/laparoscopy/grasp_perception_settings.h"
#include "operators/laparoscopy/grasp_reach.h"

#include <string>

namespace chiron::operators {

/// One scripted laparoscopist at the elastic tube: how it moves, grasps and controls tension. The values are
/// assumptions that are plausible for people; no gate of a level is tuned to them (README.md).
/// Unit: SI.
struct ElasticTubeOperatorSettings {
    std::string name = "expert";
    GraspPerceptionSettings perception;
    mechanisms::HandParameters hand; ///< pass it on as SimulatedDevice::Configuration::hand
    GraspReachSettings reach;

    double attention_s = 0.05; ///< time between decisions; in between it continues what it is doing
    double reachSpeed_m_per_s = 0.06;
    double moveGain_per_s = 2.0; ///< of the remaining distance of a free movement
    double aim_m = 0.003;        ///< closes the jaw within this distance of the grip
    double settle_s = 0.15;      ///< keeps still there for this time before it closes
    double jawSpeed_rad_per_s = 2.0;
    double openJaw_rad = 0.7;
    double heldJaw_rad = 0.05; ///< opening of the jaw with which it holds …
    /// … and how much that wanders over three seconds: a loose hand lets the tube slip.
    double jawUnsteadySd_rad = 0.0;

    double pullSpeed_m_per_s = 0.015;       ///< greatest speed of stretching
    double correctionRate_per_s = 1.3;      ///< of a wrong tension; bounded by the reaction delay
    double assumedStiffness_N_per_m = 40.0; ///< the stiffness that it assumes of a tube …
    bool learnsStiffness = true;            ///< … unless it observes how this one responds
    double deadZone = 0.15;                 ///< tolerates a wrong tension below this share of the band
    /// Pulls at this low speed where it has to find out which tension is wanted.
    double searchSpeed_m_per_s = 0.005;
    double longestRatio = 1.65;       ///< stretches no further than this length over rest length
    double bringSpeed_m_per_s = 0.03; ///< speed with which it leads the end to its target
    /// Pull with which it holds a fold back: 0 is the low, 1 the high end of its band.
    double retractShare = 0.5;
};

} // namespace chiron::operators
