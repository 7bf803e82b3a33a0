// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/drivers/simulated/five_bar_spherical_kinematics.h"
#include "devices/drivers/simulated/simulated_mechanism.h"
#include "mechanisms/five_bar_plant.h"

#include <cstdint>
#include <memory>

namespace chiron::devices {

/// P1's five-bar linkage with spherical joint and a scripted hand on its endoscope (SimulatedMechanism): the
/// arm moves the tip in the plane x_D = 0, and the wrist turns the endoscope about the tip.
class SimulatedEndoscopeDevice final : public SimulatedMechanism {
public:
    struct Configuration {
        mechanisms::FiveBarPlantParameters plant;
        mechanisms::HandParameters hand;
        WorkspaceMapping mapping;                ///< converts the cues to D and `measured` to W
        core::Vec3 start_D{0.0, -0.069, 0.0};    ///< position at which the hand holds the tip at open(), m; x
                                                 ///< ignored
        mechanisms::EndoscopeAngles startAngles; ///< orientation at open(): looking along +y_D
        std::uint64_t seed = 1;                  ///< seed of the hand's tremor
    };

    /// Creates the device.
    /// Errors: badInput if the start lies outside the mechanism's travel or there is no strategy.
    static core::Result<std::unique_ptr<SimulatedEndoscopeDevice>>
    create(const Configuration& configuration, std::unique_ptr<mechanisms::HandStrategy> strategy);
    ~SimulatedEndoscopeDevice() override;

    const IToolKinematics& kinematics() const noexcept override { return m_kinematics; }
    const mechanisms::FiveBarPlant& plant() const noexcept { return m_plant; } ///< true state, for tests

private:
    SimulatedEndoscopeDevice(const Configuration& configuration, const mechanisms::FiveBarVector& start,
                             std::unique_ptr<mechanisms::HandStrategy> strategy);
    mechanisms::Plant& movedPlant() noexcept override { return m_plant; }
    void resetPlant() noexcept override { m_plant.reset(m_start); }

    FiveBarSphericalKinematics m_kinematics;
    mechanisms::FiveBarVector m_start;
    mechanisms::FiveBarPlant m_plant;
};

} // namespace chiron::devices
