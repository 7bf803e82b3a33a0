// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/position_of.h"
#include "recording/trial_sink.h"

#include <array>
#include <cstdint>
#include <vector>

namespace chiron::recording {

/// Adds up frames to one SecondSummary per second and tool. t is the device time since the tool's first
/// frame. A frame belongs to second floor(t), but never to an earlier one than the frame before (so a device
/// clock that is set back does not reorder frames). The force is the rounded tissue force (roundedWrench), so
/// that live and later sums are the same doubles. Between consecutive unpaused frames k−1, k: path += ‖p_k −
/// p_{k−1}‖, impulse += ½(F_{k−1} + F_k) Δt, time over limit += Δt if F_k > limit; all are credited to the
/// second of k. Paused frames count only in `events`; non-finite forces are left out of maximum, mean and
/// impulse. Copyable.
class SecondSummaries {
public:
    SecondSummaries(const IPositionOf& positionOf, double forceLimit_N) noexcept;

    /// Takes the next frame; appends the summaries that it completes to `done`.
    void add(const core::HapticFrame& frame, std::vector<SecondSummary>& done);
    /// Appends the unfinished seconds, if any, at the end of a recording.
    void finish(std::vector<SecondSummary>& done);

private:
    struct Tool {
        bool started = false; ///< device time zero is known
        bool open = false;    ///< `sum` holds frames
        bool hasLast = false; ///< the last frame was not paused
        std::uint64_t zero_us = 0;
        std::uint64_t last_us = 0;
        double lastForce_N = 0.0;
        double forceSum_N = 0.0;
        std::uint32_t forces = 0;
        core::Vec3 p_WT = core::Vec3::Zero();
        SecondSummary sum;
    };
    void addTool(int tool, const core::HapticFrame& frame, std::vector<SecondSummary>& done);
    void addMoving(Tool& state, const core::ToolFrame& frame, const core::Vec3& p_WT) const noexcept;
    static void close(Tool& state, std::vector<SecondSummary>& done);

    const IPositionOf* m_positionOf;
    double m_forceLimit_N;
    std::array<Tool, core::kMaxTools> m_tools{};
};

} // namespace chiron::recording
