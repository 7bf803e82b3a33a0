// SPDX-License-Identifier: GPL-3.0-or-later
// Creation of driver and kinematics allocates, so it is kept apart from the code that the tick calls.
#include "devices/drivers/simulated/simulated_device.h"

#include "devices/axis_resolutions_setup.h"
#include "mechanisms/friction_identification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace chiron::devices {

core::Result<GimbalHprdKinematics> GimbalHprdKinematics::create(const DeviceDescriptor& descriptor) {
    const auto resolution = axisResolutions<4>(descriptor, kId, "h, p, r, d");
    CHIRON_TRY(resolution);
    const auto& parameters = descriptor.kinematicsParameters;
    if (parameters.size() != 2 || !std::isfinite(parameters[0]) ||
        (parameters[1] != 0.0 && parameters[1] != 1.0))
        return kinematicsMisfit(
            kId, "parameters: {pivot height in m, force map 0 (exact) or 1 (as published)} expected");
    return GimbalHprdKinematics(*resolution, descriptor.jawResolution_rad, parameters[0], mapOf(descriptor));
}

mechanisms::PolarMap GimbalHprdKinematics::mapOf(const DeviceDescriptor& descriptor) {
    const auto& parameters = descriptor.kinematicsParameters;
    return parameters.size() == 2 && parameters[1] == 1.0 ? mechanisms::PolarMap::asPublished
                                                          : mechanisms::PolarMap::exact;
}

namespace {

DeviceDescriptor describe(const SimulatedDevice::Configuration& configuration) {
    const auto& plant = configuration.plant;
    DeviceDescriptor d;
    d.driver = "simulated";
    d.model = configuration.jaw ? "Simulated laparoscopic grasper (heading, pitch, roll, depth, jaw)"
                                : "Simulated laparoscopic gimbal (heading, pitch, roll, depth)";
    d.kinematics = GimbalHprdKinematics::kId;
    d.kinematicsParameters = {plant.pivotHeight_m,
                              configuration.map == mechanisms::PolarMap::exact ? 0.0 : 1.0};
    const std::array<const char*, 4> ids{"heading", "pitch", "roll", "depth"};
    for (std::size_t axis = 0; axis < 4; ++axis) {
        const AxisUnit unit = axis == 3 ? AxisUnit::metre : AxisUnit::radian;
        d.axes.push_back({ids[axis], unit, plant.resolution[axis], plant.minimum[axis], plant.maximum[axis],
                          plant.currentLimit_A * plant.effortPerAmpere[axis]});
    }
    d.jawResolution_rad = configuration.jaw ? configuration.jaw->resolution_rad() : 0.0;
    d.rendersForce = true;
    d.measuresForce = true;
    d.inProcess = true;
    d.period_us = 1000;
    d.oldestSample_us = kOldestSample_us;
    d.maximumForce_N = d.axes[3].continuousRating; // P2: about 3 N in each direction
    // Encoder counts can be felt from 60 N·s/m on; this is three fifths of that (tests/damping/README.md).
    d.maximumDamping_Ns_per_m = 35.0;
    return d;
}

/// Identifies the friction as a lab would: the axes are moved slowly and their motors' efforts read; then the
/// descriptor states the result.
core::Result<DeviceDescriptor> describeIdentified(const SimulatedDevice::Configuration& configuration) {
    DeviceDescriptor d = describe(configuration);
    if (configuration.frictionCompensation == 0.0)
        return d;
    static_assert(kMostFrictionCompensation == 0.8, "the message below says so");
    if (!(configuration.frictionCompensation > 0.0 &&
          configuration.frictionCompensation <= kMostFrictionCompensation))
        return core::fail(core::ErrorCode::badInput, "simulated device: a friction compensation of " +
                                                         std::to_string(configuration.frictionCompensation) +
                                                         "; expected a share of 0 to 0.8");
    mechanisms::GimbalPlant plant(configuration.plant);
    const auto found = mechanisms::identifyFriction(plant, {});
    CHIRON_TRY(found);
    for (std::size_t axis = 0; axis < d.axes.size(); ++axis)
        if (const auto& friction = (*found)[axis]) {
            d.axes[axis].coulombFriction = std::max(0.0, friction->coulomb);
            d.axes[axis].viscousFriction = std::max(0.0, friction->viscous);
        }
    d.frictionCompensation = configuration.frictionCompensation;
    return d;
}

} // namespace

core::Result<std::unique_ptr<SimulatedDevice>>
SimulatedDevice::create(const Configuration& configuration,
                        std::unique_ptr<mechanisms::HandStrategy> strategy) {
    if (!strategy)
        return core::fail(core::ErrorCode::badInput, "simulated device: a hand strategy is expected");
    const mechanisms::GimbalKinematics gimbal(configuration.plant.pivotHeight_m);
    const auto start = gimbal.inverse(configuration.start_D);
    CHIRON_TRY(start);
    const std::array<double, 4> q{start->h, start->p, start->r, start->d};
    for (std::size_t axis = 0; axis < 4; ++axis) {
        if (q[axis] < configuration.plant.minimum[axis] || q[axis] > configuration.plant.maximum[axis])
            return core::fail(core::ErrorCode::badInput,
                              "simulated device: the start is outside the travel of axis " +
                                  std::to_string(axis) + " (h, p, r, d)");
    }
    if (const auto& jaw = configuration.jaw;
        jaw && !(jaw->widest_rad > 0.0 && jaw->widest_rad <= 3.1416 && jaw->steps >= 1 &&
                 jaw->fingerLag_s > 0.0 && jaw->fingerSpeed_rad_per_s > 0.0))
        return core::fail(core::ErrorCode::badInput,
                          "simulated device: a jaw that opens by more than 0 and at most half a turn, "
                          "in at least one step, with a lag and a speed above 0, is expected");
    auto descriptor = describeIdentified(configuration);
    CHIRON_TRY(descriptor);
    return std::unique_ptr<SimulatedDevice>(
        new SimulatedDevice(configuration, std::move(*descriptor), *start, std::move(strategy)));
}

SimulatedDevice::SimulatedDevice(const Configuration& configuration, DeviceDescriptor descriptor,
                                 const mechanisms::GimbalCoordinates& start,
                                 std::unique_ptr<mechanisms::HandStrategy> strategy)
    : SimulatedMechanism({configuration.hand, configuration.mapping, configuration.seed,
                          configuration.plant.instrumentMass_kg + configuration.plant.axisInertia[3], 0.0,
                          configuration.jaw, configuration.plant.sampleDelay_ticks},
                         std::move(descriptor), std::move(strategy)),
      m_kinematics(configuration.plant.resolution,
                   configuration.jaw ? configuration.jaw->resolution_rad() : 0.0,
                   configuration.plant.pivotHeight_m, configuration.map),
      m_start(start), m_plant(configuration.plant) {}

SimulatedDevice::~SimulatedDevice() = default;
GimbalHprdKinematics::~GimbalHprdKinematics() = default;

} // namespace chiron::devices
