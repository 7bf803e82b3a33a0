// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/critical_error_catalogue.h"
#include "scoring/trace.h"

#include <vector>

namespace chiron::scoring {

/// Something that went wrong for a while.
struct InsertionEvent {
    double begin_s = 0.0; ///< device time, as the trace's
    double end_s = 0.0;
    double value = 0.0; ///< trauma: largest lateral force, N; reversal: how far back, m
};

/// A wall that is pressed that hard or that long is torn, not touched: a critical error (metric critical_errors, from version 2 on; playback marks
/// it as one). 4 N is the cap of the site (models.md §5); 1 s an assumption.
inline constexpr double kLongTrauma_s = 1.0;
inline constexpr double kHardTrauma_N = 4.0;
inline bool isCritical(const InsertionEvent& trauma) noexcept {
    return trauma.end_s - trauma.begin_s > kLongTrauma_s || trauma.value > kHardTrauma_N;
}

/// Both in the order of time.
struct InsertionEvents {
    std::vector<InsertionEvent> trauma;
    std::vector<InsertionEvent> reversals;
};

/// What the counts of trauma events and reversals count, and what playback marks: one list for both
/// (models.md §6, "insertion"). Version 1 of both metrics.
///
/// Trauma: the lateral force is over the trial's limit, without a break, for 20 ms or longer; a sample's force
/// holds until the next one. It goes on, and no other begins, until the force is below 80 % of the limit.
/// Reversal: in the stage "insertion" the tip goes back by 1 mm or more from the farthest place reached (the
/// hysteresis: less is tremor); from there it begins, and it ends at the place where the tip turned forward
/// again by 1 mm, or at the stage's last place if it never did.
/// Pauses are left out: one ends what goes on, counts for no time, and afterwards trauma must first fall below
/// 80 % to begin again and the way back is measured anew.
///
/// `trial` must be on the stored grids (trace_grid.h). Empty without an insertion series. Pure.
InsertionEvents insertionEvents(const TrialTrace& trial);

/// The trauma events that are critical errors (isCritical), in the order of time. `trial`: as for insertionEvents().
std::vector<CriticalSpan> criticalTrauma(const TrialTrace& trial);

} // namespace chiron::scoring
