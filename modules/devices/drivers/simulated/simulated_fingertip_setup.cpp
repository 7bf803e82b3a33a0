// SPDX-License-Identifier: GPL-3.0-or-later
// Making drivers and kinematics allocates, so it is kept apart from the code that the tick calls.
#include "devices/axis_resolutions_setup.h"
#include "devices/drivers/simulated/simulated_fingertip_device.h"
#include "devices/drivers/simulated/simulated_second_finger.h"
#include "mechanisms/fingertip_pad_identification.h"

#include <cmath>
#include <utility>

namespace chiron::devices {

namespace {
constexpr std::array<const char*, FingertipArmKinematics::kAxes> kAxisNames{
    "x", "y", "z", "wrist_x", "wrist_y", "wrist_z", "platform_pitch", "platform_roll"};
constexpr double kWristTravel_rad = 3.141592653589793;

std::array<double, FingertipArmKinematics::kAxes> resolutionsOf(const mechanisms::FingertipArmParameters& arm) {
    const double m = arm.resolution_m;
    const double rad = arm.imuResolution_rad;
    return {m, m, m, rad, rad, rad, rad, rad};
}

core::Result<void> checked(const SimulatedFingertipDevice::Configuration& configuration) {
    const auto& arm = configuration.arm;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(configuration.start_D[axis] >= arm.minimum_m[axis] && configuration.start_D[axis] <= arm.maximum_m[axis]))
            return core::fail(core::ErrorCode::badInput, std::string("simulated fingertip: the start is outside the travel of axis ") +
                                                             kAxisNames[static_cast<std::size_t>(axis)]);
    }
    if (!(arm.mass_kg > 0.0 && arm.inertia_kgm2 > 0.0 && arm.resolution_m > 0.0 && arm.imuResolution_rad > 0.0))
        return core::fail(core::ErrorCode::badInput, "simulated fingertip: the arm's mass, inertia and resolutions must be above 0");
    return {};
}
} // namespace

core::Result<FingertipArmKinematics> FingertipArmKinematics::create(const DeviceDescriptor& descriptor) {
    const auto resolution = axisResolutions<kAxes>(descriptor, kId, "x, y, z, wrist_x, wrist_y, wrist_z, platform_pitch, platform_roll");
    if (!resolution)
        return tl::unexpected(resolution.error());
    for (std::size_t axis = 0; axis < kAxes; ++axis)
        if (descriptor.axes[axis].unit != (axis < kWrist ? AxisUnit::metre : AxisUnit::radian))
            return kinematicsMisfit(kId, "axes[" + std::to_string(axis) + "].unit: " + (axis < kWrist ? "metre" : "radian") + " expected");
    const auto& pad = descriptor.kinematicsParameters;
    if (pad.size() != 3 || !std::isfinite(pad[0]) || !std::isfinite(pad[1]) || !std::isfinite(pad[2]))
        return kinematicsMisfit(kId, "parameters: {x, y, z of the pad from the arm's end, m} expected");
    return FingertipArmKinematics(*resolution, descriptor.jawResolution_rad, {pad[0], pad[1], pad[2]});
}

DeviceDescriptor describeFingertip(const SimulatedFingertipDevice::Configuration& configuration, const core::Vec3& pad_T) {
    DeviceDescriptor d;
    d.driver = "simulated";
    d.model = "Simulated palpation arm with fingertip platform";
    d.kinematics = FingertipArmKinematics::kId;
    d.kinematicsParameters = {pad_T.x(), pad_T.y(), pad_T.z()};
    const auto resolution = resolutionsOf(configuration.arm);
    const std::array<double, 2> lean{0.5235987755982988, 0.3490658503988659}; // P3: pitch ±30°, roll ±20°
    for (std::size_t axis = 0; axis < FingertipArmKinematics::kAxes; ++axis) {
        const bool moves = axis < FingertipArmKinematics::kWrist;
        const bool turns = axis < FingertipArmKinematics::kPlatform;
        const int i = static_cast<int>(axis);
        const double low = moves ? configuration.arm.minimum_m[i] : turns ? -kWristTravel_rad : -lean[axis - FingertipArmKinematics::kPlatform];
        const double high = moves ? configuration.arm.maximum_m[i] : -low;
        d.axes.push_back({kAxisNames[axis], moves ? AxisUnit::metre : AxisUnit::radian, resolution[axis], low, high, 0.0});
    }
    d.jawResolution_rad = configuration.grasp ? configuration.grasp->resolution_rad() : 0.0;
    d.rendersForce = true;
    d.measuresForce = true;
    d.inProcess = true;
    d.period_us = 1000;
    d.maximumForce_N = 4.0; // P3 §2.1, on the pad
    d.maximumDamping_Ns_per_m = 30.0; // counts are felt from 50 on: three fifths of it (tests/damping/README.md)
    return d;
}

