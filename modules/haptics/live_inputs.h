// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/tick_inputs.h"
#include "realtime/spsc_ring.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace chiron::haptics {

/// Inputs of a running session. Commands wait in a ring, from which each tick takes at most two; the
/// heartbeat is one atomic time.
/// Thread: gather() and postOwn() on the haptic thread; post() on one other thread (GUI or session); beat()
/// on any.
class LiveInputs final : public ITickInputs {
public:
    static constexpr std::size_t kCommandRing = 64;

    LiveInputs() = default;
    LiveInputs(const LiveInputs&) = delete;
    LiveInputs& operator=(const LiveInputs&) = delete;
    ~LiveInputs() override;

    /// Posts a command to the loop; returns false if 64 are already waiting.
    bool post(const core::Command& command) noexcept { return m_commands.tryPush(command); }

    /// Posts a command from the loop's own side (such as the end of a scripted run), so that a window can
    /// remain the only caller of post(). The next tick takes it before the commands in the ring. Returns
    /// false if two are already waiting.
    /// Thread: haptic, or any before the first tick.
    bool postOwn(const core::Command& command) noexcept {
        if (m_ownCount == m_own.size())
            return false;
        m_own[m_ownCount++] = command;
        return true;
    }

    /// Reports that the screen is alive, at this time of the runner's clock (ns). The first call switches the
    /// heartbeat on; without it (headless runs) its age is always 0. A run that watches the heartbeat calls
    /// beat() once before its first tick, so that a window that never appears counts as frozen.
    void beat(std::int64_t now_ns) noexcept { m_lastBeat_ns.store(now_ns, std::memory_order_relaxed); }

    /// Sets when a slow model's answers take effect: whenReady if a SlowModelThread steps the model, asDue
    /// (the default) if the tick does. Call it before the first tick.
    void setSlowUpdate(simulation::SlowUpdate when) noexcept { m_slow = when; }

    void gather(const realtime::HapticTick& now, std::span<devices::IDevice* const> devices,
                TickInputs& inputs) noexcept override;

private:
    static constexpr std::int64_t kNoHeartbeat = INT64_MIN;

    simulation::SlowUpdate m_slow = simulation::SlowUpdate::asDue;
    std::array<core::Command, core::kMaxCommandsPerTick> m_own{}; ///< of the haptic thread
    std::size_t m_ownCount = 0;
    realtime::SpscRing<core::Command, kCommandRing> m_commands;
    alignas(64) std::atomic<std::int64_t> m_lastBeat_ns{kNoHeartbeat};
};

} // namespace chiron::haptics
