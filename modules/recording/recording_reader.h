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

/// Reads a stored recording. Inputs are returned unchanged, wrenches at the stored resolution. A chunk's
/// digest is checked when the chunk is first used; a damaged chunk gives an Error (doesNotHold) that names
/// it. The source must outlive the reader. Move-only.
/// Thread: one at a time; blocks on the source.
class RecordingReader {
public:
    /// Reads only the table, so that opening takes the same time for any length.
    /// Errors: badInput (table); those of the source.
    static core::Result<RecordingReader> open(ChunkSource& source);

    const ChannelTable& table() const noexcept { return m_decoder.table(); }
    int tools() const noexcept { return table().tools(); }
    std::size_t chunkCount() const noexcept { return m_checked.size(); }
    /// Counts the frames of all chunks without decoding them.
    core::Result<std::uint64_t> frameCount();

    /// Returns the frames of one chunk, in order. This allows iteration without holding a whole session in
    /// memory.
    core::Result<std::vector<core::HapticFrame>> framesOf(std::size_t sequence);
    core::Result<std::vector<core::HapticFrame>> allFrames();
    /// Random access by executed tick. The chunk is guessed from the length of its neighbours, then searched;
    /// only the one that holds the tick is decoded.
    /// Errors: notFound.
    core::Result<core::HapticFrame> frameAtTick(std::uint64_t tick);

    /// Returns one channel over the whole recording, as counts, without decoding the others.
    /// Errors: notFound if the table has no such channel.
    core::Result<std::vector<std::int64_t>> channelCounts(std::uint8_t tool, std::string_view id);
    /// The same in the channel's unit: counts × resolution; quantised channels as by dequantise().
    core::Result<std::vector<double>> channelValues(std::uint8_t tool, std::string_view id);

    /// Returns the hash of a chunk's unrounded forces as recorded, which a replay compares (forceHashOf).
    core::Result<Digest> forceHash(std::size_t sequence);
    /// Checks the digest and the decoding of every chunk, and that ticks rise.
    /// Errors: the first check that fails.
    core::Result<void> verify();

private:
    RecordingReader(ChunkSource& source, ChannelTable table);
    core::Result<Chunk> checkedChunk(std::size_t sequence);
    core::Result<std::uint64_t> lastTickOf(const Chunk& chunk);

    ChunkSource* m_source;
    ChunkDecoder m_decoder;
    std::vector<bool> m_checked; ///< per chunk: its digest was found correct
};

} // namespace chiron::recording
