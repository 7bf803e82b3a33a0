// SPDX-License-Identifier: GPL-3.0-or-later
// Tick code: the haptic thread's side of the link to a window. Nothing here allocates, locks or throws
// (tests/realtime).
#include "session/live_link.h"

#include "core/contact_bits.h"

#include <cmath>

namespace chiron::session {

namespace {

constexpr std::uint64_t kStatisticsEvery_ticks = 256; // same interval as in the loop's own tap

template <class A> double norm3(const A& v, std::size_t at = 0) noexcept {
    return std::sqrt(v[at] * v[at] + v[at + 1] * v[at + 1] + v[at + 2] * v[at + 2]);
}

} // namespace

LiveSample liveSampleOf(const haptics::DisplayState& shown, std::int64_t start_ns) noexcept {
    const haptics::ToolDisplay& tool = shown.tool[0];
    LiveSample sample;
    sample.tick = shown.tick;
    sample.t_s = static_cast<double>(shown.now_ns - start_ns) * 1e-9;
    std::array<double, 3> into{};
    for (std::size_t i = 0; i < 3; ++i) {
        sample.tissue_N[i] = static_cast<float>(tool.tissue[i]);
        sample.p_WT_m[i] = static_cast<float>(tool.p_WT_m[i]);
        into[i] = tool.p_WT_m[i] - tool.p_WProxy_m[i];
    }
    for (std::size_t i = 0; i < 4; ++i)
        sample.q_WT[i] = static_cast<float>(tool.q_WT[i]);
    const double tissue_N = norm3(tool.tissue);
    sample.tissueNorm_N = static_cast<float>(tissue_N);
    sample.torque_Nm = static_cast<float>(norm3(tool.tissue, 3));
    sample.commanded_N = static_cast<float>(norm3(tool.commanded));
    sample.speed_m_per_s = static_cast<float>(norm3(tool.v_WT_m_per_s));
    sample.depth_m = tissue_N > 0.0 ? static_cast<float>(norm3(into)) : 0.0f;
    for (std::size_t i = 0; i < sample.press.size() && static_cast<int>(i) < shown.tools; ++i) {
        sample.press[i] = {static_cast<float>(shown.tool[i].p_WProxy_m[0]),
                           static_cast<float>(shown.tool[i].p_WProxy_m[1]),
                           static_cast<float>(shown.tool[i].displayPose[0])};
        sample.yielded = sample.yielded || (shown.tool[i].contact & core::contact_bits::kYielded) != 0;
    }
    sample.guards = shown.guards;
    sample.events = shown.events;
    sample.phase = shown.phase;
    sample.paused = shown.paused;
    return sample;
}

void LiveLink::publish(const haptics::DisplayState& shown) noexcept {
    if (!m_started) {
        m_started = true;
        m_start_ns = shown.now_ns;
    }
    m_display.publish(shown);
    if (!m_samples.tryPush(liveSampleOf(shown, m_start_ns)))
        m_dropped.fetch_add(1, std::memory_order_relaxed);
}

void LiveLink::publish(const haptics::LoopStatistics& statistics) noexcept {
    if (statistics.ticks() % kStatisticsEvery_ticks == 0)
        m_statistics.publish(statistics);
}

} // namespace chiron::session
