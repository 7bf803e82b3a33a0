// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "haptics/loop_statistics.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace chiron::session {

/// Histogram of the lateness of ticks in a few readable bins: one up to each edge, and one beyond the last.
struct LatenessBins {
    static constexpr std::array<std::int64_t, 10> kEdges_us{2, 5, 10, 20, 50, 100, 200, 500, 1000, 5000};
    std::array<std::uint64_t, kEdges_us.size() + 1> counts{};
    bool operator==(const LatenessBins&) const = default;
};

/// The histogram's counts in these bins. Each bucket of the histogram counts at its upper end.
LatenessBins latenessBinsOf(const haptics::LatencyHistogram& lateness) noexcept;

/// The punctuality of the loop. The optional values are empty for ticks that ran back to back.
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
    /// The energy that the passivity controller withheld from people (PassivityController::kept_J()); empty
    /// in sessions that were stored before it existed.
    std::optional<double> passivity_J;
    std::optional<LatenessBins> lateness; ///< empty also in sessions that were stored before it existed
    /// The same as `passivity_J` without what people were spared (PassivityController::withheld_J()); empty
    /// in sessions that were stored before it existed.
    std::optional<double> passivityWithheld_J;
};

/// Fills in the punctuality of a run on a clock from its statistics.
void setPunctuality(LoopReport& report, const haptics::LoopStatistics& statistics);

/// The report in the form in which a session stores it, and its reader.
/// Errors: badInput when reading: not a JSON object.
std::string loopJson(const LoopReport& report);
core::Result<LoopReport> loopReportFrom(const std::string& json);

} // namespace chiron::session
