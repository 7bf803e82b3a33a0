// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/drivers/simulated/simulated_fingertip_device.h"

#include <memory>

namespace chiron::devices {

/// Another finger of the same hand: a tool of its own with its own platform, on the arm that the first
/// finger's device moves. The arm follows the first finger's decision model; of this finger's intentions only
/// the buttons count. In the loop the first device must come before this one, and it must be opened before it
/// and outlive it: in each tick its arm has then already moved, as this finger's own sensors show at the next
/// read.
/// Thread: haptic; allocates nothing after construction.
class SimulatedSecondFinger final : public IDevice {
public:
    /// Creates the device. `pad_T`: this finger's pad from the first one's.
    /// Errors: badInput without a strategy, or if the pad is too far away.
    static core::Result<std::unique_ptr<SimulatedSecondFinger>>
    create(const SimulatedFingertipDevice& first, const core::Vec3& pad_T, std::uint64_t seed,
           std::unique_ptr<mechanisms::HandStrategy> strategy);
    ~SimulatedSecondFinger() override;

    const DeviceDescriptor& descriptor() const noexcept override { return m_descriptor; }
    const IToolKinematics& kinematics() const noexcept override { return m_kinematics; }
    core::Result<void> open() override;
    void close() noexcept override { m_finger.tick({}); }
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override;
    void command(const realtime::HapticTick& now, const ForceCommand& command) noexcept override;
    void show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept override { m_cues = cues; }

    /// True state, for tests.
    const mechanisms::FingertipPlatform& platform() const noexcept { return m_finger.platform(); }

private:
    SimulatedSecondFinger(const SimulatedFingertipDevice& first,
                          const SimulatedFingertipDevice::Configuration& configuration,
                          const core::Vec3& pad_T, std::unique_ptr<mechanisms::HandStrategy> strategy);
    mechanisms::HandPerception perceive() const noexcept;

    const SimulatedFingertipDevice& m_first;
    DeviceDescriptor m_descriptor;
    core::Vec3 m_pad_T;
    FingertipArmKinematics m_kinematics;
    WorkspaceMap m_map;
    mechanisms::Hand m_reaction; ///< used for its reaction delay only: it holds nothing
    FingertipFinger m_finger;
    std::unique_ptr<mechanisms::HandStrategy> m_strategy;
    core::VisibleCues m_cues;
    core::DeviceSample m_sample;
    std::uint64_t m_ticks = 0;
};

} // namespace chiron::devices
