// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/live_inputs.h"

#include <algorithm>
#include <limits>

namespace chiron::haptics {

namespace {
/// Returns the whole units of `unit_ns` from `since` to `now`: 0 if `since` is later, and at most the largest
/// value of T.
template <class T> T age(std::int64_t now_ns, std::int64_t since_ns, std::int64_t unit_ns) noexcept {
    std::int64_t elapsed_ns = 0;
    if (__builtin_sub_overflow(now_ns, since_ns, &elapsed_ns))
        return now_ns > since_ns ? std::numeric_limits<T>::max() : T{0};
    constexpr std::int64_t kMost = std::numeric_limits<T>::max();
    return static_cast<T>(std::clamp<std::int64_t>(elapsed_ns / unit_ns, 0, kMost));
}
} // namespace

void LiveInputs::gather(const realtime::HapticTick& now, std::span<devices::IDevice* const> devices,
                        TickInputs& inputs) noexcept {
    for (std::size_t i = 0; i < inputs.commands.size(); ++i) {
        inputs.commands[i] = i < m_ownCount ? m_own[i] : core::Command{};
        if (i >= m_ownCount)
            m_commands.tryPop(inputs.commands[i]);
    }
    m_ownCount = 0;
    inputs.slow = m_slow;
    const std::int64_t beat_ns = m_lastBeat_ns.load(std::memory_order_relaxed);
    inputs.heartbeatAge_ms =
        beat_ns == kNoHeartbeat ? std::uint16_t{0} : age<std::uint16_t>(now.now_ns(), beat_ns, 1'000'000);
    for (std::size_t i = 0; i < devices.size() && i < inputs.tools.size(); ++i) {
        ToolInput& tool = inputs.tools[i];
        tool.sample = devices[i]->read(now);
        tool.age_us = age<std::uint32_t>(now.now_ns(), tool.sample.arrival_ns, 1'000);
    }
}

} // namespace chiron::haptics
