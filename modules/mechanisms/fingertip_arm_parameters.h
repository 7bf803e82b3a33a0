// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "mechanisms/lugre_friction.h"

#include <array>

namespace chiron::mechanisms {

/// P3's console arm: seven degrees of freedom a hand, three translations by absolute magnetic encoders, three wrist angles by
/// an inertial measurement unit (IMU), grasp by a Hall sensor (jaw.h). It has no motors. P3 prints no numbers: every value is an
/// ASSUMPTION unless a source is named. D, SI.
struct FingertipArmParameters {
    double mass_kg = 0.15;       ///< carried along; models.md §4, as other devices
    double inertia_kgm2 = 2.0e-4; ///< of the handle with the platforms, isotropic: 0.1 kg at a radius of 45 mm
    /// 0.1 N over 50 µm of presliding and 0.5 N·s/m along each axis (models.md §4).
    LugreParameters friction{0.1, 2000.0, 10.0, 0.5};
    double turningViscous_Nms_per_rad = 1.0e-3;

    /// m a count: 14 bits a turn on a pulley of 20 mm radius (2π·0.02/2¹⁴); the converter's noise lies below a count.
    double resolution_m = 7.6699e-6;
    core::Vec3 minimum_m{-0.15, -0.15, -0.05}; ///< travel, D
    core::Vec3 maximum_m{0.15, 0.15, 0.20};

    /// rad a count: 16 counts a degree, as fused 9-axis sensors of this class report angles (Bosch BNO055's data sheet).
    double imuResolution_rad = 1.0908307824964559e-3;
    /// 1 kHz: rate gyros of that class give so many readings, which carry the fused attitude on between its own 100 Hz. Told at 100 Hz, each
    /// step would be a spin of 50 rad/s to whoever takes velocity from it, and a second finger 18 mm aside would leave at 1 m/s.
    int imuPeriod_ticks = 1;
    double imuNoise_rad = 0.5e-3;        ///< SD each axis, correlated over imuNoiseTime_s: 0.03°
    double imuNoiseTime_s = 0.2;
    double imuDrift_rad = 8.7e-3;        ///< SD each axis of the slow part: 0.5°
    double imuDriftTime_s = 60.0;

    int substeps = 4; ///< integration steps a tick, ≥ 4 (4 kHz)
};

} // namespace chiron::mechanisms
