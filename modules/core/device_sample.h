// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"

#include <array>
#include <cstdint>

namespace chiron::core {

namespace sample_status {
inline constexpr std::uint32_t kMeasuredForce = 1u << 0; ///< `measured` is valid
inline constexpr std::uint32_t kSaturated = 1u << 1;     ///< a motor ran at its limit
inline constexpr std::uint32_t kHomed = 1u << 2;
inline constexpr std::uint32_t kDeviceFault = 1u << 3; ///< the device itself reports a fault
inline constexpr std::uint32_t kInvalid = 1u << 4;     ///< the driver could not decode a usable pose
                                                       ///< (non-finite)
/// Only in recorded frames, set by the loop: the supervisor refused this packet (models.md §5, sample
/// sanity), so the tool was taken to be where the last good packet left it. Metrics leave it out.
inline constexpr std::uint32_t kRefused = 1u << 31;
// Bits 28 to 30 of recorded frames hold the scene's contact flags (core/contact_bits.h), set by the loop.
} // namespace sample_status

/// One packet of one tool, in integers on the device's declared grid (DeviceDescriptor::axes), as it is
/// recorded. It holds everything that a replay needs. Trivially copyable.
struct DeviceSample {
    std::array<std::int32_t, kMaxCoordinates> counts{};
    std::int32_t jawCounts = 0;
    std::uint32_t buttons = 0;
    /// Increases by one per packet. Reading the same packet again counts as age, not as a repeat.
    std::uint32_t packet = 0;
    std::uint32_t status = 0;        ///< sample_status bits
    std::uint64_t deviceTime_us = 0; ///< the device's own clock, monotonic
    std::int64_t arrival_ns = 0; ///< when the host received this packet, in the clock of HapticTick::now_ns
    Array6 measured{};           ///< wrench on the tool in W as the device measured it (N, N·m)
};

} // namespace chiron::core
