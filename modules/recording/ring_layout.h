// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace chiron::recording {

using DatabaseId = std::array<std::uint8_t, 16>; ///< UUID of the database, bytes in the printed order

inline constexpr std::uint64_t kRingMagic = 0x31474e4952484321ULL; ///< "!CHRING1" little-endian
inline constexpr std::uint32_t kRingVersion = 1;
inline constexpr std::size_t kCacheLine = 64;
inline constexpr std::uint32_t kMinimumSlots = 4096; ///< 4 s at 1 kHz
inline constexpr std::uint32_t kMaximumSlots = 65536;
inline constexpr const char* kRingSuffix = ".ring";
inline constexpr const char* kUnfinishedRingSuffix = ".ring.part";

/// First page of a ring file. Its first part is written once; each of the other two cache lines has one
/// writer.
struct RingHeader {
    std::uint64_t magic = kRingMagic;
    std::uint32_t version = kRingVersion;
    std::uint32_t frameLayout = core::kFrameLayoutVersion;
    std::uint32_t tools = 0;
    std::uint32_t capacity = 0;
    std::uint32_t slotBytes = 0;
    std::uint32_t checksum = 0; ///< identityChecksum()
    DatabaseId database{};
    std::int64_t session = 0;
    std::int64_t pid = 0;
    std::array<char, 40> bootId{};
    alignas(kCacheLine) std::uint64_t committed = 0; ///< written by the drain (atomic)
    alignas(kCacheLine) std::uint64_t dropped = 0;   ///< written by the haptic thread (atomic)
};

/// Start of each slot; the frame's used bytes follow. `number` is written last: n + 1 for the ring's n-th
/// frame.
struct SlotHeader {
    std::uint64_t number = 0;
    std::uint32_t checksum = 0; ///< copyWithChecksum() over number and used bytes
    std::uint32_t reserved = 0;
};

inline constexpr std::size_t kRingHeaderBytes = 4096;
static_assert(sizeof(RingHeader) <= kRingHeaderBytes);

/// Returns the number of used bytes of a frame: everything up to its last used tool.
constexpr std::size_t usedFrameBytes(std::uint32_t tools) noexcept {
    return offsetof(core::HapticFrame, tool) + tools * sizeof(core::ToolFrame);
}
static_assert(usedFrameBytes(1) % 8 == 0 && usedFrameBytes(core::kMaxTools) == sizeof(core::HapticFrame));

constexpr std::size_t slotBytesFor(std::uint32_t tools) noexcept {
    return (sizeof(SlotHeader) + usedFrameBytes(tools) + kCacheLine - 1) / kCacheLine * kCacheLine;
}

/// CRC-32C over the identity of a header (its first part, up to `committed`) with the checksum field zero.
std::uint32_t identityChecksum(const RingHeader& header) noexcept;
/// Returns "chiron-<uuid in hex>-", with which the names of a database's ring files begin.
std::string ringFilePrefix(const DatabaseId& database);
/// Returns the id of the present boot as the kernel reports it; empty if there is none.
std::string bootId();

} // namespace chiron::recording
