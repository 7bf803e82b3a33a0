// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "devices/api/workspace_map.h"
#include "devices/drivers/station/station_handshake.h"
#include "devices/drivers/station/station_health.h"
#include "devices/drivers/station/station_link.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace chiron::devices {

/// A haptic station on the other end of a line (docs/station-protocol.md), as a tool.
///
/// Samples: a packet for each input frame; the numbers that are missing are counted on. A station that
/// reports a fault, that does not hold its motors on although it was told to (it let go, its dead-man switch
/// was released, commands no longer reach it), or whose line is gone, is a device fault to the supervisor:
/// force goes to zero at once and comes back only after a person has re-armed it, and the station sees
/// commands without enable until then. A station that is silent ages. While the station does not know its
/// position, no sample is valid. Commands: the effort of each axis by the kinematics, in micro-newtons (or
/// -metres), one frame a tick. Thread: as IDevice; health() on one other.
class StationTool final : public IDevice {
public:
    struct Configuration {
        StationAddress address;
        std::string where;        ///< the address as it was given, for messages
        WorkspaceMapping mapping; ///< converts `measured` to W
        double frictionCompensation = 0.0;
    };

    /// Connects for a moment to learn what the station is.
    /// Errors: device as in connectStation() and identifyStation(); badInput for kinematics that this program
    ///   does not have.
    static core::Result<std::unique_ptr<StationTool>> create(Configuration configuration);
    /// A tool for which no station was found: open() fails, and says what to do.
    static std::unique_ptr<StationTool> absent();
    ~StationTool() override;

    const DeviceDescriptor& descriptor() const noexcept override { return m_identity.descriptor; }
    const IToolKinematics& kinematics() const noexcept override { return *m_kinematics; }
    /// Connects, checks that the same station answers, measures the delay of its link (which the descriptor
    /// then states if it is more than the station's own) and starts the thread of the line.
    /// Errors: device.
    core::Result<void> open() override;
    void close() noexcept override; ///< motors off, confirmed by the station where it still answers
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override;
    void command(const realtime::HapticTick& now, const ForceCommand& command) noexcept override;
    bool steppedByHost() const noexcept override { return m_identity.lockstep; }
    bool awaitStep() noexcept override;

    StationHealth health() noexcept; ///< of the open link; of the last one after close()
    const StationIdentity& identity() const noexcept { return m_identity; }
    std::uint32_t roundTrip99_us() const noexcept { return m_roundTrip99_us; } ///< measured by open()

private:
    StationTool(Configuration configuration, StationIdentity identity,
                std::unique_ptr<IToolKinematics> kinematics, bool present);
    bool isFault(const LinkInput& link) const noexcept;
    core::Wrench measured_W(const station_input& input) const noexcept;

    /// What was sent with a number, for the frames that tell of it.
    struct Sent {
        std::uint16_t sequence = 0;
        bool enabled = false;
        core::Wrench compensation_D;
    };
    const Sent* sentAs(std::uint16_t sequence) const noexcept;

    Configuration m_configuration;
    StationIdentity m_identity;
    std::unique_ptr<IToolKinematics> m_kinematics; ///< never null
    bool m_present;
    WorkspaceMap m_map;
    std::uint32_t m_statedOldest_us; ///< by the station itself
    std::uint32_t m_roundTrip99_us = 0;
    std::uint16_t m_mostBehind = 0; ///< commands that may be on their way or waiting for their answer
    StationHealth m_lastHealth;
    std::unique_ptr<StationLink> m_link; ///< while open

    // Of the tick.
    core::DeviceSample m_sample;
    station_input m_input{};
    std::array<Sent, 64> m_sent{};
    std::uint16_t m_sequence = 0;
    std::uint32_t m_enabledTicks = 0; ///< commands with enable in a row, saturates
    std::uint32_t m_faultTicks = 0;   ///< that the station's fault has lasted with the motors off
};

} // namespace chiron::devices
