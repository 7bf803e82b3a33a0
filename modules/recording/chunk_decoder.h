// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/channel_table.h"
#include "recording/column_decoder.h"
#include "recording/frame_fields.h"
#include "recording/trial_sink.h"

#include <memory>
#include <span>
#include <vector>

namespace chiron::recording {

/// Decodes a chunk into frames or single columns. Every length is checked: any bytes give a value or an
/// Error, never a crash or an allocation beyond the limits. Digests are checked by the reader, not here.
/// Thread: one at a time.
/// Errors: badInput naming the chunk, the byte offset in its payload, what was found and what was expected.
class ChunkDecoder {
public:
    explicit ChunkDecoder(ChannelTable table);
    ChunkDecoder(const ChunkDecoder&) = delete;
    ChunkDecoder& operator=(const ChunkDecoder&) = delete;
    ChunkDecoder(ChunkDecoder&&) noexcept;
    ChunkDecoder& operator=(ChunkDecoder&&) noexcept;
    ~ChunkDecoder();

    const ChannelTable& table() const noexcept { return m_table; }
    /// Appends all frames of the chunk; fields without a channel are zero.
    core::Result<void> decode(const Chunk& chunk, std::vector<core::HapticFrame>& frames);
    /// Returns the frame with this executed tick.
    /// Errors: notFound.
    core::Result<core::HapticFrame> decodeTick(const Chunk& chunk, std::uint64_t tick);
    /// Appends the counts of one channel (index in the table) without decoding the rest.
    core::Result<void> decodeChannel(const Chunk& chunk, std::size_t channel,
                                     std::vector<std::int64_t>& counts);

private:
    core::Result<void> openPayload(const Chunk& chunk);
    core::Result<void> decodeColumn(const Chunk& chunk, std::size_t channel, std::span<std::int64_t> values);
    bool refers(const Chunk& chunk, std::size_t channel) const noexcept;
    void addReference(std::size_t channel, std::span<const std::int64_t> reference,
                      std::span<std::int64_t> values) const;
    core::Result<void> decodeAll(const Chunk& chunk);
    core::Result<void> misfit(const Chunk& chunk, std::size_t channel, std::size_t row) const;
    core::Result<void> fill(const Chunk& chunk, std::size_t row, core::HapticFrame& frame) const;

    ChannelTable m_table;
    std::vector<FrameField> m_fields;
    std::vector<std::size_t> m_offsets; ///< start of each column in the payload; one more entry than channels
    std::vector<std::int64_t> m_values; ///< channels × frames
    std::size_t m_tickChannel = 0;      ///< or the number of channels, if the table has no tick channel
    std::vector<std::int64_t> m_reference;
    std::unique_ptr<ColumnDecoder> m_decoder;
};

} // namespace chiron::recording
