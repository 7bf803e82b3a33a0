// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::recording {

/// Values go in blocks of 32: a byte with the block's width (0..64 bits), then its values, low bits first,
/// the last byte filled with zeros. Short enough that one late tick or contact widens 32 ms only.
inline constexpr std::size_t kBlockValues = 32;

/// Bytes that packing would take.
std::size_t packedSize(std::span<const std::uint64_t> values) noexcept;
void packBlocks(std::span<const std::uint64_t> values, std::vector<std::uint8_t>& out);

/// Where unpacking stopped: `flawAt` is the byte that could not be, or npos.
struct Unpacked {
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);
    std::size_t used = 0;
    std::size_t flawAt = npos;
};

/// Reads values.size() values from bytes; never reads past them.
Unpacked unpackBlocks(std::span<const std::uint8_t> bytes, std::span<std::uint64_t> values) noexcept;

} // namespace chiron::recording