core::Result<std::unique_ptr<SimulatedFingertipDevice>>
SimulatedFingertipDevice::create(const Configuration& configuration, std::unique_ptr<mechanisms::HandStrategy> strategy) {
    if (!strategy)
        return core::fail(core::ErrorCode::badInput, "simulated fingertip: a hand strategy is expected");
    if (auto sound = checked(configuration); !sound)
        return tl::unexpected(sound.error());
    auto platform = mechanisms::worn(configuration.platform, configuration.seed); // the finger is put on
    if (!platform)
        return tl::unexpected(platform.error());
    Configuration worn = configuration;
    worn.platform = *platform;
    return std::unique_ptr<SimulatedFingertipDevice>(new SimulatedFingertipDevice(worn, std::move(strategy)));
}

SimulatedFingertipDevice::SimulatedFingertipDevice(const Configuration& configuration,
                                                   std::unique_ptr<mechanisms::HandStrategy> strategy)
    : SimulatedMechanism({configuration.hand, configuration.mapping, configuration.seed, configuration.arm.mass_kg,
                          configuration.arm.inertia_kgm2, configuration.grasp, 0},
                         describeFingertip(configuration, core::Vec3::Zero()), std::move(strategy)),
      m_configuration(configuration),
      m_kinematics(resolutionsOf(configuration.arm), configuration.grasp ? configuration.grasp->resolution_rad() : 0.0,
                   core::Vec3::Zero()),
      m_padMap(configuration.mapping), m_arm(configuration.arm, configuration.seed),
      m_finger(configuration.platform, configuration.arm.imuResolution_rad, configuration.seed) {}

SimulatedFingertipDevice::~SimulatedFingertipDevice() = default;
FingertipArmKinematics::~FingertipArmKinematics() = default;

core::Result<std::unique_ptr<SimulatedSecondFinger>>
SimulatedSecondFinger::create(const SimulatedFingertipDevice& first, const core::Vec3& pad_T, std::uint64_t seed,
                              std::unique_ptr<mechanisms::HandStrategy> strategy) {
    if (!strategy)
        return core::fail(core::ErrorCode::badInput, "simulated fingertip: a hand strategy is expected");
    if (!(pad_T.norm() > 0.0 && pad_T.norm() <= 0.2))
        return core::fail(core::ErrorCode::badInput, "simulated fingertip: a second finger up to 0.2 m from the first is expected");
    SimulatedFingertipDevice::Configuration configuration = first.m_configuration;
    configuration.seed = seed;
    auto platform = mechanisms::worn(configuration.platform, seed); // with its own sensors
    if (!platform)
        return tl::unexpected(platform.error());
    configuration.platform = *platform;
    return std::unique_ptr<SimulatedSecondFinger>(new SimulatedSecondFinger(first, configuration, pad_T, std::move(strategy)));
}

SimulatedSecondFinger::SimulatedSecondFinger(const SimulatedFingertipDevice& first,
                                             const SimulatedFingertipDevice::Configuration& configuration, const core::Vec3& pad_T,
                                             std::unique_ptr<mechanisms::HandStrategy> strategy)
    : m_first(first), m_descriptor(describeFingertip(configuration, pad_T)), m_pad_T(pad_T),
      m_kinematics(resolutionsOf(configuration.arm), configuration.grasp ? configuration.grasp->resolution_rad() : 0.0,
                   pad_T),
      m_map(configuration.mapping), m_reaction(configuration.hand, configuration.seed, configuration.arm.mass_kg),
      m_finger(configuration.platform, configuration.arm.imuResolution_rad, configuration.seed),
      m_strategy(std::move(strategy)) {}

SimulatedSecondFinger::~SimulatedSecondFinger() = default;

} // namespace chiron::devices
