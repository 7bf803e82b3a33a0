// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "devices/api/workspace_map.h"
#include "mechanisms/fingertip_platform.h"
#include "mechanisms/hand_strategy.h"

#include <cstdint>

namespace chiron::devices {

/// The parts of P3's arm that each finger has for itself: its platform, and what the platform adds to a
/// sample and to the hand's perception. The platform follows ForceCommand::display, which the supervisor has
/// already limited.
/// Thread: haptic; allocates nothing.
class FingertipFinger {
public:
    FingertipFinger(const mechanisms::FingertipPlatformParameters& platform, double angleResolution_rad,
                    std::uint64_t seed) noexcept
        : m_platform(platform, seed), m_angleResolution_rad(angleResolution_rad) {}

    void reset() noexcept { m_platform.reset(); }
    void tick(const ForceCommand& command) noexcept { m_platform.tick(command.display, command.enabled); }
    /// Adds the platform axes, and as `measured` the force that the three resistors sense, along the pad's
    /// normal according to the arm's sensors.
    void addToSample(const IToolKinematics& kinematics, const WorkspaceMap& map,
                     core::DeviceSample& sample) const noexcept;
    void addToPerception(mechanisms::HandPerception& seen) const noexcept {
        seen.fingertip = true;
        seen.pad = m_platform.truth();
    }
    /// True state, for tests.
    const mechanisms::FingertipPlatform& platform() const noexcept { return m_platform; }

private:
    mechanisms::FingertipPlatform m_platform;
    double m_angleResolution_rad;
};

} // namespace chiron::devices
