// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/channel_table.h"
#include "recording/chunk_format.h"
#include "recording/column_encoder.h"
#include "recording/frame_fields.h"
#include "recording/trial_sink.h"

#include <memory>
#include <span>
#include <vector>

namespace chiron::recording {

/// Encodes HapticFrames into a Chunk with one column per channel. Each column is stored as constant, line,
/// offset, difference or second difference, bit-packed, then with zstd if that is smaller (zstd is tried in
/// every 32nd chunk, and in a channel's following chunks as long as it helps). Payload: version byte, varint
/// frames, varint channels, varint length of each column, columns. Not copyable, because it owns a
/// compression context; may allocate.
/// Thread: one at a time.
class ChunkEncoder {
public:
    explicit ChunkEncoder(ChannelTable table);
    ChunkEncoder(const ChunkEncoder&) = delete;
    ChunkEncoder& operator=(const ChunkEncoder&) = delete;
    ChunkEncoder(ChunkEncoder&&) noexcept;
    ChunkEncoder& operator=(ChunkEncoder&&) noexcept;
    ~ChunkEncoder();

    const ChannelTable& table() const noexcept { return m_table; }
    /// Encodes one chunk.
    /// Errors: wrongUse if there are no frames or too many, or if a frame has another number of tools than
    /// the table.
    core::Result<Chunk> encode(std::uint32_t sequence, std::span<const core::HapticFrame> frames);

private:
    void gatherAll(std::span<const core::HapticFrame> frames);
    bool changes(std::size_t channel) const noexcept;
    std::span<const std::int64_t> countsOf(std::size_t channel, std::size_t frames) const noexcept;
    std::span<const std::int64_t> residualOf(std::size_t channel, std::size_t frames);

    ChannelTable m_table;
    std::vector<FrameField> m_fields;
    std::vector<std::int64_t> m_counts;   ///< channels × frames
    std::vector<std::uint64_t> m_changes; ///< per word of the frame: bits that differ somewhere in the chunk
    std::vector<std::int64_t> m_residual;
    std::vector<std::uint8_t> m_columns; ///< encoded columns
    std::vector<bool> m_zstdHelps;       ///< per channel: zstd was smaller when last tried
    std::unique_ptr<ColumnEncoder> m_encoder;
};

} // namespace chiron::recording
