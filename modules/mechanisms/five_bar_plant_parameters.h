// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "mechanisms/five_bar_kinematics.h"
#include "mechanisms/lugre_friction.h"

#include <array>
#include <cstddef>

namespace chiron::mechanisms {

/// Parameters of P1's mechanism as a plant. From P1: 4.5 N in the plane, 150, 150 and 10 mN·m about the
/// endoscope, ±180° about its axis and ±30° about the others, tendons with capstans and all motors at the
/// base. From models.md §1.1: the zero of the pitch axis is the centre-line's direction at 33.2°; its travel
/// is ±63.1° about that zero, which keeps P1's ±30° about the centre-line at every position along it (0° at
/// the entrance to 66.2° at the bladder neck). Everything else is an ASSUMPTION (P1 prints no dimensions),
/// chosen so that the tip feels about like the device of models.md §4 (0.15…0.25 kg, 0.5 N·s/m). Axes are in
/// the order theta1, theta2, pitch, yaw, roll. All values are as seen at the joint, so a motor's values are
/// multiplied by its capstan's ratio (its inertia by the square). The tendons of the spherical joint run
/// through the centres of the elbows, and a parallelogram keeps its frame upright, so that the linkage's
/// motion moves no other axis.
struct FiveBarPlantParameters {
    static constexpr std::size_t kAxes = 5;
    using PerAxis = std::array<double, kAxes>;

    FiveBarGeometry geometry;
    double mountingPitch_rad = core::radFromDeg(33.2);

    // Links: uniform tubes. The joint mass is what moves with the tip but does not turn.
    double proximalMass_kg = 0.030;
    double distalMass_kg = 0.030;
    double jointMass_kg = 0.040;
    // Endoscope, held at its tip: a body of revolution with its centre of mass behind the tip.
    double endoscopeMass_kg = 0.080;
    double centreOfMassBehindTip_m = 0.10;
    double acrossInertia_kgm2 = 6.0e-4; ///< about its centre of mass: m·(0.3 m)²/12
    double axialInertia_kgm2 = 2.4e-5;  ///< shaft and handle
    /// Share of the total weight that counterweights carry (their inertia is contained in that of the
    /// rotors).
    double counterbalance = 0.9;

    // Tendons: pretensioned pairs of steel cable between capstan and joint. 1.5 mm rope (EA ≈ 67.5 kN), 0.2 m
    // long, drum radius 30 mm for the linkage; 0.9 mm rope (EA ≈ 22.5 kN), 0.6 m, drums of 15 and 10 mm for
    // the spherical joint: 2 EA r²/L. The drums measure 20 rope diameters and more, as steel rope needs. On
    // thinner ropes the rotors oscillate with friction (drivers/simulated/README.md).
    PerAxis tendonStiffness{607.5, 607.5, 16.9, 16.9, 7.5}; ///< N·m/rad
    /// N·m·s/rad, a tenth of critical with the rotor.
    PerAxis tendonDamping{0.090, 0.090, 8.0e-3, 8.0e-3, 1.0e-3};
    PerAxis rotorInertia{4.0e-4, 4.0e-4, 1.0e-4, 1.0e-4, 4.0e-6}; ///< kg·m², capstan ratios 10, 10, 10, 10, 2

    // Friction of motors and capstans: 0.1 N at the tip over 50 µm of presliding, 2 % and 3 % of the largest
    // torques.
    std::array<LugreParameters, kAxes> friction{
        LugreParameters{0.0125, 35.0, 0.10, 0.0100}, LugreParameters{0.0125, 35.0, 0.10, 0.0100},
        LugreParameters{0.003, 3.0, 3.0e-3, 1.0e-3}, LugreParameters{0.003, 3.0, 3.0e-3, 1.0e-3},
        LugreParameters{0.0003, 0.3, 1.0e-4, 2.0e-5}};

    /// Motor torques available for rendering, N·m: 4.5 N at the tip in the weakest direction of the weakest
    /// pose of the workspace (4.5 N times the longest column of J), and P1's torques.
    PerAxis renderLimit{0.641, 0.641, 0.150, 0.150, 0.010};
    /// Additional torque to carry the weight that the counterweights leave.
    PerAxis gravityReserve{0.060, 0.060, 0.012, 0.006, 0.0};
    double amplifierLag_s = 0.0003;
    bool gravityFeedForward = true;

    /// rad per count, on the motor axes through the capstans: 40960 counts per turn of the joint, at most
    /// 22 µm at the tip.
    PerAxis resolution{1.5339807878856412e-4, 1.5339807878856412e-4, 1.5339807878856412e-4,
                       1.5339807878856412e-4, 1.5339807878856412e-4};
    int sampleDelay_ticks = 0; ///< 0..3: age of the counts when the host reads them

    // Travel, rad, and the rubber stops at its ends (damping: half of critical with the lightest inertia
    // behind it).
    PerAxis minimum{core::radFromDeg(90.0), core::radFromDeg(-13.0), core::radFromDeg(-63.1),
                    core::radFromDeg(-30.0), -core::kPi};
    PerAxis maximum{core::radFromDeg(193.0), core::radFromDeg(90.0), core::radFromDeg(63.1),
                    core::radFromDeg(30.0), core::kPi};
    PerAxis stopStiffness{2000.0, 2000.0, 200.0, 200.0, 20.0}; ///< N·m/rad
    PerAxis stopDamping{1.0, 1.0, 0.5, 0.5, 0.01};             ///< N·m·s/rad, on the way in only

    int substeps = 4; ///< integration steps per tick, ≥ 4 (4 kHz)
};

} // namespace chiron::mechanisms
