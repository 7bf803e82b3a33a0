// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace chiron::recording {

/// Payload of a chunk: version byte, varint frames, varint channels, varint length of each column, columns.
inline constexpr std::uint8_t kPayloadVersion = 1;
inline constexpr std::uint32_t kMaximumFramesPerChunk = 4096;
/// A reader refuses larger payloads; 4,096 frames of four tools with incompressible numbers stay below it.
inline constexpr std::size_t kMaximumPayloadBytes = 16 * 1024 * 1024;

} // namespace chiron::recording
