// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

/// Sums in one fixed order: eight running sums, each of every eighth number, which are then added as a tree.
/// The number of lanes that a processor handles at once changes no bit of the result (and there is no fused
/// multiply-add). Lengths are multiples of kLanes; pad with zeros.
inline constexpr std::size_t kLanes = 8;
/// Granularity with which numbers are skipped.
inline constexpr std::size_t kBlock = 32;

constexpr std::size_t padded(std::size_t count) noexcept {
    return (count + kBlock - 1) / kBlock * kBlock;
}

/// Indices of the blocks of kBlock numbers that are worth summing.
using ActiveBlocks = std::vector<std::uint32_t>;

double blockedSum(const double* a, std::size_t count) noexcept;
double blockedDot(const double* a, const double* b, std::size_t count) noexcept;
/// Sums only over the active blocks; the others count as zeros.
double blockedDot(const double* a, const double* b, const ActiveBlocks& blocks) noexcept;
/// Sums in single precision within a block and in double precision across blocks. The relative error is below
/// kRoughError if no term is negative (or none is positive).
double roughDot(const float* a, const float* b, const ActiveBlocks& blocks) noexcept;
/// Rounding of a, b, their product and three sums, doubled for safety.
inline constexpr double kRoughError = 16.0 / (1 << 24);
/// b is the sum of two floats (48 bits).
double blockedDot(const double* a, const float* high, const float* low, const ActiveBlocks& blocks) noexcept;

} // namespace chiron::psychophysics
