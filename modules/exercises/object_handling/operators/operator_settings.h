// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "operators/laparoscopy/grasp_perception_settings.h"
#include "operators/laparoscopy/grasp_reach.h"

#include <string>

namespace chiron::operators {

/// One scripted laparoscopist at object handling: how it moves, squeezes, weighs and sets down. Assumptions, plausible for
/// people; no gate of a level is tuned to them (README.md). SI.
struct ObjectHandlingOperatorSettings {
    std::string name = "expert";
    GraspPerceptionSettings perception;
    mechanisms::HandParameters hand; ///< give it to SimulatedDevice::Configuration::hand
    GraspReachSettings reach;

    double attention_s = 0.05;   ///< decides anew so often; in between it goes on with what it does
    double reachSpeed_m_per_s = 0.06;
    double carrySpeed_m_per_s = 0.045;
    double lowerSpeed_m_per_s = 0.03; ///< down to an object
    double moveGain_per_s = 2.0; ///< of what is left of a movement
    double aim_m = 0.002;        ///< content with a place this near
    double placeAim_m = 0.0015;  ///< content with where it sets something down this near to the middle
    double settle_s = 0.25;      ///< once it is there

    double jawSpeed_rad_per_s = 0.8;        ///< until the jaws touch
    double squeezeShare = 0.60;             ///< of the allowed squeeze that it wants
    double squeezeGain_rad_per_Ns = 0.45;   ///< how fast a wrong squeeze is corrected: bounded by the reaction delay
    double squeezeSpeed_rad_per_s = 0.25;   ///< at most
    double squeezeTolerance = 0.15;         ///< of what it wants: left alone
    double flatteningShare = 0.20;          ///< of the radius that it wants to see, where no bar shows the squeeze
    double regripFactor = 1.25;             ///< squeezes so much more after it slipped

    double clearance_m = 0.008;    ///< carries higher than it has to by
    double setDownSpeed_m_per_s = 0.010;
    bool feelsTheBed = true;       ///< lets go when the bed is felt to carry; else at a height that looks right …
    double releaseHeight_m = 0.0;  ///< … over where it lay
    double openSpeed_rad_per_s = 0.5; ///< lets go

    double weighTime_s = 2.8;     ///< feels each weight for so long …
    double heft_m = 0.006;        ///< … moving it up and down by so much, either way; 0: holds it still
    double weighAgain = 0.20;     ///< weighs the two heaviest once more if they differ by less than this share; 0: never
};

} // namespace chiron::operators
