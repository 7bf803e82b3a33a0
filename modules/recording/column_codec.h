// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace chiron::recording {

/// How the numbers of one column are written; part of the format. Arithmetic is modulo 2^64, so every int64
/// survives.
enum class ColumnMode : std::uint8_t {
    zero = 0,             ///< nothing follows
    constant = 1,         ///< zig-zag varint value
    line = 2,             ///< zig-zag varints first, step
    offset = 3,           ///< zig-zag varint base, packed zig-zag value − base (bit_packing.h)
    difference = 4,       ///< zig-zag varint first, packed zig-zag differences
    secondDifference = 5, ///< zig-zag varints first, first difference, packed zig-zag second differences
    zstd = 16,            ///< varint length of the plain column, zstd frame of it (mode byte included)
};

/// Added to the first byte of a column that holds value − factor · reference; without it the column holds the
/// value. A channel that stays the same while its reference moves is shorter by itself.
inline constexpr std::uint8_t kReferred = 0x20;

/// Largest plain column of that many values: what a reader ever allocates for one.
constexpr std::size_t maximumPlainBytes(std::size_t values) {
    return 32 + values * 8 + values / 32 + 1;
}

} // namespace chiron::recording
