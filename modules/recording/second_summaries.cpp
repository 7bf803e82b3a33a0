// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/second_summaries.h"

#include "recording/wrench_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::recording {

namespace {
constexpr std::uint64_t kSecond_us = 1'000'000;

/// Returns floor((t − zero) / 1 s), saturated; 0 for a time before zero.
std::uint32_t secondOf(std::uint64_t t_us, std::uint64_t zero_us) noexcept {
    if (t_us < zero_us)
        return 0;
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>((t_us - zero_us) / kSecond_us, std::numeric_limits<std::uint32_t>::max()));
}
} // namespace

SecondSummaries::SecondSummaries(const IPositionOf& positionOf, double forceLimit_N) noexcept
    : m_positionOf(&positionOf), m_forceLimit_N(forceLimit_N) {}

void SecondSummaries::add(const core::HapticFrame& frame, std::vector<SecondSummary>& done) {
    const int tools = static_cast<int>(std::min<std::uint32_t>(frame.tools, core::kMaxTools));
    for (int t = 0; t < tools; ++t)
        addTool(t, frame, done);
}

void SecondSummaries::addTool(int tool, const core::HapticFrame& frame, std::vector<SecondSummary>& done) {
    Tool& state = m_tools[static_cast<std::size_t>(tool)];
    const core::ToolFrame& sample = frame.tool[static_cast<std::size_t>(tool)];
    // Neither the position nor the time of a refused packet can be trusted.
    if ((sample.status & core::sample_status::kRefused) != 0) {
        state.sum.events |= state.open ? frame.header.events : 0u;
        return;
    }
    if (!state.started) {
        state.started = true;
        state.zero_us = sample.deviceTime_us;
    }
    const std::uint32_t second = std::max(state.sum.second, secondOf(sample.deviceTime_us, state.zero_us));
    if (state.open && second != state.sum.second)
        close(state, done);
    state.open = true;
    state.sum.second = second;
    state.sum.tool = static_cast<std::uint8_t>(tool);
    state.sum.events |= frame.header.events;
    if (frame.header.paused == 0)
        addMoving(state, sample, m_positionOf->p_WT_m(tool, sample));
    state.hasLast = frame.header.paused == 0;
}

void SecondSummaries::addMoving(Tool& state, const core::ToolFrame& frame,
                                const core::Vec3& p_WT) const noexcept {
    SecondSummary& sum = state.sum;
    const core::Array6 f = roundedWrench(frame.tissue);
    const double force_N = std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    const bool finite = std::isfinite(force_N);
    const bool forward = state.hasLast && frame.deviceTime_us > state.last_us;
    const double dt_s = forward ? static_cast<double>(frame.deviceTime_us - state.last_us) * 1e-6 : 0.0;
    ++sum.frames;
    if (state.hasLast)
        sum.pathLength_m += (p_WT - state.p_WT).norm();
    if (finite) {
        sum.maximumForce_N = std::max(sum.maximumForce_N, force_N);
        state.forceSum_N += force_N;
        ++state.forces;
        if (std::isfinite(state.lastForce_N))
            sum.impulse_Ns += 0.5 * (state.lastForce_N + force_N) * dt_s;
    }
    if (force_N > m_forceLimit_N)
        sum.timeOverLimit_s += dt_s;
    state.p_WT = p_WT;
    state.last_us = frame.deviceTime_us;
    state.lastForce_N = force_N;
}

void SecondSummaries::close(Tool& state, std::vector<SecondSummary>& done) {
    state.sum.meanForce_N = state.forces > 0 ? state.forceSum_N / state.forces : 0.0;
    done.push_back(state.sum);
    const std::uint32_t second = state.sum.second;
    state.sum = {};
    state.sum.second = second;
    state.forceSum_N = 0.0;
    state.forces = 0;
    state.open = false;
}

void SecondSummaries::finish(std::vector<SecondSummary>& done) {
    for (Tool& state : m_tools)
        if (state.open)
            close(state, done);
}

} // namespace chiron::recording
