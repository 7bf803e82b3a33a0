// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::haptics {

/// Selects which rows of the supervisor's table act. Only tests change it: with it the property test shows
/// that it fails without each guard.
struct GuardMask {
    static constexpr std::uint32_t kCaps = 1u << 0;
    static constexpr std::uint32_t kSlew = 1u << 1;
    static constexpr std::uint32_t kArming = 1u << 2;
    static constexpr std::uint32_t kOverVelocity = 1u << 3;
    static constexpr std::uint32_t kSanity = 1u << 4;
    static constexpr std::uint32_t kWatchdog = 1u << 5;
    static constexpr std::uint32_t kStop = 1u << 6;
    static constexpr std::uint32_t kHeartbeat = 1u << 7;
    static constexpr std::uint32_t kPassivity = 1u << 8;
    static constexpr std::uint32_t kFinite = 1u << 9;
    static constexpr std::uint32_t kPause = 1u << 10;

    std::uint32_t bits = ~0u;

    constexpr bool has(std::uint32_t guard) const noexcept { return (bits & guard) != 0; }
    static constexpr GuardMask without(std::uint32_t guard) noexcept { return GuardMask{~guard}; }
};

} // namespace chiron::haptics
