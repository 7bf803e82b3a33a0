// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace chiron::recording {

/// Coding of the numbers in one column; part of the format. Arithmetic is modulo 2^64, so that every int64 is
/// preserved.
enum class ColumnMode : std::uint8_t {
    zero = 0,             ///< nothing follows
    constant = 1,         ///< zig-zag varint value
    line = 2,             ///< zig-zag varints first, step
    offset = 3,           ///< zig-zag varint base, packed zig-zag value − base (bit_packing.h)
    difference = 4,       ///< zig-zag varint first, packed zig-zag differences
    secondDifference = 5, ///< zig-zag varints first, first difference, packed zig-zag second differences
    zstd = 16,            ///< varint length of the plain column, zstd frame of it (mode byte included)
};

/// Flag in the first byte of a column that holds value − factor · reference; without it the column holds the
/// value itself. A channel that stays constant while its reference moves is shorter without it.
inline constexpr std::uint8_t kReferred = 0x20;

/// Returns the largest plain size of a column with that many values: the most that a reader allocates for
/// one.
constexpr std::size_t maximumPlainBytes(std::size_t values) {
    return 32 + values * 8 + values / 32 + 1;
}

} // namespace chiron::recording
