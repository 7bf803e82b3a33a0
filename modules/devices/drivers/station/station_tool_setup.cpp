// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/station_tool.h"

#include "devices/drivers/cartesian/cartesian_kinematics.h"
#include "devices/kinematics_catalogue.h"

#include <algorithm>
#include <utility>

namespace chiron::devices {

namespace {

constexpr const char* kDriverId = "station";

/// A station that nobody has asked yet what it is: the usual device of three axes.
StationIdentity unknownStation() {
    StationIdentity identity;
    DeviceDescriptor& d = identity.descriptor;
    d.driver = kDriverId;
    d.model = "Haptic station (not connected)";
    d.kinematics = "cartesian";
    for (const char* id : {"x", "y", "z"})
        d.axes.push_back({.id = id, .minimum = -0.1, .maximum = 0.1});
    d.rendersForce = true;
    d.maximumDamping_Ns_per_m = 1.0;
    return identity;
}

/// Connects and asks what is there.
core::Result<std::pair<std::unique_ptr<IStationTransport>, StationIdentity>>
ask(const StationAddress& address, const std::string& where) {
    auto transport = connectStation(address);
    CHIRON_TRY(transport);
    auto identity = identifyStation(**transport, where);
    CHIRON_TRY(identity);
    identity->descriptor.driver = kDriverId;
    return std::pair(std::move(*transport), std::move(*identity));
}

} // namespace

StationTool::StationTool(Configuration configuration, StationIdentity identity,
                         std::unique_ptr<IToolKinematics> kinematics, bool present)
    : m_configuration(std::move(configuration)), m_identity(std::move(identity)),
      m_kinematics(std::move(kinematics)), m_present(present), m_map(m_configuration.mapping),
      m_statedOldest_us(m_identity.descriptor.oldestSample_us) {
    m_sample.status = core::sample_status::kInvalid;
}

StationTool::~StationTool() {
    close();
}

core::Result<std::unique_ptr<StationTool>> StationTool::create(Configuration configuration) {
    auto asked = ask(configuration.address, configuration.where);
    CHIRON_TRY(asked);
    StationIdentity& identity = asked->second;
    identity.descriptor.frictionCompensation =
        std::clamp(configuration.frictionCompensation, 0.0, kMostFrictionCompensation);
    auto kinematics = makeKinematics(identity.descriptor);
    if (!kinematics)
        return core::fail(core::ErrorCode::badInput,
                          "station at " + configuration.where + ": " + kinematics.error().message);
    return std::unique_ptr<StationTool>(
        new StationTool(std::move(configuration), std::move(identity), std::move(*kinematics), true));
}

std::unique_ptr<StationTool> StationTool::absent() {
    StationIdentity identity = unknownStation();
    auto kinematics =
        std::make_unique<CartesianKinematics>(*CartesianKinematics::create(identity.descriptor));
    return std::unique_ptr<StationTool>(
        new StationTool({}, std::move(identity), std::move(kinematics), false));
}

core::Result<void> StationTool::open() {
    if (!m_present)
        return core::fail(core::ErrorCode::device,
                          "no haptic station was named; expected where it is connected (tcp:HOST:PORT, "
                          "serial:/dev/NAME or hid:VVVV:PPPP)");
    close();
    auto asked = ask(m_configuration.address, m_configuration.where);
    CHIRON_TRY(asked);
    if (!isSameStation(asked->second, m_identity))
        return core::fail(core::ErrorCode::device,
                          "station at " + m_configuration.where +
                              ": it is not the one that was set up, but " + asked->second.descriptor.model +
                              " " + asked->second.descriptor.serialNumber + "; set the session up again");
    const auto start = startStation(*asked->first, m_identity, m_configuration.where);
    CHIRON_TRY(start);
    m_roundTrip99_us = start->roundTrip99_us;
    m_identity.descriptor.oldestSample_us = std::max(m_statedOldest_us, m_roundTrip99_us);
    // What the supervisor guards against, and as much as it allows a packet to be late before it lets go.
    constexpr std::uint32_t kLate_ticks = 5;
    m_mostBehind =
        static_cast<std::uint16_t>(m_identity.descriptor.guardedDelay_us() / 1000 + 1 + kLate_ticks);
    m_sample = {};
    m_sample.status = core::sample_status::kInvalid;
    m_input = start->newest;
    m_sent = {};
    m_sequence = start->sequence;
    m_sent[m_sequence % m_sent.size()] = {m_sequence, false, {}};
    m_enabledTicks = m_faultTicks = 0;
    m_link = std::make_unique<StationLink>(
        std::move(asked->first),
        StationLink::Settings{m_configuration.address, m_configuration.where, m_identity}, *start);
    return {};
}

void StationTool::close() noexcept {
    if (!m_link)
        return;
    m_link->finish();
    m_lastHealth = m_link->health();
    m_link.reset();
}

bool StationTool::awaitStep() noexcept {
    return m_link && m_identity.lockstep && m_link->awaitStep();
}

StationHealth StationTool::health() noexcept {
    return m_link ? m_link->health() : m_lastHealth;
}

} // namespace chiron::devices
