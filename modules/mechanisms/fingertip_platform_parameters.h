// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/fingertip_kinematics.h"
#include "mechanisms/lugre_friction.h"

#include <array>

namespace chiron::mechanisms {

/// The finger's pad as a ball of radius R that the flat platform presses. With penetration δ
///   F = (a/β)(e^{βδ} − 1) + b δ˙ min(1, δ/0.2 mm), never below 0.
/// A plane against a viscoelastic ball with exponential stiffness is the form that Pawluk & Howe found for
/// 0–2 N (Dynamic contact of the human fingerpad against a flat surface, J. Biomech. Eng. 121(6), 1999,
/// 605–611). The numbers are ASSUMPTIONS: 0.3 N/mm at first touch, 1.8 N/mm at 1 N. The same authors found
/// that the pad's force relaxes (Dynamic lumped element response of the human fingerpad, J. Biomech. Eng.
/// 121(2), 1999, 178–183); share and times are ASSUMPTIONS too.
struct FingerPadParameters {
    double radius_m = 0.008;
    double stiffness_N_per_m = 300.0; ///< a
    double hardening_per_m = 1500.0;  ///< β
    double damping_Ns_per_m = 1.5;    ///< b
    /// z₀: height at which the level platform just touches; for a thick finger it is lower.
    double surface_m = 0.0;
    double relaxation = 0.0; ///< c: share of the elastic force that relaxes with time, 0..1
    std::array<double, 2> relaxationTimes_s{0.07, 1.4};

