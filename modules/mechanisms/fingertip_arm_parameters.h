// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "mechanisms/attitude_sensor.h"
#include "mechanisms/jaw.h"
#include "mechanisms/lugre_friction.h"
#include "mechanisms/serial_chain.h"

#include <array>
#include <cstddef>

namespace chiron::mechanisms {

/// Lengths of the arm, m, D. P3 prints none (its figure 2 is a drawing without measures): ASSUMPTIONS. The
/// shoulder lies beyond the table and above it, so that the arm comes from the front and leaves the hand
/// free. The lengths give a reach of 0.62 m, so that over a travel of 0.30 × 0.30 × 0.25 m the elbow stays at
/// least 38° away from both stretched and folded.
struct FingertipArmGeometry {
    core::Vec3 shoulder_D{0.0, 0.34, 0.20}; ///< intersection of the first two axes
    double upper_m = 0.32;                  ///< shoulder to elbow
    double fore_m = 0.32;                   ///< elbow to the intersection of the wrist's three axes, which is
                                            ///< the pad of the index finger
};

/// P3's console arm: "a 7DoF serial link manipulator". An IMU measures three of its degrees of freedom at the
/// wrist, three absolute magnetic encoders measure three translations of the end-effector, and a Hall sensor
/// measures the grasp. So three joints carry the end-effector (yaw, shoulder, elbow), three turn it (pitch,
/// roll, yaw, through one point), and the seventh opens the jaw. Six of them determine the pose, without
/// redundancy. The arm has no motors. P3 prints no numbers, so every value is an ASSUMPTION unless a source
/// is named.
/// Unit: SI.
/// Frame: D.
struct FingertipArmParameters {
    static constexpr int kJoints = 7;
    /// Joints with an encoder: yaw about z, shoulder and elbow about x, for an arm stretched towards −y.
    static constexpr int kArm = 3;
    static constexpr int kWrist = 3;  ///< first joint of the wrist: about x, y, z
    static constexpr int kHandle = 5; ///< the link that is T
    static constexpr int kJaw = 6;    ///< the lever of the grasp, about z on the handle; it closes across the
                                      ///< finger
    using PerJoint = std::array<double, kJoints>;

    FingertipArmGeometry geometry;

    // Links: carbon tubes with a bearing at either end; a wrist of two light rings; the handle with platform
    // and motors.
    double columnMass_kg = 0.25;
    double columnInertia_kgm2 = 2.0e-4;
    double upperMass_kg = 0.09;
    double foreMass_kg = 0.06;
    double ringMass_kg = 0.015; ///< each of two
    double ringRadius_m = 0.045;
    double handleMass_kg = 0.075;
    double handleRadius_m = 0.035;                 ///< radius of gyration, isotropic
    core::Vec3 handleCentre_T{0.0, -0.012, 0.012}; ///< centre of mass, from the pad, T
    double leverMass_kg = 0.010;
    core::Vec3 leverPivot_T{0.0, -0.060, 0.0}; ///< T
    double leverLength_m = 0.060;
    /// Share of the total weight that springs at shoulder and elbow and weights at the wrist carry. Friction
    /// holds the rest when no hand does.
    double counterbalance = 0.98;

    /// 0.06 N over 50 µm of presliding and 0.5 N·s/m at the pad in the middle of the travel (models.md §4),
    /// plus the bearings of the wrist.
    std::array<LugreParameters, kJoints> friction{
        LugreParameters{0.020, 120.0, 0.60, 0.050},   LugreParameters{0.020, 120.0, 0.60, 0.050},
        LugreParameters{0.020, 120.0, 0.60, 0.050},   LugreParameters{4.0e-4, 0.4, 2.0e-3, 1.0e-3},
        LugreParameters{4.0e-4, 0.4, 2.0e-3, 1.0e-3}, LugreParameters{4.0e-4, 0.4, 2.0e-3, 1.0e-3},
        LugreParameters{1.0e-3, 1.0, 2.0e-3, 5.0e-4}};

    // Travel, rad, with rubber stops at its ends. The elbow bends one way only, which selects one of the two
    // postures for a position.
    PerJoint minimum{core::radFromDeg(-70.0),
                     core::radFromDeg(-85.0),
                     core::radFromDeg(30.0),
                     core::radFromDeg(-170.0),
                     core::radFromDeg(-75.0),
                     core::radFromDeg(-170.0),
                     0.0};
    PerJoint maximum{core::radFromDeg(70.0),
                     core::radFromDeg(60.0),
                     core::radFromDeg(155.0),
                     core::radFromDeg(120.0),
                     core::radFromDeg(75.0),
                     core::radFromDeg(170.0),
                     1.6};
    PerJoint stopStiffness{2000.0, 2000.0, 2000.0, 5.0, 5.0, 5.0, 10.0}; ///< N·m/rad
    PerJoint stopDamping{4.0, 4.0, 4.0, 0.01, 0.01, 0.01, 0.005};        ///< N·m·s/rad, on the way in only

    // Fingers on the lever: a light pinch, N·m/rad and N·m·s/rad.
    double fingerStiffness_Nm_per_rad = 1.5;
    double fingerDamping_Nms_per_rad = 0.006;

    /// Absolute magnetic encoders of the three arm joints: 18 bits per turn, as ring sensors with two tracks
    /// give; 8 µm at the pad in the middle of the travel. (With the 14 bits of a sensor on the shaft's end a
    /// count would be 0.13 mm at the pad: tests/damping/README.md.)
    int encoderBits = 18;
    double encoderNoise_counts = 0.2; ///< SD, white
    /// Integral nonlinearity from an off-centre magnet: amplitudes of the terms once and twice per turn, rad.
    std::array<double, 2> encoderRunout_rad{3.5e-4, 1.5e-4};

    AttitudeSensorParameters imu;
    JawParameters grasp; ///< Hall sensor and fingers

    // The box of pad positions that sessions use, D. The joints' own travel goes beyond it.
    core::Vec3 boxMinimum_m{-0.15, -0.15, -0.05};
    core::Vec3 boxMaximum_m{0.15, 0.15, 0.20};

    int substeps = 4; ///< integration steps per tick, ≥ 4 (4 kHz)

    double encoderResolution_rad() const noexcept {
        return 2.0 * core::kPi / static_cast<double>(1L << encoderBits);
    }
};

} // namespace chiron::mechanisms
