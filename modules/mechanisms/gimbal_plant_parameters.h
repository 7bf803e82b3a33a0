// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/gimbal_kinematics.h"
#include "mechanisms/lugre_friction.h"

#include <array>
#include <cstdint>

namespace chiron::mechanisms {

/// Parameters of P2's gimbal as a plant. From P2: ±2.5 A that give about 3 N in each direction, roll
/// resolution of about 10°, 1 kHz. Everything else is an ASSUMPTION (P2 prints no dimensions), chosen so that
/// at the nominal depth of 0.18 m the tip feels like the device of models.md §4: 0.15 kg and 0.5 N·s/m in
/// each direction. Axes are in the order h, p, r, d.
struct GimbalPlantParameters {
    double pivotHeight_m = GimbalKinematics::kDefaultPivotHeight_m;

    // Instrument: a rod that slides through the pivot.
    double instrumentMass_kg = 0.08;
    double instrumentInertia_kgm2 = 1.07e-3; ///< about its centre of mass, across the rod: m·(0.4 m)²/12
    double centreOfMassBehindTip_m = 0.15;
    /// Rings, capstans and rotors, as seen at the axis: kg·m² for h, p, r; kg for d.
    std::array<double, 4> axisInertia{3.7e-3, 3.7e-3, 2.0e-5, 0.07};
    /// Share of the instrument's weight that a spring carries along the depth axis.
    double counterbalance = 0.9;

    // Friction at the tip at nominal depth: 0.1 N Coulomb over 50 µm of presliding, 0.5 N·s/m viscous.
    std::array<LugreParameters, 4> friction{
        LugreParameters{0.018, 64.8, 0.32, 0.0162}, LugreParameters{0.018, 64.8, 0.32, 0.0162},
        LugreParameters{0.001, 0.1, 0.0005, 0.0002}, LugreParameters{0.1, 2000.0, 10.0, 0.5}};

    // Motors: effort per ampere at the axis (N·m/A, N·m/A, –, N/A); roll has none.
    double currentLimit_A = 2.5;
    std::array<double, 4> effortPerAmpere{0.216, 0.216, 0.0, 1.2}; ///< 2.5 A ≙ 3 N at the tip at 0.18 m
    double amplifierLag_s = 0.0003;
    bool gravityFeedForward = true; ///< the motors carry the weight that the spring does not

    // Encoders: rad, rad, rad, m per count. 40960 counts per turn are 28 µm at the tip; roll has 10°, as in
    // P2.
    std::array<double, 4> resolution{1.5339807878856412e-4, 1.5339807878856412e-4, 0.17453292519943295,
                                     25e-6};
    std::array<double, 4> minimum{-0.7853981633974483, -0.7853981633974483, -3.141592653589793, 0.08};
    std::array<double, 4> maximum{0.7853981633974483, 0.7853981633974483, 3.141592653589793, 0.32};
    int sampleDelay_ticks = 0; ///< 0..3: age of the counts when the host reads them

    int substeps = 4; ///< integration steps per tick, ≥ 4 (4 kHz)
};

} // namespace chiron::mechanisms
