// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/command.h"
#include "core/geometry.h"
#include "core/tool_state.h"

#include <array>
#include <cstdint>

namespace chiron::test {

/// What went into one tick, as the generator knows it.
struct OracleTick {
    std::array<core::Command, core::kMaxCommandsPerTick> commands{};
    std::uint16_t heartbeatAge_ms = 0;
    bool sceneChanged = false;
    bool stopButton = false;
    bool deadMan = false;
    std::array<core::Wrench, core::kMaxTools> requested{}; ///< as asked, rubbish included
    std::array<core::ToolState, core::kMaxTools> states{};
    std::array<std::uint32_t, core::kMaxTools> goodAge_us{}; ///< of the newest good packet; 0: none yet
    std::array<int, core::kMaxTools> badInARow{};
    bool deviceFault = false;
};

} // namespace chiron::test
