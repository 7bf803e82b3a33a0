// SPDX-License-Identifier: GPL-3.0-or-later
// Making driver and kinematics allocates, so it is kept apart from the code that the tick calls.
#include "devices/drivers/simulated/simulated_device.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace chiron::devices {

core::Result<GimbalHprdKinematics> GimbalHprdKinematics::create(const DeviceDescriptor& descriptor) {
    const auto wrong = [](const std::string& what) {
        return core::fail(core::ErrorCode::badInput, "kinematics gimbal_hprd: " + what);
    };
    if (descriptor.kinematics != kId)
        return wrong("descriptor says '" + descriptor.kinematics + "'");
    if (descriptor.axes.size() != 4)
        return wrong("axes: " + std::to_string(descriptor.axes.size()) + " found, 4 expected (h, p, r, d)");
    std::array<double, 4> resolution{};
    for (std::size_t axis = 0; axis < 4; ++axis) {
        resolution[axis] = descriptor.axes[axis].resolution;
        if (!(resolution[axis] > 0.0) || !std::isfinite(resolution[axis]))
            return wrong("axes[" + std::to_string(axis) + "].resolution: a finite number above 0 expected");
    }
    const auto& parameters = descriptor.kinematicsParameters;
    if (parameters.size() != 2 || !std::isfinite(parameters[0]) ||
        (parameters[1] != 0.0 && parameters[1] != 1.0))
        return wrong("parameters: {pivot height in m, force map 0 (exact) or 1 (as published)} expected");
    const auto map = parameters[1] == 0.0 ? mechanisms::PolarMap::exact : mechanisms::PolarMap::asPublished;
    return GimbalHprdKinematics(resolution, descriptor.jawResolution_rad, parameters[0], map);
}

namespace {

DeviceDescriptor describe(const SimulatedDevice::Configuration& configuration) {
    const auto& plant = configuration.plant;
    DeviceDescriptor d;
    d.driver = "simulated";
    d.model = "Simulated laparoscopic gimbal (heading, pitch, roll, depth)";
    d.kinematics = GimbalHprdKinematics::kId;
    d.kinematicsParameters = {plant.pivotHeight_m,
                              configuration.map == mechanisms::PolarMap::exact ? 0.0 : 1.0};
    const std::array<const char*, 4> ids{"heading", "pitch", "roll", "depth"};
    for (std::size_t axis = 0; axis < 4; ++axis) {
        const AxisUnit unit = axis == 3 ? AxisUnit::metre : AxisUnit::radian;
        d.axes.push_back({ids[axis], unit, plant.resolution[axis], plant.minimum[axis], plant.maximum[axis],
                          plant.currentLimit_A * plant.effortPerAmpere[axis]});
    }
    d.rendersForce = true;
    d.measuresForce = true;
    d.inProcess = true;
    d.period_us = 1000;
    d.maximumForce_N = d.axes[3].continuousRating; // P2: about 3 N in each direction
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
    if (!start)
        return tl::unexpected(start.error());
    const std::array<double, 4> q{start->h, start->p, start->r, start->d};
    for (std::size_t axis = 0; axis < 4; ++axis) {
        if (q[axis] < configuration.plant.minimum[axis] || q[axis] > configuration.plant.maximum[axis])
            return core::fail(core::ErrorCode::badInput,
                              "simulated device: the start is outside the travel of axis " +
                                  std::to_string(axis) + " (h, p, r, d)");
    }
    return std::unique_ptr<SimulatedDevice>(new SimulatedDevice(configuration, *start, std::move(strategy)));
}

SimulatedDevice::SimulatedDevice(const Configuration& configuration,
                                 const mechanisms::GimbalCoordinates& start,
                                 std::unique_ptr<mechanisms::HandStrategy> strategy)
    : m_configuration(configuration), m_descriptor(describe(configuration)), m_map(configuration.mapping),
      m_kinematics(configuration.plant.resolution, 0.0, configuration.plant.pivotHeight_m, configuration.map),
      m_start(start), m_plant(configuration.plant),
      m_hand(configuration.hand, configuration.seed,
             configuration.plant.instrumentMass_kg + configuration.plant.axisInertia[3]),
      m_strategy(std::move(strategy)) {}

SimulatedDevice::~SimulatedDevice() = default;
GimbalHprdKinematics::~GimbalHprdKinematics() = default;

} // namespace chiron::devices
