// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/random.h"
#include "recording/channel_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace chiron::tests {

/// A made-up but plausible 1 kHz recording of a hand feeling a hemisphere, for sizes and speeds: voluntary
/// movement (0.3-2 Hz, centimetres), physiological tremor (8-12 Hz, 0.1 mm), encoders of 10 um and 0.1 mrad,
/// contact forces that follow from the quantised position (500 N/m, friction 0.2), torques of a 2 mm lever, a
/// slewing supervisor, measured wrenches with noise of 5 mN and 0.05 mN·m, host jitter with rare late ticks,
/// and a device clock that jitters by 20 us against the host. All three wrenches have six live components;
/// without `torques` three, as a point contact's.
class HapticTrace {
public:
    explicit HapticTrace(std::uint64_t seed, int tools = 1, bool torques = true)
        : m_random(seed), m_tools(tools), m_torques(torques) {
        for (double& phase : m_phase)
            phase = m_random.uniform(0.0, 6.28);
    }

    static std::vector<recording::ToolChannels> channels(int tools) {
        recording::ToolChannels one;
        one.axes = {
            {"x", "m", kStep_m}, {"y", "m", kStep_m}, {"z", "m", kStep_m}, {"roll", "rad", kStep_rad}};
        one.jawResolution_rad = kStep_rad;
        return std::vector<recording::ToolChannels>(static_cast<std::size_t>(tools), one);
    }

