// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::scoring {

/// What metrics of an insertion measure sample by sample, and so what can be looked at where it was worst.
enum class InsertionQuantity : std::uint8_t {
    offset,        ///< m, in the urethra: offset_rms, offset_max
    alignment,     ///< rad, in the urethra: alignment_rms
    bendAlignment, ///< rad, at the bend during the insertion: bend_alignment
    curveAlignment, ///< rad, from the bend to 30 mm past it during the insertion: curve_alignment
    torque,        ///< N·m, everywhere: torque_max, torque_rms
};

/// All of them, in this order.
std::span<const InsertionQuantity> insertionQuantities() noexcept;
/// The metrics that measure a quantity.
std::span<const std::string_view> metricsOf(InsertionQuantity quantity) noexcept;
/// Nothing for a metric of another kind.
std::optional<InsertionQuantity> insertionQuantityOf(std::string_view metric) noexcept;
/// A value in the unit that the quantity's metrics have (mm, °, mN·m), by the very product that they use.
double inMetricUnit(InsertionQuantity quantity, double value) noexcept;
const char* metricUnitOf(InsertionQuantity quantity) noexcept;

/// The sample with the largest value among those that the quantity's metrics take (no pause), the first of equal ones:
/// begin_s = end_s. Nothing where there is none. `trial` must be on the stored grids (trace_grid.h), here and below. Pure.
std::optional<InsertionEvent> largestOf(const TrialTrace& trial, InsertionQuantity quantity);
/// The stretches over `limit` (in the metrics' unit; equal holds, as a gate's end does), in the order of time: from the first
/// sample over it to the next one that is not, is left out, or to the trial's end; value: the largest.
std::vector<InsertionEvent> stretchesOver(const TrialTrace& trial, InsertionQuantity quantity, double limit);

} // namespace chiron::scoring
