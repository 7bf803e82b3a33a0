// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "devices/api/workspace_map.h"
#include "devices/drivers/simulated/gimbal_hprd_kinematics.h"
#include "mechanisms/gimbal_plant.h"
#include "mechanisms/hand.h"

#include <cstdint>
#include <memory>

namespace chiron::devices {

/// P2's gimbal with a scripted hand on it, as one in-process tool: plant, hand and mind are stepped by the
/// tick and never look at a clock, so real-time and as-fast runs give the same samples bit for bit.
///
/// Tick n: show() tells the mind what is on the screen, read() returns the counts that the plant reached at
/// the end of tick n − 1 (deviceTime = n·1000 µs, packet = n, age 0), command() takes the force, asks the
/// mind and integrates the plant to n + 1. The force goes through kinematics().efforts(), motors saturate,
/// `measured` is what they really gave (on the tool, in W). Haptic thread; no allocation after construction.
class SimulatedDevice final : public IDevice {
public:
    struct Configuration {
        mechanisms::GimbalPlantParameters plant;
        mechanisms::HandParameters hand;
        mechanisms::PolarMap map = mechanisms::PolarMap::exact;
        WorkspaceMapping mapping;           ///< to turn the cues into D and `measured` into W
        core::Vec3 start_D{0.0, 0.0, 0.05}; ///< where the hand holds the tip at open(), m
        std::uint64_t seed = 1;             ///< of the hand's tremor
    };

    /// Fails (badInput) when the start lies outside the gimbal's travel or there is no strategy.
    static core::Result<std::unique_ptr<SimulatedDevice>>
    create(const Configuration& configuration, std::unique_ptr<mechanisms::HandStrategy> strategy);
    ~SimulatedDevice() override;

    const DeviceDescriptor& descriptor() const noexcept override { return m_descriptor; }
    const IToolKinematics& kinematics() const noexcept override { return m_kinematics; }
    core::Result<void> open() override;
    void close() noexcept override;
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override;
    void command(const realtime::HapticTick& now, const ForceCommand& command) noexcept override;
    void show(const realtime::HapticTick& now, const core::VisibleCues& cues) noexcept override;

    const mechanisms::GimbalPlant& plant() const noexcept { return m_plant; } ///< the truth, for tests
    const mechanisms::Hand& hand() const noexcept { return m_hand; }

private:
    SimulatedDevice(const Configuration& configuration, const mechanisms::GimbalCoordinates& start,
                    std::unique_ptr<mechanisms::HandStrategy> strategy);
    mechanisms::HandPerception perceive() const noexcept;

    Configuration m_configuration;
    DeviceDescriptor m_descriptor;
    WorkspaceMap m_map;
    GimbalHprdKinematics m_kinematics;
    mechanisms::GimbalCoordinates m_start;
    mechanisms::GimbalPlant m_plant;
    mechanisms::Hand m_hand;
    std::unique_ptr<mechanisms::HandStrategy> m_strategy;
    core::VisibleCues m_cues;
    core::DeviceSample m_sample;
    core::Vec3 m_forceOnHand_D = core::Vec3::Zero();
    std::uint64_t m_ticks = 0;
};

} // namespace chiron::devices
