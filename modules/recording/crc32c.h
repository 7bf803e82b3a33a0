// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace chiron::recording {

/// CRC-32C (Castagnoli, polynomial 0x1EDC6F41 reflected; RFC 3720 B.4): "123456789" gives 0xE3069283.
std::uint32_t crc32c(std::span<const std::uint8_t> bytes) noexcept;

/// Copies `words` 8-byte words and returns a checksum of them and of `number`. It uses four interleaved
/// CRC-32C lanes (word i goes to lane i mod 4, which hides the instruction's latency of three cycles; lane 0
/// starts from the CRC of the number, lane k from k). At the end the CRC folds lanes 1..3 into lane 0. No
/// system call, no allocation.
using CopyWithChecksum = std::uint32_t (*)(std::uint64_t number, void* to, const void* from,
                                           std::size_t words) noexcept;

/// Returns the variant with the SSE 4.2 instruction if the processor has it, otherwise the one with the
/// portable table; both give the same value.
CopyWithChecksum copyWithChecksum() noexcept;
std::uint32_t copyWithChecksumPortable(std::uint64_t number, void* to, const void* from,
                                       std::size_t words) noexcept;

} // namespace chiron::recording
