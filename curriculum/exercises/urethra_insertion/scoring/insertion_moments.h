// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::scoring {

/// Quantities that the metrics of an insertion measure sample by sample, so that a viewer can go to the
/// moment where a quantity was worst.
enum class InsertionQuantity : std::uint8_t {
    offset,         ///< m, in the urethra: offset_rms, offset_max
    alignment,      ///< rad, in the urethra: alignment_rms
    bendAlignment,  ///< rad, at the bend during the insertion: bend_alignment
    curveAlignment, ///< rad, from the bend to 30 mm past it during the insertion: curve_alignment
    torque,         ///< N·m, everywhere: torque_max, torque_rms
};

/// Returns all of them, in the order of the enumeration.
std::span<const InsertionQuantity> insertionQuantities() noexcept;
/// Returns the metrics that measure a quantity.
std::span<const std::string_view> metricsOf(InsertionQuantity quantity) noexcept;
/// Returns none for a metric that measures no such quantity.
std::optional<InsertionQuantity> insertionQuantityOf(std::string_view metric) noexcept;
/// Converts a value to the unit of the quantity's metrics (mm, °, mN·m), with the same multiplication that
/// they use.
double inMetricUnit(InsertionQuantity quantity, double value) noexcept;
const char* metricUnitOf(InsertionQuantity quantity) noexcept;

/// Returns the sample with the largest value among the samples that the quantity's metrics use (no paused
/// ones), with begin_s = end_s; the first of equal values. Returns none if there is no such sample. `trial`
/// must be on the stored grids (trace_grid.h), here and below. The function is pure.
std::optional<InsertionEvent> largestOf(const TrialTrace& trial, InsertionQuantity quantity);
/// Returns the stretches over `limit`, in the order of time. The limit is in the metrics' unit, and a value
/// equal to it is not over it, as with the end of a gate. A stretch lasts from the first sample over the
/// limit to the next sample that is not over it or is left out, or to the trial's end. Its value is the
/// largest one.
std::vector<InsertionEvent> stretchesOver(const TrialTrace& trial, InsertionQuantity quantity, double limit);

} // namespace chiron::scoring
