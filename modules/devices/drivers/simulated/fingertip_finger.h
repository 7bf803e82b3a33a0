// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "devices/api/workspace_map.h"
#include "mechanisms/fingertip_platform.h"
#include "mechanisms/hand_strategy.h"

#include <cstdint>

namespace chiron::devices {

/// What any finger of P3's arm has of its own: its platform, and what that adds to a sample and to what the hand feels.
/// The platform follows ForceCommand::display, which the supervisor has already limited. Haptic thread; no allocation.
class FingertipFinger {
public:
    FingertipFinger(const mechanisms::FingertipPlatformParameters& platform, double angleResolution_rad, std::uint64_t seed) noexcept
        : m_platform(platform, seed), m_angleResolution_rad(angleResolution_rad) {}

    void reset() noexcept { m_platform.reset(); }
    void tick(const ForceCommand& command) noexcept { m_platform.tick(command.display, command.enabled); }
    /// Platform axes, and as `measured` what the three resistors sense, along the pad's normal as the arm's sensors know it.
    void addToSample(const IToolKinematics& kinematics, const WorkspaceMap& map, core::DeviceSample& sample) const noexcept;
    void addToPerception(mechanisms::HandPerception& seen) const noexcept {
        seen.fingertip = true;
        seen.pad = m_platform.truth();
    }
    const mechanisms::FingertipPlatform& platform() const noexcept { return m_platform; } ///< the truth, for tests

private:
    mechanisms::FingertipPlatform m_platform;
    double m_angleResolution_rad;
};

} // namespace chiron::devices
