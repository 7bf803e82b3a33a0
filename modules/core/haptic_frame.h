// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/command.h"
#include "core/device_sample.h"
#include "core/quantity.h"
#include "core/session_state.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::core {

/// Layout version of HapticFrame in memory and in the crash ring; raise it with every change of these
/// structs.
inline constexpr std::uint32_t kFrameLayoutVersion = 2;

struct TickHeader {
    std::uint64_t index = 0;           ///< executed ticks since the session's first
    std::int64_t now_ns = 0;           ///< monotonic clock at the tick, ns
    std::uint32_t events = 0;          ///< event_bits
    std::uint32_t guards = 0;          ///< guard_bits
    std::uint16_t trial = 0;           ///< 0-based
    std::uint16_t heartbeatAge_ms = 0; ///< age of the last GUI heartbeat as the supervisor saw it, saturated
    TrialPhase phase = TrialPhase::idle;
    ForceState force = ForceState::off;
    std::uint8_t paused = 0; ///< 1 while paused; metrics leave these ticks out
    std::uint8_t reserved = 0;
    std::array<Command, kMaxCommandsPerTick> commands{};
    /// Energy balance of the passivity observer, summed over all contacts, J: the energy that people have put
    /// into the objects they touch, and the energy that these objects hold (as rendered). Passive as long as
    /// held ≤ supplied (P2, passive object modelling; models.md §5).
    double energySupplied_J = 0.0;
    double energyStored_J = 0.0;
    /// Recorded quantities of the scene, in the order in which its exercise names them; unused entries are
    /// zero.
    std::array<double, kMaxQuantities> quantities{};
};

struct ToolFrame {
    std::array<std::int32_t, kMaxCoordinates> counts{};
    std::int32_t jawCounts = 0;
    std::uint32_t buttons = 0;
    std::uint32_t packet = 0;
    std::uint32_t status = 0;
    std::uint64_t deviceTime_us = 0;
    std::uint32_t age_us = 0; ///< now - arrival in whole microseconds; the watchdog uses it
    std::uint32_t reserved = 0;
    Array6 tissue{};                 ///< computed by the scene (N, N·m; on the tool, in W)
    Array6 commanded{};              ///< after the supervisor
    Array6 measured{};               ///< measured by the device; valid with sample_status::kMeasuredForce
    std::array<double, 3> display{}; ///< normal force N, pitch rad, roll rad
};

/// One executed tick, as recorded. Trivially copyable; only the first `tools` entries count.
struct HapticFrame {
    std::uint32_t layout = kFrameLayoutVersion;
    std::uint32_t tools = 0; ///< 1..kMaxTools
    TickHeader header;
    std::array<ToolFrame, kMaxTools> tool{};
};

static_assert(std::is_trivially_copyable_v<HapticFrame>);

/// Receives the loop's frames: the crash ring when recording, a comparer when replaying. There is one
/// producer.
class IFrameSink {
public:
    virtual ~IFrameSink() = default;
    /// Returns false if there is no room; the caller counts this, and the session becomes incomplete.
    /// Thread: haptic; never blocks, allocates or throws.
    virtual bool tryPush(const HapticFrame& frame) noexcept = 0;
};

} // namespace chiron::core
