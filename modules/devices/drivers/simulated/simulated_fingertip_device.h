// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver.h"
#include "devices/drivers/simulated/fingertip_arm_kinematics.h"
#include "devices/drivers/simulated/fingertip_finger.h"
#include "devices/drivers/simulated/simulated_mechanism.h"
#include "mechanisms/fingertip_arm_plant.h"

#include <cstdint>
#include <memory>

namespace chiron::devices {

/// P3's arm with a platform under one finger, and a scripted hand that holds it (SimulatedMechanism). The
/// force is displayed to the pad and never pushes the hand back: the wrench of ForceCommand is ignored, and
/// the platform follows its `display`.
class SimulatedFingertipDevice final : public SimulatedMechanism {
public:
    struct Configuration {
        mechanisms::FingertipArmParameters arm;
        mechanisms::FingertipPlatformParameters platform;
        mechanisms::HandParameters hand;
        WorkspaceMapping mapping; ///< converts the cues to D and `measured` to W
        /// Position of the finger's pad, which is the middle of the wrist, at open(), m.
        core::Vec3 start_D = kHeldFrom_D;
        std::uint64_t seed = 1; ///< seed of tremor and sensors
    };

    /// Creates the device. The platform identifies the finger (mechanisms::identifyPad) before it displays
    /// anything.
    /// Errors: badInput if the start is out of the arm's reach, a number makes no sense, no finger is found,
    /// or there is no strategy.
    static core::Result<std::unique_ptr<SimulatedFingertipDevice>>
    create(const Configuration& configuration, std::unique_ptr<mechanisms::HandStrategy> strategy);
    ~SimulatedFingertipDevice() override;

    const IToolKinematics& kinematics() const noexcept override { return m_kinematics; }
    /// True state, for tests.
    const mechanisms::FingertipArmPlant& arm() const noexcept { return m_arm; }
    /// True state, for tests.
    const mechanisms::FingertipPlatform& platform() const noexcept { return m_finger.platform(); }

private:
    friend class SimulatedSecondFinger;
    SimulatedFingertipDevice(const Configuration& configuration,
                             std::unique_ptr<mechanisms::HandStrategy> strategy);
    mechanisms::Plant& movedPlant() noexcept override { return m_arm; }
    void resetPlant() noexcept override;
    void addToSample(core::DeviceSample& sample) const noexcept override;
    void addToPerception(mechanisms::HandPerception& seen) const noexcept override {
        m_finger.addToPerception(seen);
    }
    void stepDisplay(const ForceCommand& command) noexcept override;

    Configuration m_configuration;
    FingertipArmKinematics m_kinematics;
    WorkspaceMap m_padMap;
    mechanisms::FingertipArmPlant m_arm;
    FingertipFinger m_finger;
};

/// Returns the descriptor of a fingertip device. `pad_T`: this finger's pad from the arm's end, m.
DeviceDescriptor describeFingertip(const SimulatedFingertipDevice::Configuration& configuration,
                                   const core::Vec3& pad_T);

} // namespace chiron::devices