    static constexpr FingerPadParameters soft() noexcept { return {0.009, 150.0, 1000.0, 1.0}; }
    static constexpr FingerPadParameters stiff() noexcept { return {0.007, 900.0, 2500.0, 3.0}; }
};

/// Geared DC motor with pinion and rack, and the masses that it moves, all as seen along the rail. P3 prints
/// no numbers: ASSUMPTIONS for a micro motor with a planetary gear 26:1 and a pinion of 4 mm radius.
struct FingertipDriveParameters {
    double motorMass_kg = 0.040; ///< rotor, reflected: 1e-9 kg·m² · (26/4 mm)²
    /// Gear and rail: a tenth of the largest force, 12 µm of presliding.
    LugreParameters friction{0.25, 20000.0, 10.0, 1.0};
    /// At the motor's current limit (0.25 A · 10.4 N/A): three give 7.8 N for P3's 4 N.
    double forceLimit_N = 2.6;
    double amplifierLag_s = 0.0005;
    /// Of the gear at its output: 0.6°, as planetary micro gears have.
    double backlash_m = 40e-6;
    double gearStiffness_N_per_m = 5.0e4; ///< pinion and rack in plastic
    double gearDamping_Ns_per_m = 2.5;    ///< a tenth of critical
    double encoder_m = 15.1e-6;           ///< one count: 64 counts per motor turn
    double carriageMass_kg = 0.002;
    double platformMass_kg = 0.010;
    double jointDamping_Nms_per_rad = 5.0e-5;
    double bandStiffness_N_per_m = 20.0; ///< P3's elastic bands: they carry the weight at level and pull back
                                         ///< to it
};

/// Three force-sensitive resistors under the platform's plate, in voltage dividers. From P3: 10 bits at
/// 3.3 V, 4 N, and about 4 mN per count, which a divider that is at half of 3.3 V with 4 N gives at small
/// force (1/(1024·0.25 N⁻¹) = 3.9 mN). From Interlink's FSR 400 data sheet: part to part ±6 % (calibrated to
/// a third of it here), hysteresis 10 % of the load, drift below 5 % per decade of time; rated from 0.2 N,
/// hence the preload. The rest: ASSUMPTIONS.
struct FingertipForceSensorParameters {
    int adcBits = 10;
    double divider_per_N = 0.25;    ///< R_M/R_FSR per newton
    double preload_N = 0.20;        ///< of each resistor, by the plate's cover; removed by the tare
    double radius_m = 0.009;        ///< of the three positions under the plate
    double gainSd = 0.02;           ///< left by calibration, per sensor
    double exponentSd = 0.02;       ///< of conductance over force, about 1: calibration assumes 1
    double hysteresis = 0.05;       ///< half the loop's width over the change of load
    double hysteresisForce_N = 0.1; ///< force over which the hysteresis reverses
    double creep = 0.03;            ///< share of the load that is shown late
    double creepTime_s = 3.0;
    /// SD of the summed force at small load, white, per reading: contact noise of the film.
    double noise_N = 0.004;
    double adcNoise_counts = 0.5; ///< SD per reading
    int period_ticks = 2;         ///< 500 Hz
    int delay_ticks = 2;          ///< from sampling to the controller: conversion, filter and bus
};

/// The IMU on the platform. ASSUMPTIONS for a sensor of the class named in attitude_sensor.h.
struct FingertipImuParameters {
    double bias_rad = 8.7e-3;  ///< SD per angle, constant: mounting and calibration, 0.5°
    double noise_rad = 3.5e-3; ///< SD per angle, 0.2°
    double noiseTime_s = 0.1;
    int period_ticks = 10; ///< 100 Hz
};

/// The control loops. Position: PID on the three drives through the inverse kinematics, 1 kHz. Force: PD on
/// the summed force, 500 Hz; its output is the rate at which the wanted height moves, so that gear friction
/// leaves no lasting error. P3 names PID and PD but no gains: these are ours. The plant's numbers here (mass,
/// friction, delay) are what its maker would state; the controller does not know those of the simulated
/// plant.
struct FingertipControlParameters {
    double proportional_N_per_m = 2500.0;
    double integral_N_per_ms = 6.0e4;
    double derivative_Ns_per_m = 16.0;
    double derivativeFilter_s = 0.0006;
    double integralLimit_N = 1.5;
    double forceBandwidth_rad_per_s = 30.0; ///< Kp = this / assumed stiffness of the pad
    /// Smallest assumed stiffness: a finger may be three times stiffer than measured.
    double leastStiffness_N_per_m = 900.0;
    double forceDerivative_s = 0.004;
    double correctionLimit_m = 0.0025;   ///< largest correction of the wanted height by the force loop
    double clearance_m = 0.0003;         ///< between platform and pad when nothing is displayed
    double fastest_m_per_s = 0.15;       ///< of the wanted height
    double fastest_rad_per_s = 7.0;      ///< of the wanted angles: 400°/s
    double acceleration_m_per_s2 = 12.0; ///< of the wanted depth: a sixth of what the motors could give
    /// Of the wanted angles. A tremor of 8 to 12 Hz over a lump requests ±6° at its own rate, through an IMU
    /// that steps at 100 Hz. At 400 rad/s² the true lean in palpation was off by 1.5°, at 1000 by 0.8°.
    double acceleration_rad_per_s2 = 1000.0;
    /// Stiffness of the pad above which the angles turn more slowly, in proportion to the stiffness.
    double turningStiffness_N_per_m = 3000.0;
    double approach_per_s = 180.0;      ///< rate of the final approach
    double smoothing_per_s = 600.0;     ///< rate at which the wanted speed is reached
    double leanApproach_per_s = 540.0;  ///< the same two for the angles, which overshoot less than a
                                        ///< force: a third of the lag
    double leanSmoothing_per_s = 990.0; ///< below 1 per tick, where it would begin to oscillate
    double fastest_N_per_s = 100.0;     ///< of the wanted force upwards: limits what arrives within the
                                        ///< sensors' delay
    /// Limit of the three motors together, along the pad, whatever the sensors report: what the pad may get,
    /// less what its movement adds. At 4.3 N a pad twice as stiff as assumed got 4.03 N while the platform
    /// turned; at 3.9 N friction kept the force from reaching 3.4 N.
    double pressingLimit_N = 3.95;
    double movedMass_kg = 0.136; ///< rotors, carriages and platform, along z; a third on each drive
    double friction_N = 0.16;    ///< fed forward on each drive: less than the real friction, so
                                 ///< that it never pushes by itself
    /// Speed over which it reverses: at 2 mm/s a pad three times stiffer than assumed rippled.
    double frictionTurns_m_per_s = 0.003;
    /// Removed from the readings: half of what the data sheet suggests, since a force that is held reverses
    /// it gradually.
    double sensorHysteresis = 0.025;
    double sensorHysteresisForce_N = 0.3; ///< of the three together
    int senseDelay_ticks = 4;             ///< mean delay from the pad to the reading, half a sampling
                                          ///< period included
    double padLimit_N = 4.0;              ///< P3: never more than this on the pad
    /// Share by which the pad may get more than the resistors report: three times the gain's SD over √3
    /// (3.5 %), hysteresis (5 %), creep (3 %), and 3 % for the force of a relaxing pad while it is pressed
    /// fast. The wanted force is limited to padLimit_N/(1 + this).
    double forceDoubt = 0.15;
    /// Added while the platform turns: gear friction reverses, a quarter newton on 2.5 N/mm of each drive.
    double turningDoubt = 0.40;
    /// The finger as the controller assumes it: identified when it is put on.
    FingerPadParameters pad;
};

struct FingertipPlatformParameters {
    FingertipGeometry geometry;
    FingertipDriveParameters drive;
    FingertipForceSensorParameters force;
    FingertipImuParameters imu;
    FingertipControlParameters control;
    FingerPadParameters pad; ///< the real finger
    /// Integration steps per tick, ≥ 8 (8 kHz), because the gear's stiffness requires it.
    int substeps = 8;
};

} // namespace chiron::mechanisms
