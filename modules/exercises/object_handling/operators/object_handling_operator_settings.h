// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "operators/laparoscopy/grasp_perception_settings.h"
#include "operators/laparoscopy/grasp_reach.h"

#include <string>

namespace chiron::operators {

/// One scripted laparoscopist at object handling: how it moves, squeezes, weighs and sets down. The values
/// are assumptions that are plausible for people; no gate of a level is tuned to them (README.md).
/// Unit: SI.
struct ObjectHandlingOperatorSettings {
    std::string name = "expert";
    GraspPerceptionSettings perception;
    mechanisms::HandParameters hand; ///< pass it on as SimulatedDevice::Configuration::hand
    GraspReachSettings reach;

    double attention_s = 0.05; ///< time between decisions; in between it continues what it is doing
    double reachSpeed_m_per_s = 0.06;
    double carrySpeed_m_per_s = 0.045;
    double lowerSpeed_m_per_s = 0.03; ///< while lowering to an object
    double moveGain_per_s = 2.0;      ///< of the remaining distance of a movement
    double aim_m = 0.002;             ///< distance from a position at which it is satisfied
    /// Distance from the target's middle at which it is satisfied before setting down.
    double placeAim_m = 0.0015;
    double settle_s = 0.25; ///< time that it waits once it is there

    double jawSpeed_rad_per_s = 0.8; ///< until the jaws touch
    double squeezeShare = 0.60;      ///< share of the allowed squeeze that it aims for
    /// How fast a wrong squeeze is corrected; bounded by the reaction delay.
    double squeezeGain_rad_per_Ns = 0.45;
    double squeezeSpeed_rad_per_s = 0.25; ///< at most
    /// Share of the wanted squeeze; a smaller deviation is left alone.
    double squeezeTolerance = 0.15;
    /// Flattening, as a share of the radius, that it aims for where no bar shows the squeeze.
    double flatteningShare = 0.20;
    double regripFactor = 1.25; ///< factor by which it squeezes more after the object slipped

    double clearance_m = 0.008; ///< carries this much higher than necessary
    double setDownSpeed_m_per_s = 0.010;
    /// Lets go when it feels that the bed carries the object; otherwise at a height that looks right …
    bool feelsTheBed = true;
    double releaseHeight_m = 0.0;     ///< … above where the object lay
    double openSpeed_rad_per_s = 0.5; ///< of the jaws while letting go

    double weighTime_s = 2.8; ///< feels each weight for this time …
    /// … while moving it up and down by this amount in either direction; 0: holds it still.
    double heft_m = 0.006;
    /// Weighs the two heaviest once more if they differ by less than this share; 0: never.
    double weighAgain = 0.20;
};

} // namespace chiron::operators
