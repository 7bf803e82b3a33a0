// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace chiron::devices {

enum class AxisUnit { metre, radian };

/// One generalised coordinate of a tool.
struct AxisDescriptor {
    std::string id; ///< snake_case, e.g. "heading", "x"
    AxisUnit unit = AxisUnit::metre;
    double resolution = 1e-6; ///< m or rad per count
    double minimum = 0.0;     ///< m or rad
    double maximum = 0.0;
    /// Effort in N or N·m that the axis can give continuously; 0 = not actuated.
    double continuousRating = 0.0;
    /// Of the axis, as identified, N or N·m; 0 = unknown, and not compensated.
    double coulombFriction = 0.0;
    double viscousFriction = 0.0; ///< the same, N·s/m or N·m·s/rad
};

/// Largest share of the Coulomb friction that may be fed forward, because friction that was identified within
/// 1 % (mechanisms/friction_identification.h) changes by a tenth and more with temperature, load and wear,
/// and overcompensation moves the tool by itself.
inline constexpr double kMostFrictionCompensation = 0.8;

/// How the scores of devices are grouped: force that can be felt is never compared with force that is only
/// shown.
enum class DeviceClass { felt, shown };

/// The age that applies to a device that states none, as before descriptors had one: 3 ticks, the longest
/// delay that a simulated mechanism can be given.
inline constexpr std::uint32_t kUsualOldestSample_us = 3000;

/// Describes what a device is and can do. It is stored with each session, and the kinematics can be made from
/// it again.
struct DeviceDescriptor {
    std::string driver;                       ///< catalogue id: simulated, keyboard_mouse, replay
    std::string model;                        ///< for people
    std::string kinematics;                   ///< one of the ids that makeKinematics() knows
    std::vector<double> kinematicsParameters; ///< their meaning depends on the kinematics id
    std::vector<AxisDescriptor> axes;         ///< 1..kMaxCoordinates
    double jawResolution_rad = 0.0;
    bool rendersForce = false;
    bool measuresForce = false;
    bool inProcess = false;         ///< stepped in the tick, age 0
    std::uint32_t period_us = 1000; ///< P: declared time between packets
    double maximumForce_N = 0.0;    ///< continuous, any direction; 0 = none
    double maximumTorque_Nm = 0.0;
    /// b_max (models.md §0, §8): the largest total damping of this mechanism, with friction's slope,
    /// viscosity, contact damping and injected damping added up. Measured, with margin
    /// (tests/damping/README.md).
    double maximumDamping_Ns_per_m = 50.0;
    /// Share of the axes' Coulomb friction that is fed forward, 0..kMostFrictionCompensation; 0 = off. The
    /// loop uses no more than that (haptics/friction_compensation.h).
    double frictionCompensation = 0.0;
    /// Age of the oldest samples that the device sends as new ones.
    std::uint32_t oldestSample_us = kUsualOldestSample_us;
    /// As the driver reads it from the device (for a HID device, the string in its descriptor); empty if the
    /// device reports none, as simulated ones do.
    std::string serialNumber{};
    DeviceClass deviceClass() const { return rendersForce ? DeviceClass::felt : DeviceClass::shown; }
    /// The delay that packets make, on the safe side: a sample may be one period old, and a command may wait
    /// for one more. 0 if the device is stepped in the tick.
    std::uint32_t packetDelay_us() const { return inProcess ? 0 : 2 * period_us; }
    /// The delay against which the passivity controller guards people (devices.md §8).
    std::uint32_t guardedDelay_us() const { return std::max(oldestSample_us, packetDelay_us()); }
};

/// The mapping from D to W: p_WT = origin + scale · R · H · p_DT, with H = diag(-1,1,1) for a left-handed
/// workspace, otherwise 1, and R the mounting of the device's base (P2, "Flexible Mounting Options"). Forces
/// go back through (R H)ᵀ unscaled. Stored with each session.
struct WorkspaceMapping {
    std::array<double, 3> origin_m{};
    double scale = 1.0;
    bool leftHanded = false;
    std::array<double, 4> q_WD{1.0, 0.0, 0.0, 0.0}; ///< R as a unit quaternion w, x, y, z, about D's origin

    bool turned() const noexcept { return q_WD != std::array<double, 4>{1.0, 0.0, 0.0, 0.0}; }
};

} // namespace chiron::devices
