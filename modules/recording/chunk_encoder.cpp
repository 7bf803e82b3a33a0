// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/chunk_encoder.h"

#include "recording/byte_cursor.h"
#include "recording/chunk_format.h"
#include "recording/digest.h"

namespace chiron::recording {

namespace {
constexpr std::uint32_t kProbeEvery = 16; // chunks: zstd on packed numbers seldom helps, and costs more than all the rest
}

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
            return core::fail(ErrorCode::wrongUse, "frame of " + std::to_string(frame.tools) + " tools, expected " +
                                                       std::to_string(m_table.tools()) + " as in the channel table");
    const std::size_t channels = m_fields.size();
    m_counts.resize(channels * n);
    for (std::size_t c = 0; c < channels; ++c)
        gather(m_fields[c], frames, std::span(m_counts).subspan(c * n, n));

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
        encodeColumn(c, n, sequence % kProbeEvery == 0);
        appendVarint(chunk.payload, m_columns.size() - start);
    }
    chunk.payload.insert(chunk.payload.end(), m_columns.begin(), m_columns.end());
    chunk.forceHash = forceHashOf(frames);
    chunk.payloadDigest = payloadDigestOf(chunk);
    return chunk;
}

void ChunkEncoder::encodeColumn(std::size_t channel, std::size_t frames, bool probe) {
    const Channel& about = m_table.channels()[channel];
    auto values = std::span<const std::int64_t>(m_counts).subspan(channel * frames, frames);
    if (about.reference != kNoReference) {
        const auto base = std::span<const std::int64_t>(m_counts).subspan(
            static_cast<std::size_t>(about.reference) * frames, frames);
        m_residual.resize(frames);
        const auto factor = static_cast<std::uint64_t>(about.factor);
        for (std::size_t i = 0; i < frames; ++i)
            m_residual[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(values[i]) -
                                                      factor * static_cast<std::uint64_t>(base[i]));
        values = m_residual;
    }
    const bool tryZstd = probe || m_zstdHelps[channel];
    const bool helped = m_encoder->encode(values, tryZstd, m_columns);
    if (tryZstd)
        m_zstdHelps[channel] = helped;
}

} // namespace chiron::recording
