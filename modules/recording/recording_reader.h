// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/result.h"
#include "recording/channel_table.h"
#include "recording/chunk_decoder.h"
#include "recording/trial_sink.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace chiron::recording {

/// Reads a stored recording. Inputs come back as they were, wrenches at the stored resolution. A chunk's
/// digest is checked when it is first touched: a damaged chunk is an Error (doesNotHold) that names it. The
/// source must outlive the reader. Move-only, one thread at a time, blocks on the source.
class RecordingReader {
public:
    /// Reads the table only, so that opening costs the same for any length. Errors: badInput (table), the
    /// source's own.
    static core::Result<RecordingReader> open(ChunkSource& source);

    const ChannelTable& table() const noexcept { return m_decoder.table(); }
    int tools() const noexcept { return table().tools(); }
    std::size_t chunkCount() const noexcept { return m_checked.size(); }
    /// Walks all chunks without decoding them.
    core::Result<std::uint64_t> frameCount();

    /// Frames of one chunk, in order: the way to iterate without holding a whole session.
    core::Result<std::vector<core::HapticFrame>> framesOf(std::size_t sequence);
    core::Result<std::vector<core::HapticFrame>> allFrames();
    /// Random access by executed tick: the chunk is guessed from the length of its neighbours, then searched;
    /// only the one that holds the tick is decoded. Error: notFound.
    core::Result<core::HapticFrame> frameAtTick(std::uint64_t tick);

    /// One channel over the whole recording without the rest, as counts. Error: notFound if the table has
    /// none such.
    core::Result<std::vector<std::int64_t>> channelCounts(std::uint8_t tool, std::string_view id);
    /// The same in the channel's unit: counts × resolution, quantised channels as dequantise().
    core::Result<std::vector<double>> channelValues(std::uint8_t tool, std::string_view id);

    /// Hash of the unrounded forces of a chunk as recorded: what a replay compares (forceHashOf).
    core::Result<Digest> forceHash(std::size_t sequence);
    /// Checks the digest and the decoding of every chunk, and that ticks rise. Error: the first that does not
    /// hold.
    core::Result<void> verify();

private:
    RecordingReader(ChunkSource& source, ChannelTable table);
    core::Result<Chunk> checkedChunk(std::size_t sequence);
    core::Result<std::uint64_t> lastTickOf(const Chunk& chunk);

    ChunkSource* m_source;
    ChunkDecoder m_decoder;
    std::vector<bool> m_checked; ///< a chunk: its digest was found right
    std::vector<std::int64_t> m_ticks;
};

} // namespace chiron::recording