    core::HapticFrame next() {
        core::HapticFrame frame;
        frame.tools = static_cast<std::uint32_t>(m_tools);
        const double late_us = m_random.uniform() < 0.01 ? -30.0 * std::log(1.0 - m_random.uniform()) : 0.0;
        frame.header.index = m_tick;
        frame.header.now_ns =
            5'000'000'000'000 + static_cast<std::int64_t>(m_tick) * 1'000'000 +
            static_cast<std::int64_t>(std::abs(m_random.normal()) * 300.0 + late_us * 1000.0);
        frame.header.phase = core::TrialPhase::running;
        frame.header.force = core::ForceState::on;
        frame.header.heartbeatAge_ms = static_cast<std::uint16_t>(m_tick % 17);
        frame.header.trial = static_cast<std::uint16_t>(m_tick / 20'000);
        frame.header.events = m_tick % 20'000 == 0 ? core::event_bits::kTrialStarted : 0;
        for (int t = 0; t < m_tools; ++t)
            fill(frame.tool[static_cast<std::size_t>(t)], t, frame.header.now_ns);
        ++m_tick;
        return frame;
    }

    std::vector<core::HapticFrame> take(std::size_t frames) {
        std::vector<core::HapticFrame> all;
        for (std::size_t i = 0; i < frames; ++i)
            all.push_back(next());
        return all;
    }

private:
    static constexpr double kStep_m = 1e-5;
    static constexpr double kStep_rad = 1e-4;

    double wave(double hz, double amplitude, std::size_t phase) const {
        return amplitude *
               std::sin(6.283185307179586 * hz * 0.001 * static_cast<double>(m_tick) + m_phase[phase]);
    }

    void fill(core::ToolFrame& tool, int number, std::int64_t now_ns) {
        const auto shift = static_cast<std::size_t>(number) * 3;
        std::array<double, 4> q{};
        for (std::size_t k = 0; k < 3; ++k)
            q[k] = wave(0.31 + 0.1 * static_cast<double>(k), k == 2 ? 0.001 : 0.012, (k + shift) % 12) +
                   wave(1.7 - 0.2 * static_cast<double>(k), k == 2 ? 0.0005 : 0.002, (k + shift + 3) % 12) +
                   wave(8.9 + static_cast<double>(k), 1e-4, (k + shift + 6) % 12);
        q[3] = wave(0.4, 0.5, shift % 12) + wave(9.5, 0.002, (shift + 5) % 12);
        for (std::size_t k = 0; k < 4; ++k)
            tool.counts[k] = static_cast<std::int32_t>(std::lround(q[k] / (k < 3 ? kStep_m : kStep_rad)));
        tool.packet = static_cast<std::uint32_t>(1000 + m_tick);
        tool.deviceTime_us = 77'000'000 + m_tick * 1000;
        tool.age_us = static_cast<std::uint32_t>(
            std::max(0.0, 350.0 + m_random.normal() * 20.0 + static_cast<double>(now_ns % 1'000'000) * 1e-3));
        tool.status = core::sample_status::kHomed | core::sample_status::kMeasuredForce;
        tool.buttons = (m_tick / 1500) % 7 == 3 ? core::kButtonMark : 0;
        addForces(tool);
    }

    void addForces(core::ToolFrame& tool) {
        const double depth = -kStep_m * tool.counts[2] + 0.0005;
        const double normal = 500.0 * std::max(0.0, depth);
        const std::array<double, 2> slope = {kStep_m * tool.counts[0] / 0.02,
                                             kStep_m * tool.counts[1] / 0.02};
        const std::array<double, 2> friction = {
            0.2 * std::cos(m_phase[1] + 0.002 * static_cast<double>(m_tick)),
            0.2 * std::sin(m_phase[1] + 0.002 * static_cast<double>(m_tick))};
        tool.tissue = {
            normal * (slope[0] - friction[0]), normal * (slope[1] - friction[1]), normal, 0.0, 0.0, 0.0};
        const double roll = kStep_rad * tool.counts[3];
        const double length = m_torques ? 0.002 : 0.0;
        const std::array<double, 3> lever = {length * std::cos(roll), length * std::sin(roll), 0.5 * length};
        tool.tissue[3] = lever[1] * tool.tissue[2] - lever[2] * tool.tissue[1] + 0.0; // no -0.0
        tool.tissue[4] = lever[2] * tool.tissue[0] - lever[0] * tool.tissue[2] + 0.0;
        tool.tissue[5] = lever[0] * tool.tissue[1] - lever[1] * tool.tissue[0] + 0.0;
        const double cap = normal > 1.2 ? 1.2 / normal : 1.0;
        for (std::size_t i = 0; i < 6; ++i) {
            tool.commanded[i] = tool.tissue[i] * cap;
            tool.measured[i] = tool.commanded[i] + m_random.normal() * (i < 3       ? 0.005
                                                                        : m_torques ? 0.00005
                                                                                    : 0.0);
        }
    }

    core::Random m_random;
    std::array<double, 12> m_phase{};
    std::uint64_t m_tick = 0;
    int m_tools;
    bool m_torques;
};

/// Frames of nothing but random bits in every recorded field (wrenches include NaN, infinities and huge
/// numbers).
inline core::HapticFrame randomFrame(core::Random& random, int tools, std::uint64_t tick) {
    core::HapticFrame frame;
    frame.tools = static_cast<std::uint32_t>(tools);
    core::TickHeader& h = frame.header;
    h.index = tick;
    h.now_ns = static_cast<std::int64_t>(random.next());
    h.events = static_cast<std::uint32_t>(random.next());
    h.guards = static_cast<std::uint32_t>(random.next());
    h.trial = static_cast<std::uint16_t>(random.next());
    h.heartbeatAge_ms = static_cast<std::uint16_t>(random.next());
    h.phase = static_cast<core::TrialPhase>(random.below(5));
    h.force = static_cast<core::ForceState>(random.below(10));
    h.paused = static_cast<std::uint8_t>(random.below(2));
    for (core::Command& c : h.commands)
        c = {static_cast<core::CommandKind>(random.below(9)), static_cast<std::uint16_t>(random.next())};
    const auto real = [&random]() -> double {
        switch (random.below(12)) {
        case 0:
            return std::numeric_limits<double>::quiet_NaN();
        case 1:
            return std::numeric_limits<double>::infinity();
        case 2:
            return -std::numeric_limits<double>::infinity();
        case 3:
            return std::numeric_limits<double>::denorm_min();
        case 4:
            return 1e300 * random.normal();
        default:
            return 5.0 * random.normal();
        }
    };
    for (int t = 0; t < tools; ++t) {
        core::ToolFrame& tool = frame.tool[static_cast<std::size_t>(t)];
        for (std::size_t k = 0; k < 4; ++k)
            tool.counts[k] = static_cast<std::int32_t>(random.next());
        tool.jawCounts = static_cast<std::int32_t>(random.next());
        tool.buttons = static_cast<std::uint32_t>(random.next());
        tool.packet = static_cast<std::uint32_t>(random.next());
        tool.status = static_cast<std::uint32_t>(random.next());
        tool.deviceTime_us = random.next();
        tool.age_us = static_cast<std::uint32_t>(random.next());
        for (auto* wrench : {&tool.tissue, &tool.commanded, &tool.measured})
            for (double& v : *wrench)
                v = real();
        for (double& v : tool.display)
            v = real();
    }
    return frame;
}

/// Bitwise, so that NaN equals NaN.
inline bool sameFrame(const core::HapticFrame& a, const core::HapticFrame& b) {
    return std::memcmp(&a, &b, sizeof(core::HapticFrame)) == 0;
}

} // namespace chiron::tests
