// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session_state.h"
#include "haptics/display_state.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::session {

/// One tick of tool 0 for a live plot, in single precision, which is sufficient for a screen.
/// Unit: SI.
/// Frame: W.
struct LiveSample {
    std::uint64_t tick = 0;
    double t_s = 0.0; ///< runner's clock since the first tick: a missed deadline appears as a gap
    std::array<float, 3> tissue_N{}; ///< response of the scene, on the tool
    float tissueNorm_N = 0.0f;
    float torque_Nm = 0.0f;   ///< norm of the tissue torque
    float commanded_N = 0.0f; ///< norm after the supervisor; 0 on an input-only device
    float speed_m_per_s = 0.0f;
    std::array<float, 3> p_WT_m{};
    std::array<float, 4> q_WT{1.0f, 0.0f, 0.0f, 0.0f}; ///< w, x, y, z
    float depth_m = 0.0f; ///< from the drawn surface point to the tip, 0 out of contact
    /// For each fingertip, its contact point (x, y, m) and the displayed normal force (N); 0 for tools that
    /// are no fingertip.
    std::array<std::array<float, 3>, core::kMaxTools> press{};
    std::uint32_t guards = 0; ///< core::guard_bits
    std::uint32_t events = 0; ///< core::event_bits
    bool yielded = false;     ///< tissue gave way to any of the tools at this tick
    core::TrialPhase phase = core::TrialPhase::idle;
    bool paused = false;
};

static_assert(std::is_trivially_copyable_v<LiveSample>);

/// The sample of one tick; `start_ns` is the now_ns of the session's first tick. Pure function.
/// Thread: haptic.
LiveSample liveSampleOf(const haptics::DisplayState& shown, std::int64_t start_ns) noexcept;

} // namespace chiron::session
