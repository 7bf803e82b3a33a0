// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"
#include "modules/exercises/urethra_insertion/operators/endoscope_perception_settings.h"

#include <string>

namespace chiron::operators {

/// How an endoscopist turns the instrument while it advances.
enum class SteeringKind {
    /// Turns while it advances, along the arc that leads to where it sees the lumen (pure pursuit).
    followsCurve,
    turnsInPlace, ///< stops to turn, and advances without turning (P1: "orientation changes without
                  ///< translation")
    /// Keeps turning until the lumen is in the middle of the picture, which anticipates the bend.
    centres,
    centresLate, ///< turns only once the lumen is far off the middle, and then turns too far
};

/// One scripted endoscopist: how it moves, turns and reacts to force. The values are assumptions that are
/// plausible for people; nothing is fitted to a measurement, and gates of levels are not tuned to them
/// (README.md).
/// Unit: SI.
struct UrethraInsertionOperatorSettings {
    std::string name = "expert";
    EndoscopePerceptionSettings perception;
    mechanisms::HandParameters hand; ///< pass it on as SimulatedEndoscopeDevice::Configuration::hand

    SteeringKind steering = SteeringKind::turnsInPlace;
    double insertSpeed_m_per_s = 0.006;
    double withdrawSpeed_m_per_s = 0.008;
    /// followsCurve: factor on the arc's curvature; over 1 for an operator who knows that the bend is
    /// sharpest at its beginning.
    double curveGain = 1.3;
    double turnGain_per_s = 1.2;     ///< of the angle off the middle that it sees
    double turnRate_rad_per_s = 0.3; ///< fastest turn while it advances
    double deadZone_rad = 0.0;       ///< centresLate: a smaller angle off the middle is left alone …
    double overshoot_rad = 0.0;      ///< … and it turns until the lumen is this far off on the other side
    /// If the lumen is farther off, it stops, turns and then goes on; an aligned endoscope sees it 0.23 off
    /// in P1's bend.
    double stopAngle_rad = 0.30;
    /// Felt force across at which it goes back a little and tries again; 0: never.
    double drawsBackAt_N = 0.0;
    bool stopsBlind = true; ///< does not advance while the picture shows only wall

    /// Felt resistance at which it stops advancing; it slows down from half of that.
    double pushLimit_N = 3.0;
    double acrossLimit_N = 1.5; ///< the same of force across the instrument
    /// Speed with which it yields to force across the instrument; 0: does not yield.
    double reliefGain_m_per_Ns = 0.008;
    double reliefTurn_rad_per_Nms = 3.0; ///< rate with which it yields to torque

    double lookRate_rad_per_s = 0.35; ///< rate of turning towards a landmark
    /// Satisfied when a landmark is this near to the middle; the task asks for 15°.
    double lookWithin_rad = 0.19;
    double searchAngle_rad = 0.35; ///< searches in circles that grow to this angle
    bool stopsWhenCounted = true;  ///< stops turning once the screen says that the landmark counts
    /// While withdrawing, turns for the position that it will reach this much later.
    double anticipation_s = 0.5;
    /// While withdrawing, moves across as long as the lumen is not where it was; 0: does not look.
    double centringGain_per_s = 0.8;
    /// Turns back to how it held the instrument on the way in before it withdraws.
    bool alignsBeforeWithdrawal = true;
};

} // namespace chiron::operators
