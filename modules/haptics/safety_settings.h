// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::haptics {

/// All numbers of the supervisor's table (models.md §5). They are stored with each session, so that a replay
/// uses the numbers of that session. Trivially copyable. One tick is 1 ms of the executed loop.
/// SafetySupervisor::configure checks the ranges and refuses a value outside them.
struct SafetySettings {
    // Caps: the smallest of the device's rating, the exercise's cap and the site's cap applies.
    double siteForce_N = 4.0;         ///< > 0; models.md §5
    double siteTorque_Nm = 0.150;     ///< > 0; models.md §5
    double exerciseForce_N = 4.0;     ///< > 0; from the level's content
    double exerciseTorque_Nm = 0.150; ///< > 0; from the level's content
    /// Share of the cap, 0 … 0.5: from 1 − this on a force bends into the cap (bentToCap); 0: it is cut off.
    double capKnee = 0.0;

    // Slew, on rising magnitude and on direction; decreases are exempt.
    double slewForce_N_per_ms = 2.0;     ///< > 0; models.md §5
    double slewTorque_Nm_per_ms = 0.100; ///< > 0; models.md §5

    // Arming.
    double armingForce_N = 0.2;          ///< requested force below this ...
    double armingTorque_Nm = 0.010;      ///< ... and torque below this ...
    std::uint32_t armingQuiet_ticks = 4; ///< ... for so many ticks in a row, or:
    double stillSpeed_m_per_s = 0.005;   ///< confirmed (dead-man or "Resume here") and slower than this ...
    std::uint32_t stillTime_ms = 500;    ///< ... for so long without a break
    std::uint32_t armingRamp_ms = 2000;  ///< then the gain rises from 0 to 1 in this time

    // Over-velocity, speed of the tool in the device's frame.
    double overVelocity_m_per_s = 1.0;         ///< > this: damping only, latched until re-armed
    double overVelocityDamping_Ns_per_m = 5.0; ///< assumption; never above the device's maximumDamping

    // Sample sanity.
    double quaternionTolerance = 0.01;   ///< |‖q‖ - 1| above this is bad
    double jump_m = 0.020;               ///< a larger step within one device period is bad
    std::uint32_t badPacketsToFault = 3; ///< in a row

    // Watchdog; P is the device's declared period.
    std::uint32_t watchdogStart_us = 5000; ///< the ramp down starts at max(this, startPeriods·P)
    std::uint32_t watchdogStartPeriods = 3;
    std::uint32_t watchdogRamp_us = 10000;  ///< force is zero this much later
    std::uint32_t watchdogFault_us = 30000; ///< latched fault at max(this, faultPeriods·P)
    std::uint32_t watchdogFaultPeriods = 10;
    std::uint32_t slowestRendering_us = 4000; ///< a device with a longer period may not render force
    std::uint32_t noMovement_us = 2000000;    ///< input-only devices report "no movement" after this; never a
                                              ///< fault

    // Frozen window and pause.
    bool heartbeatWatched = true;          ///< false without a window (headless)
    std::uint32_t heartbeatLimit_ms = 250; ///< from this age of the newest heartbeat on, force ramps to zero
                                           ///< ...
    std::uint32_t heartbeatRamp_ms = 500;  ///< ... within this time (from full gain)
    std::uint32_t pauseRamp_ms = 500;

    // Passivity.
    double passivityExcess_J = 0.001; ///< energy returned beyond what was supplied; above this, damping is
                                      ///< injected
    /// Below this speed nothing is injected, because the estimate is encoder noise.
    double passivityMinimumSpeed_m_per_s = 0.001;
};

} // namespace chiron::haptics
