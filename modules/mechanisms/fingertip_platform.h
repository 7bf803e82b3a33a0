// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "mechanisms/fingertip_controller.h"
#include "mechanisms/fingertip_sensors.h"

#include <cstdint>

namespace chiron::mechanisms {

/// P3's fingertip platform under a finger: plant, sensors and control loops, stepped by the tick. The same
/// commands and the same seed give the same bits. Source: P3 §2.1; devices.md §5.
/// Thread: haptic; allocates nothing.
class FingertipPlatform {
public:
    FingertipPlatform(const FingertipPlatformParameters& parameters, std::uint64_t seed) noexcept;

    void reset() noexcept; ///< off, level, just clear of the pad; sensors tared
    /// Runs one tick of 1 ms. `wanted` is to be displayed; with `enabled` false the motors are off.
    void tick(const core::DisplayPose& wanted, bool enabled) noexcept;

    const core::DisplayPose& truth() const noexcept { return m_truth; }   ///< the true action on the pad
    double sensedForce_N() const noexcept { return m_force.force_N(); }   ///< from the three resistors
    double sensedPitch_rad() const noexcept { return m_imu.pitch_rad(); } ///< from the platform's IMU
    double sensedRoll_rad() const noexcept { return m_imu.roll_rad(); }
    bool saturated() const noexcept { return m_saturated; } ///< a motor ran at its limit in the last tick

    /// Moves the finger in its holder, along z, m; a negative value is towards the platform.
    void shiftFinger(double up_m) noexcept { m_plant.shiftFinger(up_m); }
    const FingertipPlant& plant() const noexcept { return m_plant; }
    const FingertipForceSensors& forceSensors() const noexcept { return m_force; }

private:
    core::Vec3 encoders() const noexcept;

    FingertipPlatformParameters m_parameters;
    FingertipPlant m_plant;
    FingertipForceSensors m_force;
    FingertipImu m_imu;
    FingertipController m_controller;
    core::DisplayPose m_truth;
    bool m_saturated = false;
    bool m_fresh = false;
};

} // namespace chiron::mechanisms
