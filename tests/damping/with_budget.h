// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"

#include <memory>
#include <utility>

namespace chiron::tests {

/// A device that says it carries another damping than it says itself: what a session would be like with that
/// budget.
class WithBudget final : public devices::IDevice {
public:
    WithBudget(std::unique_ptr<devices::IDevice> device, double budget_Ns_per_m)
        : m_device(std::move(device)), m_descriptor(m_device->descriptor()) {
        m_descriptor.maximumDamping_Ns_per_m = budget_Ns_per_m;
    }
    const devices::DeviceDescriptor& descriptor() const noexcept override { return m_descriptor; }
    const devices::IToolKinematics& kinematics() const noexcept override { return m_device->kinematics(); }
    core::Result<void> open() override { return m_device->open(); }
    void close() noexcept override { m_device->close(); }
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override { return m_device->read(now); }
    void command(const realtime::HapticTick& now, const devices::ForceCommand& command) noexcept override {
        m_device->command(now, command);
    }
    void show(const realtime::HapticTick& now, const core::VisibleCues& cues) noexcept override {
        m_device->show(now, cues);
    }

private:
    std::unique_ptr<devices::IDevice> m_device;
    devices::DeviceDescriptor m_descriptor;
};

} // namespace chiron::tests
