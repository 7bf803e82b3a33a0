// SPDX-License-Identifier: GPL-3.0-or-later
// Creation of drivers and kinematics allocates, so it is kept apart from the code that the tick calls.
#include "devices/axis_resolutions_setup.h"
#include "devices/drivers/simulated/fingertip_sliding_kinematics.h"
#include "devices/drivers/simulated/simulated_fingertip_device.h"
#include "devices/drivers/simulated/simulated_second_finger.h"
#include "mechanisms/fingertip_pad_identification.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::devices {

namespace {
constexpr std::array<const char*, FingertipArmKinematics::kAxes> kAxisNames{
    "yaw", "shoulder", "elbow", "wrist_x", "wrist_y", "wrist_z", "platform_pitch", "platform_roll"};
constexpr double kWristTravel_rad = 3.141592653589793;
/// Resolution of the platform's own IMU: 16 counts per degree, in which fused nine-axis sensors report angles
/// (Bosch BNO055's data sheet, table 3-29).
constexpr double kPlatformAngle_rad = 1.0908307824964559e-3;

std::array<double, FingertipArmKinematics::kAxes>
resolutionsOf(const mechanisms::FingertipArmParameters& arm) {
    const double joint = arm.encoderResolution_rad();
    const double imu = arm.imu.resolution_rad;
    return {joint, joint, joint, imu, imu, imu, kPlatformAngle_rad, kPlatformAngle_rad};
}

FingertipArmKinematics kinematicsOf(const SimulatedFingertipDevice::Configuration& configuration,
                                    const core::Vec3& pad_T) {
    return {resolutionsOf(configuration.arm), configuration.arm.grasp.resolution_rad(), pad_T,
            configuration.arm.geometry};
}

/// Settings of the hand. For its tremor it holds the apparent inertia of the arm at the start.
SimulatedHandSettings settingsOf(const SimulatedFingertipDevice::Configuration& configuration) {
    mechanisms::FingertipArmPlant arm(configuration.arm, configuration.seed);
    arm.reset(configuration.start_D);
    return {configuration.hand,
            configuration.mapping,
            configuration.seed,
            arm.apparentMass_kg(),
            arm.apparentInertia_kgm2(),
            configuration.arm.grasp,
            0};
}

core::Result<void> checked(const SimulatedFingertipDevice::Configuration& configuration) {
    const auto& arm = configuration.arm;
    const auto refuse = [](const std::string& why) {
        return core::fail(core::ErrorCode::badInput, "simulated fingertip: " + why);
    };
    for (const double length :
         {arm.geometry.upper_m, arm.geometry.fore_m, arm.handleMass_kg, arm.handleRadius_m, arm.ringMass_kg,
          arm.ringRadius_m, arm.leverMass_kg, arm.leverLength_m, arm.columnInertia_kgm2,
          arm.imu.resolution_rad, arm.grasp.widest_rad})
        if (!(length > 0.0 && std::isfinite(length)))
            return refuse("the arm's lengths, masses and resolutions must be finite and above 0");
    if (!(arm.encoderBits >= 8 && arm.encoderBits <= 26))
        return refuse("encoders of 8 to 26 bits a turn are expected");
    const mechanisms::ArmPosture start =
        mechanisms::fingertipArmPosture(arm, configuration.start_D, core::Quat::Identity());
    if (start.reach != mechanisms::ArmReach::reached)
        return refuse(
            std::string("the start cannot be reached: ") + mechanisms::wordsFor(start.reach) +
            (start.joint >= 0 ? " (joint " + std::to_string(start.joint + 1) + " of 7)" : std::string()));
    return {};
}

core::Result<std::array<double, FingertipArmKinematics::kAxes>>
resolutionsIn(const DeviceDescriptor& descriptor, const char* names, AxisUnit arm) {
    auto resolution =
        axisResolutions<FingertipArmKinematics::kAxes>(descriptor, FingertipArmKinematics::kId, names);
    for (std::size_t axis = 0; resolution && axis < FingertipArmKinematics::kAxes; ++axis) {
        const AxisUnit unit = axis < FingertipArmKinematics::kWrist ? arm : AxisUnit::radian;
        if (descriptor.axes[axis].unit != unit)
            return kinematicsMisfit(FingertipArmKinematics::kId,
                                    "axes[" + std::to_string(axis) + "].unit: " +
                                        (unit == AxisUnit::metre ? "metre" : "radian") + " expected");
    }
    return resolution;
}

bool allFinite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}
} // namespace

core::Result<FingertipArmKinematics> FingertipArmKinematics::create(const DeviceDescriptor& descriptor) {
    const auto resolution = resolutionsIn(
        descriptor, "yaw, shoulder, elbow, wrist_x, wrist_y, wrist_z, platform_pitch, platform_roll",
        AxisUnit::radian);
    CHIRON_TRY(resolution);
    const auto& p = descriptor.kinematicsParameters;
    if (p.size() != 8 || !allFinite(p) || !(p[6] > 0.0 && p[7] > 0.0))
        return kinematicsMisfit(kId, "parameters: {x, y, z of the pad from the wrist's middle; x, y, z of "
                                     "the shoulder; upper arm, forearm above 0; m} expected");
    return FingertipArmKinematics(*resolution, descriptor.jawResolution_rad, {p[0], p[1], p[2]},
                                  {{p[3], p[4], p[5]}, p[6], p[7]});
}

core::Result<FingertipSlidingKinematics>
FingertipSlidingKinematics::create(const DeviceDescriptor& descriptor) {
    const auto resolution = resolutionsIn(
        descriptor, "x, y, z, wrist_x, wrist_y, wrist_z, platform_pitch, platform_roll", AxisUnit::metre);
    CHIRON_TRY(resolution);
    const auto& pad = descriptor.kinematicsParameters;
    if (pad.size() != 3 || !allFinite(pad))
        return kinematicsMisfit(kId, "parameters: {x, y, z of the pad from the arm's end, m} expected");
    return FingertipSlidingKinematics(*resolution, descriptor.jawResolution_rad, {pad[0], pad[1], pad[2]});
}

