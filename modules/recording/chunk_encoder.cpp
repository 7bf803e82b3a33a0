// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/chunk_encoder.h"

#include "recording/byte_cursor.h"
#include "recording/chunk_format.h"
#include "recording/digest.h"
#include "recording/ring_layout.h"

#include <algorithm>

namespace chiron::recording {

namespace {
constexpr std::uint32_t kProbeEvery =
    32; // chunks: zstd on packed numbers seldom helps, and costs more than all the rest
constexpr std::size_t kFramesAtOnce = 32;
} // namespace

ChunkEncoder::ChunkEncoder(ChannelTable table)
    : m_table(std::move(table)), m_zstdHelps(m_table.channels().size(), false),
      m_encoder(std::make_unique<ColumnEncoder>()) {
    for (const Channel& c : m_table.channels())
        m_fields.push_back(fieldOf(c));
}
ChunkEncoder::ChunkEncoder(ChunkEncoder&&) noexcept = default;
ChunkEncoder& ChunkEncoder::operator=(ChunkEncoder&&) noexcept = default;
ChunkEncoder::~ChunkEncoder() = default;

core::Result<Chunk> ChunkEncoder::encode(std::uint32_t sequence, std::span<const core::HapticFrame> frames) {
    using core::ErrorCode;
    const std::size_t n = frames.size();
    if (n == 0 || n > kMaximumFramesPerChunk)
        return core::fail(ErrorCode::wrongUse, "chunk of " + std::to_string(n) + " frames, expected 1.." +
                                                   std::to_string(kMaximumFramesPerChunk));
    for (const core::HapticFrame& frame : frames)
        if (frame.tools != static_cast<std::uint32_t>(m_table.tools()))
            return core::fail(ErrorCode::wrongUse, "frame of " + std::to_string(frame.tools) +
                                                       " tools, expected " + std::to_string(m_table.tools()) +
                                                       " as in the channel table");
    const std::size_t channels = m_fields.size();
    gatherAll(frames);

    Chunk chunk;
    chunk.sequence = sequence;
    chunk.firstTick = frames.front().header.index;
    chunk.frames = static_cast<std::uint32_t>(n);
    chunk.payload.push_back(kPayloadVersion);
    appendVarint(chunk.payload, n);
    appendVarint(chunk.payload, channels);
    m_columns.clear();
    for (std::size_t c = 0; c < channels; ++c) {
        const std::size_t start = m_columns.size();
        const bool tryZstd = sequence % kProbeEvery == 0 || m_zstdHelps[c];
        const bool referred = m_table.channels()[c].reference != kNoReference && changes(c);
        const bool helped =
            m_encoder->encode(referred ? residualOf(c, n) : countsOf(c, n), tryZstd, m_columns);
        m_columns[start] |= referred ? kReferred : 0;
        if (tryZstd)
            m_zstdHelps[c] = helped;
        appendVarint(chunk.payload, m_columns.size() - start);
    }
    chunk.payload.insert(chunk.payload.end(), m_columns.begin(), m_columns.end());
    chunk.forceHash = forceHashOf(frames);
    chunk.payloadDigest = payloadDigestOf(chunk);
    return chunk;
}

// At least half of the fields stay constant within a chunk, so checking whole words first is cheaper than
// checking every field.
void ChunkEncoder::gatherAll(std::span<const core::HapticFrame> frames) {
    const std::size_t n = frames.size();
    const std::size_t words = usedFrameBytes(frames.front().tools) / sizeof(std::uint64_t);
    m_counts.resize(m_fields.size() * n);
    m_changes.assign(words, 0);
    findChanges(frames, m_changes);
    for (std::size_t i = 0; i < n;
         i += kFramesAtOnce) { // few enough that every column finds them in the first-level cache
        const auto some = frames.subspan(i, std::min(kFramesAtOnce, n - i));
        for (std::size_t c = 0; c < m_fields.size(); ++c) {
            const auto values = std::span(m_counts).subspan(c * n + i, some.size());
            if (changes(c))
                gather(m_fields[c], some, values);
            else
                gatherConstant(m_fields[c], some.front(), values);
        }
    }
}

bool ChunkEncoder::changes(std::size_t channel) const noexcept {
    return m_changes[m_fields[channel].offset / sizeof(std::uint64_t)] != 0;
}

std::span<const std::int64_t> ChunkEncoder::countsOf(std::size_t channel, std::size_t frames) const noexcept {
    return std::span<const std::int64_t>(m_counts).subspan(channel * frames, frames);
}

std::span<const std::int64_t> ChunkEncoder::residualOf(std::size_t channel, std::size_t frames) {
    const Channel& about = m_table.channels()[channel];
    const auto values = countsOf(channel, frames);
    const auto base = countsOf(static_cast<std::size_t>(about.reference), frames);
    m_residual.resize(frames);
    const auto factor = static_cast<std::uint64_t>(about.factor);
    for (std::size_t i = 0; i < frames; ++i)
        m_residual[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(values[i]) -
                                                  factor * static_cast<std::uint64_t>(base[i]));
    return m_residual;
}

} // namespace chiron::recording
