// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/command.h"
#include "core/device_sample.h"
#include "core/session_state.h"
#include "core/quantity.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::core {

/// Layout version of HapticFrame in memory and in the crash ring; raise it with every change of these structs.
inline constexpr std::uint32_t kFrameLayoutVersion = 2;

struct TickHeader {
    std::uint64_t index = 0;            ///< executed ticks since the session's first
    std::int64_t now_ns = 0;            ///< monotonic clock at the tick
    std::uint32_t events = 0;           ///< event_bits
    std::uint32_t guards = 0;           ///< guard_bits
    std::uint16_t trial = 0;            ///< 0-based
    std::uint16_t heartbeatAge_ms = 0;  ///< age of the last GUI heartbeat as the supervisor saw it, saturated
    TrialPhase phase = TrialPhase::idle;
    ForceState force = ForceState::off;
    std::uint8_t paused = 0;            ///< 1 while paused: left out of every metric
    std::uint8_t reserved = 0;
    std::array<Command, kMaxCommandsPerTick> commands{};
    /// Books of the passivity observer, all contacts summed, J: what people have put into the objects they touch, and what
    /// these hold (as rendered). Passive as long as held ≤ supplied (P2, passive object modelling; models.md §5).
    double energySupplied_J = 0.0;
    double energyStored_J = 0.0;
    std::array<double, kMaxQuantities> quantities{}; ///< of the scene, as its kind of exercise names them; the rest is zero
};

struct ToolFrame {
    std::array<std::int32_t, kMaxCoordinates> counts{};
    std::int32_t jawCounts = 0;
    std::uint32_t buttons = 0;
    std::uint32_t packet = 0;
    std::uint32_t status = 0;
    std::uint64_t deviceTime_us = 0;
    std::uint32_t age_us = 0; ///< now - arrival, in whole microseconds: what the watchdog uses
    std::uint32_t reserved = 0;
    Array6 tissue{};    ///< what the scene answered (N, N·m; on the tool, in W)
    Array6 commanded{}; ///< after the supervisor
    Array6 measured{};  ///< by the device; valid with sample_status::kMeasuredForce
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

/// Where the loop hands its frames: the crash ring when recording, a comparer when replaying. One producer.
class IFrameSink {
public:
    virtual ~IFrameSink() = default;
    /// Never blocks, allocates or throws; false when there is no room (counted; the session becomes incomplete).
    virtual bool tryPush(const HapticFrame& frame) noexcept = 0;
};

} // namespace chiron::core
