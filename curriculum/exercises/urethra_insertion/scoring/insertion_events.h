// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/critical_error_catalogue.h"
#include "scoring/trace.h"

#include <vector>

namespace chiron::scoring {

/// An undesired event with a duration.
struct InsertionEvent {
    double begin_s = 0.0; ///< device time, as in the trace
    double end_s = 0.0;
    double value = 0.0; ///< trauma: largest lateral force, N; reversal: distance travelled back, m
};

/// A wall that is pressed this hard or this long is torn and not merely touched. This is a critical error
/// (metric critical_errors, from version 2 on; playback marks it as one). 4 N is the cap of the site
/// (models.md §5); 1 s is an assumption.
inline constexpr double kLongTrauma_s = 1.0;
inline constexpr double kHardTrauma_N = 4.0;
inline bool isCritical(const InsertionEvent& trauma) noexcept {
    return trauma.end_s - trauma.begin_s > kLongTrauma_s || trauma.value > kHardTrauma_N;
}

/// Both lists are in the order of time.
struct InsertionEvents {
    std::vector<InsertionEvent> trauma;
    std::vector<InsertionEvent> reversals;
};

/// Finds the trauma events and reversals of a trial (models.md §6, "insertion"). The counts of both metrics
/// and the marks of playback use this one list. Version 1 of both metrics.
///
/// Trauma: the lateral force is over the trial's limit without interruption for 20 ms or longer; the force of
/// a sample holds until the next one. The event lasts, and no other begins, until the force is below 80 % of
/// the limit.
/// Reversal: in the stage "insertion" the tip goes back by 1 mm or more from the farthest position reached
/// (this hysteresis excludes tremor). The reversal begins at that position. It ends at the least depth, from
/// which the tip advances by 1 mm again, or which is the least one until the stage ends.
/// Pauses are left out: a pause ends the current event and counts for no time. Afterwards the force must
/// first fall below 80 % of the limit before a new trauma can begin, and the distance back is measured anew.
///
/// `trial` must be on the stored grids (trace_grid.h). The result is empty without an insertion series. The
/// function is pure.
InsertionEvents insertionEvents(const TrialTrace& trial);

/// Returns the trauma events that are critical errors (isCritical), in the order of time. `trial` must be as
/// for insertionEvents().
std::vector<CriticalSpan> criticalTrauma(const TrialTrace& trial);

} // namespace chiron::scoring
