// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::recording {

/// Values are packed in blocks of 32: a byte with the block's width (0..64 bits), then its values, low bits
/// first, with the last byte filled with zeros. The blocks are short enough that one late tick or contact
/// widens only 32 ms.
inline constexpr std::size_t kBlockValues = 32;

/// Returns the number of bytes that packing would take.
std::size_t packedSize(std::span<const std::uint64_t> values) noexcept;
void packBlocks(std::span<const std::uint64_t> values, std::vector<std::uint8_t>& out);

/// Result of unpacking: how many bytes were used. `flawAt` is the position of an invalid byte, or npos.
struct Unpacked {
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);
    std::size_t used = 0;
    std::size_t flawAt = npos;
};

/// Reads values.size() values from bytes; never reads past the end of `bytes`.
Unpacked unpackBlocks(std::span<const std::uint8_t> bytes, std::span<std::uint64_t> values) noexcept;

} // namespace chiron::recording
