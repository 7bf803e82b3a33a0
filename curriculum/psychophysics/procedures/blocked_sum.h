// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

/// Sums in one fixed order: eight running sums, of every eighth number, then added as a tree. How many of the eight a processor takes at
/// once changes no bit (no fused multiply-add either). Lengths are multiples of kLanes; pad with zeros.
inline constexpr std::size_t kLanes = 8;
/// Numbers that are skipped, or not, together.
inline constexpr std::size_t kBlock = 32;

constexpr std::size_t padded(std::size_t count) noexcept { return (count + kBlock - 1) / kBlock * kBlock; }

/// The blocks of kBlock numbers that are worth summing.
using ActiveBlocks = std::vector<std::uint32_t>;

double blockedSum(const double* a, std::size_t count) noexcept;
double blockedDot(const double* a, const double* b, std::size_t count) noexcept;
/// Only over the active blocks; the others count as zeros.
double blockedDot(const double* a, const double* b, const ActiveBlocks& blocks) noexcept;
/// In single precision within a block, double across: relative error below kRoughError where no term is negative (or none positive).
double roughDot(const float* a, const float* b, const ActiveBlocks& blocks) noexcept;
inline constexpr double kRoughError = 16.0 / (1 << 24); ///< rounding of a, b, their product and three sums, twice over
/// b is the sum of two floats (48 bits).
double blockedDot(const double* a, const float* high, const float* low, const ActiveBlocks& blocks) noexcept;

} // namespace chiron::psychophysics
