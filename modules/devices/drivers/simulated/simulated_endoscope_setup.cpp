// SPDX-License-Identifier: GPL-3.0-or-later
// Creation of driver and kinematics allocates, so it is kept apart from the code that the tick calls.
#include "devices/drivers/simulated/simulated_endoscope_device.h"

#include "devices/axis_resolutions_setup.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace chiron::devices {

namespace {

using mechanisms::FiveBarVector;
constexpr const char* kAxisNames[FiveBarSphericalKinematics::kAxes] = {"theta1", "theta2", "pitch", "yaw",
                                                                       "roll"};

DeviceDescriptor describe(const SimulatedEndoscopeDevice::Configuration& configuration) {
    const auto& plant = configuration.plant;
    const auto& g = plant.geometry;
    DeviceDescriptor d;
    d.driver = "simulated";
    d.model = "Simulated endoscope (five-bar linkage with spherical joint)";
    d.kinematics = FiveBarSphericalKinematics::kId;
    d.kinematicsParameters = {g.proximal_m,    g.distal_m, g.halfBase_m,
                              g.baseForward_m, g.baseUp_m, plant.mountingPitch_rad};
    for (std::size_t axis = 0; axis < FiveBarSphericalKinematics::kAxes; ++axis)
        d.axes.push_back({kAxisNames[axis], AxisUnit::radian, plant.resolution[axis], plant.minimum[axis],
                          plant.maximum[axis], plant.renderLimit[axis]});
    d.rendersForce = true;
    d.measuresForce = true;
    d.inProcess = true;
    d.period_us = 1000;
    d.oldestSample_us = kOldestSample_us;
    d.maximumForce_N = 4.5; // P1: along x and y
    // In a light hand it shakes on friction from 37.5 N·s/m on; this is two thirds of that
    // (tests/damping/README.md).
    d.maximumDamping_Ns_per_m = 24.0;
    d.maximumTorque_Nm = 0.150; // P1: about x′ and y′; 10 mN·m about z′ is the roll axis' rating
    return d;
}

} // namespace

core::Result<FiveBarSphericalKinematics>
FiveBarSphericalKinematics::create(const DeviceDescriptor& descriptor) {
    const auto resolution = axisResolutions<kAxes>(descriptor, kId, "theta1, theta2, pitch, yaw, roll");
    CHIRON_TRY(resolution);
    const auto& p = descriptor.kinematicsParameters;
    const bool finite = std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
    if (p.size() != 6 || !finite || !(p[0] > 0.0 && p[1] > 0.0 && p[2] >= 0.0))
        return kinematicsMisfit(
            kId, "parameters: {l1, l2, half base (m, the first two above 0), base forward, base up (m), "
                 "mounting pitch (rad)} expected");
    return FiveBarSphericalKinematics(*resolution, descriptor.jawResolution_rad,
                                      {p[0], p[1], p[2], p[3], p[4]}, p[5]);
}

core::Result<std::unique_ptr<SimulatedEndoscopeDevice>>
SimulatedEndoscopeDevice::create(const Configuration& configuration,
                                 std::unique_ptr<mechanisms::HandStrategy> strategy) {
    if (!strategy)
        return core::fail(core::ErrorCode::badInput, "simulated endoscope: a hand strategy is expected");
    const auto& plant = configuration.plant;
    const auto theta = mechanisms::FiveBarKinematics(plant.geometry).inverse(configuration.start_D);
    CHIRON_TRY(theta);
    FiveBarVector start;
    start << (*theta)[0], (*theta)[1], configuration.startAngles.pitch - plant.mountingPitch_rad,
        configuration.startAngles.yaw, configuration.startAngles.roll;
    for (std::size_t axis = 0; axis < FiveBarSphericalKinematics::kAxes; ++axis) {
        const double value = start[static_cast<int>(axis)];
        if (!(value >= plant.minimum[axis] && value <= plant.maximum[axis]))
            return core::fail(core::ErrorCode::badInput,
                              std::string("simulated endoscope: the start is outside the travel of axis ") +
                                  kAxisNames[axis]);
    }
    return std::unique_ptr<SimulatedEndoscopeDevice>(
        new SimulatedEndoscopeDevice(configuration, start, std::move(strategy)));
}

SimulatedEndoscopeDevice::SimulatedEndoscopeDevice(const Configuration& configuration,
                                                   const FiveBarVector& start,
                                                   std::unique_ptr<mechanisms::HandStrategy> strategy)
    : SimulatedMechanism(
          {configuration.hand, configuration.mapping, configuration.seed,
           configuration.plant.endoscopeMass_kg + configuration.plant.jointMass_kg +
               configuration.plant.distalMass_kg,
           configuration.plant.acrossInertia_kgm2 + configuration.plant.endoscopeMass_kg *
                                                        configuration.plant.centreOfMassBehindTip_m *
                                                        configuration.plant.centreOfMassBehindTip_m},
          describe(configuration), std::move(strategy)),
      m_kinematics(configuration.plant.resolution, 0.0, configuration.plant.geometry,
                   configuration.plant.mountingPitch_rad),
      m_start(start), m_plant(configuration.plant) {}

SimulatedEndoscopeDevice::~SimulatedEndoscopeDevice() = default;
FiveBarSphericalKinematics::~FiveBarSphericalKinematics() = default;

} // namespace chiron::devices
