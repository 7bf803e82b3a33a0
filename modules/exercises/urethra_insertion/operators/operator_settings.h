// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "modules/exercises/urethra_insertion/operators/perception_settings.h"

#include <string>

namespace chiron::operators {

/// How an endoscopist turns the instrument while it advances.
enum class SteeringKind {
    followsCurve, ///< turns as it advances, along the arc that leads to where the lumen is seen (pure pursuit)
    turnsInPlace, ///< stops to turn, and advances without turning (P1: "orientation changes without translation")
    centres,      ///< keeps turning until the lumen is in the picture's middle, which leads the bend
    centresLate,  ///< turns only once the lumen has wandered far off, and then too far
};

/// One scripted endoscopist: how it moves, turns and minds force. Assumptions, plausible for people; nothing is fitted to a
/// measurement, and gates of levels are not tuned to them (README.md). SI.
struct UrethraInsertionOperatorSettings {
    std::string name = "expert";
    EndoscopePerceptionSettings perception;
    mechanisms::HandParameters hand; ///< give it to SimulatedEndoscopeDevice::Configuration::hand

    SteeringKind steering = SteeringKind::turnsInPlace;
    double insertSpeed_m_per_s = 0.006;
    double withdrawSpeed_m_per_s = 0.008;
    double curveGain = 1.3;          ///< followsCurve: of the arc's curvature; over 1 for one who knows that the bend begins sharpest
    double turnGain_per_s = 1.2;     ///< of what is seen off the middle
    double turnRate_rad_per_s = 0.3; ///< the fastest it turns while it advances
    double deadZone_rad = 0.0;       ///< centresLate: off the middle by less is left alone …
    double overshoot_rad = 0.0;      ///< … and it turns until it is this far off on the other side
    double stopAngle_rad = 0.30;     ///< with the lumen further off it stops, turns, and then goes on; aligned in P1's bend it is 0.23 off
    double drawsBackAt_N = 0.0;      ///< felt force across at which it goes back a little and tries anew; 0: never
    bool stopsBlind = true;          ///< does not advance while the picture shows wall alone

    double pushLimit_N = 3.0;   ///< felt resistance at which it goes no further; half of that begins to slow it down
    double acrossLimit_N = 1.5; ///< the same of force across the instrument
    double reliefGain_m_per_Ns = 0.008;  ///< gives way to force across the instrument; 0: does not
    double reliefTurn_rad_per_Nms = 3.0; ///< gives way to torque

    double lookRate_rad_per_s = 0.35;   ///< turning towards a landmark
    double lookWithin_rad = 0.19;       ///< content with a landmark this near the middle; the task asks for 15°
    double searchAngle_rad = 0.35;      ///< looks round in circles growing to this
    bool stopsWhenCounted = true;       ///< turns no further once the screen says that the landmark counts
    double anticipation_s = 0.5;        ///< withdrawing, turns for where it will be so much later
    double centringGain_per_s = 0.8;    ///< withdrawing, moves across while the lumen is not where it was; 0: does not look
    bool alignsBeforeWithdrawal = true; ///< turns back to how it held the instrument before it withdraws
};

} // namespace chiron::operators
