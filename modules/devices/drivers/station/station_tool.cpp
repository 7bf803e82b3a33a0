// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/station_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::devices {

namespace {

/// A fault stays in view for so long before the station is asked to clear it, so that nobody misses it.
constexpr std::uint32_t kClearAfter_ticks = 200;

template <class Integer> Integer inCounts(double value, double count) noexcept {
    constexpr double kMost = std::numeric_limits<Integer>::max();
    const double counts = value / count;
    if (!(std::abs(counts) <= kMost)) // also what is not a number
        return counts > 0.0   ? std::numeric_limits<Integer>::max()
               : counts < 0.0 ? static_cast<Integer>(-std::numeric_limits<Integer>::max())
                              : Integer{0};
    return static_cast<Integer>(std::lround(counts));
}

/// Two buttons have a meaning; the other two are for later versions.
std::uint32_t buttonsOf(const station_input& input) noexcept {
    std::uint32_t buttons = 0;
    if ((input.flags & STATION_INPUT_DEAD_MAN) != 0)
        buttons |= core::kButtonDeadMan;
    if ((input.flags & 0x10u) != 0)
        buttons |= core::kButtonMark;
    if ((input.flags & 0x20u) != 0)
        buttons |= core::kButtonStop;
    return buttons;
}

} // namespace

const StationTool::Sent* StationTool::sentAs(std::uint16_t sequence) const noexcept {
    const Sent& sent = m_sent[sequence % m_sent.size()];
    return sent.sequence == sequence ? &sent : nullptr;
}

/// Whether force must not go on: told to the supervisor as a fault of the device.
bool StationTool::isFault(const LinkInput& link) const noexcept {
    const station_input& input = link.input;
    if (link.gone || input.state == STATION_FAULT || input.state == STATION_UNKNOWN)
        return true;
    const bool applied = input.applied_age_ms < 255;
    const Sent* const sent = sentAs(input.applied_sequence);
    // It has seen a command with enable, and its motors are off.
    if (applied && sent != nullptr && sent->enabled && input.state != STATION_ARMED)
        return true;
    if (m_enabledTicks <= kStationHold_ms)
        return false;
    // Commands no longer reach it: if they reached it again later, force would set in with a jump. Or what it
    // tells is older than its link was measured to be: force would answer to where the hand was.
    const auto behind = static_cast<std::uint16_t>(m_sequence - input.applied_sequence);
    return input.applied_age_ms > kStationHold_ms || behind > m_mostBehind;
}

core::Wrench StationTool::measured_W(const station_input& input) const noexcept {
    constexpr double kForce_N = 1e-3, kTorque_Nm = 1e-4;
    core::Wrench wrench;
    for (int i = 0; i < 3; ++i) {
        wrench.force[i] = kForce_N * input.wrench[i];
        wrench.torque[i] = kTorque_Nm * input.wrench[3 + i];
    }
    if (const Sent* const sent = sentAs(input.applied_sequence); sent != nullptr) {
        wrench.force -= sent->compensation_D.force;
        wrench.torque -= sent->compensation_D.torque;
    }
    return m_map.wrenchToW(wrench);
}

core::DeviceSample StationTool::read(const realtime::HapticTick& now) noexcept {
    if (!m_link)
        return m_sample;
    const LinkInput& link = m_link->newest();
    const bool everHomed = (m_sample.status & core::sample_status::kInvalid) == 0;
    if (link.input.state == STATION_UNKNOWN && !everHomed)
        return m_sample; // still invalid: the supervisor waits for the first packet
    m_input = link.input;
    const bool fresh = link.packet != m_sample.packet;
    for (std::size_t axis = 0; axis < m_identity.descriptor.axes.size(); ++axis)
        m_sample.counts[axis] = m_input.counts[axis];
    m_sample.jawCounts = m_input.jaw;
    m_sample.buttons = buttonsOf(m_input);
    m_sample.packet = link.packet;
    m_sample.deviceTime_us = link.deviceTime_us;
    if (!m_identity.lockstep)
        m_sample.arrival_ns = link.arrival_ns;
    else if (fresh)
        m_sample.arrival_ns = now.now_ns(); // both sides have one clock, which is the loop's
    std::uint32_t status = 0;
    if ((m_input.status & STATION_STATUS_WRENCH_VALID) != 0) {
        status |= core::sample_status::kMeasuredForce;
        m_sample.measured = core::toArray(measured_W(m_input));
    } else {
        m_sample.measured = {};
    }
    if ((m_input.status & STATION_STATUS_AT_LIMIT) != 0)
        status |= core::sample_status::kSaturated;
    if ((m_input.flags & STATION_INPUT_HOMED) != 0)
        status |= core::sample_status::kHomed;
    if (isFault(link))
        status |= core::sample_status::kDeviceFault;
    if (m_input.state == STATION_UNKNOWN)
        status |= core::sample_status::kInvalid;
    m_sample.status = status;
    const bool resting = m_input.state == STATION_FAULT && m_enabledTicks == 0;
    m_faultTicks = resting ? m_faultTicks + 1 : 0;
    return m_sample;
}

void StationTool::command(const realtime::HapticTick&, const ForceCommand& command) noexcept {
    if (!m_link)
        return;
    constexpr double kEffort = 1e-6, kForce_N = 1e-3, kAngle_rad = 1e-4;
    station_output output{};
    output.sequence = ++m_sequence;
    output.answered_sequence = m_input.sequence;
    output.hold_ms = kStationHold_ms;
    if (command.enabled) {
        output.flags |= STATION_OUTPUT_ENABLE;
        const AxisValues efforts = m_kinematics->efforts(m_sample, command.wrench_D);
        for (std::size_t axis = 0; axis < m_identity.descriptor.axes.size(); ++axis)
            output.effort[axis] = inCounts<std::int32_t>(efforts[axis], kEffort);
        if (m_identity.platform) {
            output.flags |= STATION_OUTPUT_DISPLAY;
            output.display_force_mN = inCounts<std::int16_t>(command.display.normalForce_N, kForce_N);
            output.display_pitch_1e4_rad = inCounts<std::int16_t>(command.display.pitch_rad, kAngle_rad);
            output.display_roll_1e4_rad = inCounts<std::int16_t>(command.display.roll_rad, kAngle_rad);
        }
    } else if (m_faultTicks >= kClearAfter_ticks) {
        output.flags |= STATION_OUTPUT_CLEAR_FAULT;
        m_faultTicks = 0;
    }
    m_enabledTicks = command.enabled ? std::min(m_enabledTicks + 1, 1'000'000u) : 0;
    m_sent[m_sequence % m_sent.size()] = {m_sequence, command.enabled,
                                          command.enabled ? command.compensation_D : core::Wrench{}};
    m_link->put(output);
}

} // namespace chiron::devices
