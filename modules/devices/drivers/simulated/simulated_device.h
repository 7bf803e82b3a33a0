// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver.h"
#include "devices/drivers/simulated/gimbal_hprd_kinematics.h"
#include "devices/drivers/simulated/simulated_mechanism.h"
#include "mechanisms/gimbal_plant.h"

#include <cstdint>
#include <memory>

namespace chiron::devices {

/// P2's gimbal with a scripted hand on it (SimulatedMechanism). The hand holds a point: it does not turn the
/// tool.
class SimulatedDevice final : public SimulatedMechanism {
public:
    struct Configuration {
        mechanisms::GimbalPlantParameters plant;
        mechanisms::HandParameters hand;
        mechanisms::PolarMap map = mechanisms::PolarMap::exact;
        WorkspaceMapping mapping;         ///< converts the cues to D and `measured` to W
        core::Vec3 start_D = kHeldFrom_D; ///< position at which the hand holds the tip at open(), m
        std::uint64_t seed = 1;           ///< seed of the hand's tremor
        /// Jaw of a grasper; empty: a plain probe.
        std::optional<mechanisms::JawParameters> jaw = std::nullopt;
        /// Share of the Coulomb friction that is fed forward (P2), 0..kMostFrictionCompensation. Above 0 the
        /// friction is identified when the device is made (mechanisms/friction_identification.h), as a lab
        /// does it, and not taken from `plant`.
        double frictionCompensation = 0.0;
    };

    /// Creates the device.
    /// Errors: badInput if the start lies outside the gimbal's travel, a number of the jaw or the
    /// compensation is out of range, or there is no strategy.
    static core::Result<std::unique_ptr<SimulatedDevice>>
    create(const Configuration& configuration, std::unique_ptr<mechanisms::HandStrategy> strategy);
    ~SimulatedDevice() override;

    const IToolKinematics& kinematics() const noexcept override { return m_kinematics; }
    const mechanisms::GimbalPlant& plant() const noexcept { return m_plant; } ///< true state, for tests

private:
    SimulatedDevice(const Configuration& configuration, DeviceDescriptor descriptor,
                    const mechanisms::GimbalCoordinates& start,
                    std::unique_ptr<mechanisms::HandStrategy> strategy);
    mechanisms::Plant& movedPlant() noexcept override { return m_plant; }
    void resetPlant() noexcept override { m_plant.reset(m_start); }

    GimbalHprdKinematics m_kinematics;
    mechanisms::GimbalCoordinates m_start;
    mechanisms::GimbalPlant m_plant;
};

} // namespace chiron::devices
