// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::session {

/// The data of one stored tick about a trial of a study, for tool 0. Small enough to be passed to a window's
/// thread.
/// Unit: SI.
/// Frame: W.
struct FidelitySample {
    std::uint64_t tick = 0;
    std::int64_t now_ns = 0;
    std::uint32_t events = 0; ///< core::event_bits
    std::uint32_t guards = 0; ///< core::guard_bits
    std::uint16_t trial = 0;
    core::TrialPhase phase = core::TrialPhase::idle;
    std::uint8_t place = 0;   ///< from 1; 0: none is in contact
    std::uint8_t touched = 0; ///< places touched in this trial, one bit each
    std::uint8_t paused = 0;
    bool full = false;             ///< force is fully armed
    bool measures = false;         ///< `measured_N` is valid
    bool saturated = false;        ///< according to the device itself, or at the supervisor's cap
    std::uint16_t candidate = 0;   ///< from 1
    std::uint16_t arrangement = 0; ///< from 1
    std::uint16_t answer = 0;      ///< from 1
    double displacement_m = 0.0;
    double depth_m = 0.0;
    std::array<double, 3> velocity_m_per_s{};
    std::array<double, 3> commanded_N{};
    std::array<double, 3> measured_N{};
    std::array<double, 3> tissue_N{}; ///< response of the scene, rendered or not
};
static_assert(std::is_trivially_copyable_v<FidelitySample>);

/// The sample of a frame of a comparison session. Pure function.
/// Thread: any, including haptic.
FidelitySample fidelitySampleOf(const core::HapticFrame& frame) noexcept;

} // namespace chiron::session
