// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::session {

/// What one stored tick says about a trial of a study: tool 0, W, SI. Small enough to be handed to a window's thread.
struct FidelitySample {
    std::uint64_t tick = 0;
    std::int64_t now_ns = 0;
    std::uint32_t events = 0; ///< core::event_bits
    std::uint32_t guards = 0; ///< core::guard_bits
    std::uint16_t trial = 0;
    core::TrialPhase phase = core::TrialPhase::idle;
    std::uint8_t place = 0;   ///< from 1; 0: none is touched
    std::uint8_t touched = 0; ///< places touched in this trial, one bit each
    std::uint8_t paused = 0;
    bool full = false;        ///< force is armed in full
    bool measures = false;    ///< `measured_N` is valid
    bool saturated = false;   ///< by the device's own word, or the supervisor's cap
    std::uint16_t candidate = 0;   ///< from 1
    std::uint16_t arrangement = 0; ///< from 1
    std::uint16_t answer = 0;      ///< from 1
    double displacement_m = 0.0;
    double depth_m = 0.0;
    std::array<double, 3> velocity_m_per_s{};
    std::array<double, 3> commanded_N{};
    std::array<double, 3> measured_N{};
    std::array<double, 3> tissue_N{}; ///< what the scene answered, whether or not it was rendered
};
static_assert(std::is_trivially_copyable_v<FidelitySample>);

/// Of a frame of a comparison session. Pure; haptic thread too.
FidelitySample fidelitySampleOf(const core::HapticFrame& frame) noexcept;

} // namespace chiron::session
