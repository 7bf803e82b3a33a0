// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/station/emulated_station.h"
#include "app/station/host_line.h"

#include <atomic>
#include <cstdint>
#include <string>

namespace chiron::station {

struct RunLimits {
    std::uint64_t ticks = 0;    ///< 0: no limit
    bool untilHostGone = false; ///< ends when the first host that commanded anything has gone
};

/// Runs a station by its own clock, one tick a millisecond: late ticks are made up at once, so that its clock
/// stays true. Ends with `stop`, or at a limit.
/// Errors: device, if the line cannot be plugged in again.
core::Result<void> runByClock(EmulatedStation& station, HostLine& line, const RunLimits& limits,
                              const std::atomic<bool>& stop);

/// Runs a station by its host: one tick for each output frame that comes, whatever becomes of it. After its
/// input frames it sends the frame that ends the step.
core::Result<void> runLockstep(EmulatedStation& station, HostLine& line, const RunLimits& limits,
                               const std::atomic<bool>& stop);

/// One line of JSON.
std::string totalsJson(const StationTotals& totals, std::size_t axes);

} // namespace chiron::station
