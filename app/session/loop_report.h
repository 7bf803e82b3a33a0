// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "haptics/loop_statistics.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace chiron::session {

/// How late the ticks of a run started, in bins that a person can read: up to each edge, and beyond the last.
struct LatenessBins {
    static constexpr std::array<std::int64_t, 10> kEdges_us{2, 5, 10, 20, 50, 100, 200, 500, 1000, 5000};
    std::array<std::uint64_t, kEdges_us.size() + 1> counts{};
    bool operator==(const LatenessBins&) const = default;
};

/// The histogram's counts in these bins. A bucket of the histogram counts where it ends.
LatenessBins latenessBinsOf(const haptics::LatencyHistogram& lateness) noexcept;

/// The loop's punctuality; absent numbers where ticks ran back to back.
struct LoopReport {
    std::uint64_t ticks = 0;
    std::uint64_t late = 0;
    std::uint64_t skipped = 0;
    std::optional<double> p50_us;
    std::optional<double> p99_us;
    std::optional<double> max_us;
    bool realtime = false;
    bool priorityGranted = false;
    std::string priorityDetail;
    std::optional<double> passivity_J;    ///< what the passivity controller kept from people (PassivityController::kept_J()); absent in sessions stored before
    std::optional<LatenessBins> lateness; ///< absent also in sessions stored before it was kept
};

/// Fills the punctuality of a run on a clock from its statistics.
void setPunctuality(LoopReport& report, const haptics::LoopStatistics& statistics);

/// As a session stores it, and back. Failure of reading (badInput): not a JSON object.
std::string loopJson(const LoopReport& report);
core::Result<LoopReport> loopReportFrom(const std::string& json);

} // namespace chiron::session