DeviceDescriptor describeFingertip(const SimulatedFingertipDevice::Configuration& configuration,
                                   const core::Vec3& pad_T) {
    DeviceDescriptor d;
    d.driver = "simulated";
    d.model = "Simulated palpation arm with fingertip platform";
    d.kinematics = FingertipArmKinematics::kId;
    const mechanisms::FingertipArmParameters& arm = configuration.arm;
    const core::Vec3& shoulder = arm.geometry.shoulder_D;
    d.kinematicsParameters = {pad_T.x(),
                              pad_T.y(),
                              pad_T.z(),
                              shoulder.x(),
                              shoulder.y(),
                              shoulder.z(),
                              arm.geometry.upper_m,
                              arm.geometry.fore_m};
    const auto resolution = resolutionsOf(arm);
    const std::array<double, 2> lean{0.5235987755982988, 0.3490658503988659}; // P3: pitch ±30°, roll ±20°
    for (std::size_t axis = 0; axis < FingertipArmKinematics::kAxes; ++axis) {
        const bool joint = axis < FingertipArmKinematics::kWrist;
        const bool turns = axis < FingertipArmKinematics::kPlatform;
        const double low = joint   ? arm.minimum[axis]
                           : turns ? -kWristTravel_rad
                                   : -lean[axis - FingertipArmKinematics::kPlatform];
        const double high = joint ? arm.maximum[axis] : -low;
        d.axes.push_back({kAxisNames[axis], AxisUnit::radian, resolution[axis], low, high, 0.0});
    }
    d.jawResolution_rad = arm.grasp.resolution_rad();
    d.rendersForce = true;
    d.measuresForce = true;
    d.inProcess = true;
    d.period_us = 1000;
    d.oldestSample_us = kOldestSample_us;
    d.maximumForce_N = 4.0; // P3 §2.1, on the pad
    // Encoder counts can be felt from 45 N·s/m on; this is two thirds of that (tests/damping/README.md).
    d.maximumDamping_Ns_per_m = 30.0;
    return d;
}

core::Result<std::unique_ptr<SimulatedFingertipDevice>>
SimulatedFingertipDevice::create(const Configuration& configuration,
                                 std::unique_ptr<mechanisms::HandStrategy> strategy) {
    if (!strategy)
        return core::fail(core::ErrorCode::badInput, "simulated fingertip: a hand strategy is expected");
    CHIRON_TRY(checked(configuration));
    auto platform = mechanisms::worn(configuration.platform, configuration.seed); // the finger is put on the
                                                                                  // platform
    CHIRON_TRY(platform);
    Configuration worn = configuration;
    worn.platform = *platform;
    return std::unique_ptr<SimulatedFingertipDevice>(new SimulatedFingertipDevice(worn, std::move(strategy)));
}

SimulatedFingertipDevice::SimulatedFingertipDevice(const Configuration& configuration,
                                                   std::unique_ptr<mechanisms::HandStrategy> strategy)
    : SimulatedMechanism(settingsOf(configuration), describeFingertip(configuration, core::Vec3::Zero()),
                         std::move(strategy)),
      m_configuration(configuration), m_kinematics(kinematicsOf(configuration, core::Vec3::Zero())),
      m_padMap(configuration.mapping), m_arm(configuration.arm, configuration.seed),
      m_finger(configuration.platform, kPlatformAngle_rad, configuration.seed) {}

SimulatedFingertipDevice::~SimulatedFingertipDevice() = default;
FingertipArmKinematics::~FingertipArmKinematics() = default;
FingertipSlidingKinematics::~FingertipSlidingKinematics() = default;

core::Result<std::unique_ptr<SimulatedSecondFinger>>
SimulatedSecondFinger::create(const SimulatedFingertipDevice& first, const core::Vec3& pad_T,
                              std::uint64_t seed, std::unique_ptr<mechanisms::HandStrategy> strategy) {
    if (!strategy)
        return core::fail(core::ErrorCode::badInput, "simulated fingertip: a hand strategy is expected");
    if (!(pad_T.norm() > 0.0 && pad_T.norm() <= 0.2))
        return core::fail(core::ErrorCode::badInput,
                          "simulated fingertip: a second finger up to 0.2 m from the first is expected");
    SimulatedFingertipDevice::Configuration configuration = first.m_configuration;
    configuration.seed = seed;
    auto platform = mechanisms::worn(configuration.platform, seed); // with this finger's own sensors
    CHIRON_TRY(platform);
    configuration.platform = *platform;
    return std::unique_ptr<SimulatedSecondFinger>(
        new SimulatedSecondFinger(first, configuration, pad_T, std::move(strategy)));
}

SimulatedSecondFinger::SimulatedSecondFinger(const SimulatedFingertipDevice& first,
                                             const SimulatedFingertipDevice::Configuration& configuration,
                                             const core::Vec3& pad_T,
                                             std::unique_ptr<mechanisms::HandStrategy> strategy)
    : m_first(first), m_descriptor(describeFingertip(configuration, pad_T)), m_pad_T(pad_T),
      m_kinematics(kinematicsOf(configuration, pad_T)), m_map(configuration.mapping),
      m_reaction(configuration.hand, configuration.seed, settingsOf(configuration).toolMass_kg),
      m_finger(configuration.platform, kPlatformAngle_rad, configuration.seed),
      m_strategy(std::move(strategy)) {}

SimulatedSecondFinger::~SimulatedSecondFinger() = default;

} // namespace chiron::devices
