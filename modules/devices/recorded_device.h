// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"

#include <memory>

namespace chiron::devices {

/// A device for replays: descriptor and kinematics as a session stored them, and the packet that was set
/// last. It takes the place of the real device and ignores commands.
/// Thread: one.
class RecordedDevice final : public IDevice {
public:
    /// Creates the device.
    /// Errors: badInput if the descriptor's kinematics is unknown or does not fit its axes.
    static core::Result<std::unique_ptr<RecordedDevice>> create(const DeviceDescriptor& descriptor);

    ~RecordedDevice() override;

    /// The sample that read() returns from now on.
    void setSample(const core::DeviceSample& sample) noexcept { m_sample = sample; }

    const DeviceDescriptor& descriptor() const noexcept override { return m_descriptor; }
    const IToolKinematics& kinematics() const noexcept override { return *m_kinematics; }
    core::Result<void> open() override { return {}; }
    void close() noexcept override {}
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override;
    void command(const realtime::HapticTick&, const ForceCommand&) noexcept override {}

private:
    RecordedDevice(const DeviceDescriptor& descriptor, std::unique_ptr<IToolKinematics> kinematics);

    DeviceDescriptor m_descriptor;
    std::unique_ptr<IToolKinematics> m_kinematics;
    core::DeviceSample m_sample;
};

} // namespace chiron::devices
