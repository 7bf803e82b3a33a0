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

/// HapticFrames -> Chunk: one column a channel, each as constant, line, offset, difference or second
/// difference, bit-packed, then zstd if smaller (probed every 32nd chunk, and tried on while it helps a
/// channel). Payload: version byte, varint frames, varint channels, varint length of each column, columns.
/// Not copied (owns a compression context); one thread at a time; may allocate.
class ChunkEncoder {
public:
    explicit ChunkEncoder(ChannelTable table);
    ChunkEncoder(const ChunkEncoder&) = delete;
    ChunkEncoder& operator=(const ChunkEncoder&) = delete;
    ChunkEncoder(ChunkEncoder&&) noexcept;
    ChunkEncoder& operator=(ChunkEncoder&&) noexcept;
    ~ChunkEncoder();

    const ChannelTable& table() const noexcept { return m_table; }
    /// Error: wrongUse if there are no frames, too many, or a frame has another number of tools than the
    /// table.
    core::Result<Chunk> encode(std::uint32_t sequence, std::span<const core::HapticFrame> frames);

private:
    void gatherAll(std::span<const core::HapticFrame> frames);
    bool changes(std::size_t channel) const noexcept;
    std::span<const std::int64_t> countsOf(std::size_t channel, std::size_t frames) const noexcept;
    std::span<const std::int64_t> residualOf(std::size_t channel, std::size_t frames);

    ChannelTable m_table;
    std::vector<FrameField> m_fields;
    std::vector<std::int64_t> m_counts;   ///< channels × frames
    std::vector<std::uint64_t> m_changes; ///< a word of the frame: bits that differ somewhere in the chunk
    std::vector<std::int64_t> m_residual;
    std::vector<std::uint8_t> m_columns; ///< encoded
    std::vector<bool> m_zstdHelps;       ///< a channel: zstd was smaller when last tried
    std::unique_ptr<ColumnEncoder> m_encoder;
};

} // namespace chiron::recording
