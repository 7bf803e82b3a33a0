// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace chiron::recording {

/// How the numbers of one column are written; part of the format. Arithmetic is modulo 2^64, so every int64 survives.
enum class ColumnMode : std::uint8_t {
    zero = 0,             ///< nothing follows
    constant = 1,         ///< zig-zag varint value
    line = 2,             ///< zig-zag varints first, step
    offset = 3,           ///< zig-zag varint minimum, packed value − minimum
    difference = 4,       ///< zig-zag varint first, packed zig-zag differences
    secondDifference = 5, ///< zig-zag varints first, first difference, packed zig-zag second differences
    zstd = 16,            ///< varint length of the plain column, zstd frame of it (mode byte included)
};

/// Writes columns. `compressible` remembers from call to call whether zstd is worth trying for a channel.
class ColumnEncoder {
public:
    ColumnEncoder();
    ColumnEncoder(const ColumnEncoder&) = delete;
    ColumnEncoder& operator=(const ColumnEncoder&) = delete;
    ~ColumnEncoder();

    /// Appends the values in the smallest of the plain modes.
    static void encodePlain(std::span<const std::int64_t> values, std::vector<std::uint8_t>& out);
    /// As encodePlain, then zstd if that is smaller (tried only if `tryZstd`). True if zstd was smaller.
    bool encode(std::span<const std::int64_t> values, bool tryZstd, std::vector<std::uint8_t>& out);

private:
    struct Contexts;
    std::unique_ptr<Contexts> m_contexts;
    std::vector<std::uint8_t> m_plain;
    std::vector<std::uint8_t> m_packed;
};

/// Reads columns written by ColumnEncoder; any bytes give values or an Error that names offset and expectation.
class ColumnDecoder {
public:
    ColumnDecoder();
    ColumnDecoder(const ColumnDecoder&) = delete;
    ColumnDecoder& operator=(const ColumnDecoder&) = delete;
    ~ColumnDecoder();

    /// Fills `values`; the column must be exactly as long as `bytes`. Offsets in messages start at `offset`.
    core::Result<void> decode(std::span<const std::uint8_t> bytes, std::size_t offset, std::span<std::int64_t> values);

private:
    struct Contexts;
    std::unique_ptr<Contexts> m_contexts;
    std::vector<std::uint8_t> m_plain;
};

} // namespace chiron::recording
