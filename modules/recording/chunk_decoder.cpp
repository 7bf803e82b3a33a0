// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/chunk_decoder.h"

#include "recording/byte_cursor.h"
#include "recording/chunk_format.h"

namespace chiron::recording {

namespace {
tl::unexpected<core::Error> flaw(const Chunk& chunk, std::size_t offset, const std::string& what) {
    return core::fail(core::ErrorCode::badInput, "chunk " + std::to_string(chunk.sequence) +
                                                     ", payload byte " + std::to_string(offset) + ": " +
                                                     what);
}
} // namespace

ChunkDecoder::ChunkDecoder(ChannelTable table)
    : m_table(std::move(table)), m_decoder(std::make_unique<ColumnDecoder>()) {
    for (const Channel& c : m_table.channels())
        m_fields.push_back(fieldOf(c));
    m_tickChannel = m_table.find(kNoTool, "tick").value_or(m_fields.size());
}
ChunkDecoder::ChunkDecoder(ChunkDecoder&&) noexcept = default;
ChunkDecoder& ChunkDecoder::operator=(ChunkDecoder&&) noexcept = default;
ChunkDecoder::~ChunkDecoder() = default;

core::Result<void> ChunkDecoder::openPayload(const Chunk& chunk) {
    if (chunk.frames == 0 || chunk.frames > kMaximumFramesPerChunk)
        return flaw(chunk, 0,
                    std::to_string(chunk.frames) + " frames, expected 1.." +
                        std::to_string(kMaximumFramesPerChunk));
    if (chunk.payload.size() > kMaximumPayloadBytes)
        return flaw(chunk, kMaximumPayloadBytes,
                    std::to_string(chunk.payload.size()) + " bytes, expected at most " +
                        std::to_string(kMaximumPayloadBytes));
    ByteCursor in(chunk.payload);
    if (in.word<std::uint8_t>() != kPayloadVersion)
        return flaw(chunk, 0, "expected version " + std::to_string(kPayloadVersion));
    std::size_t at = in.position();
    if (in.varint() != chunk.frames)
        return flaw(chunk, at, "expected " + std::to_string(chunk.frames) + " frames as the chunk says");
    at = in.position();
    if (in.varint() != m_fields.size())
        return flaw(chunk, at,
                    "expected " + std::to_string(m_fields.size()) + " channels as in the channel table");
    m_offsets.assign(1, 0);
    for (std::size_t c = 0; c < m_fields.size(); ++c) {
        at = in.position();
        const auto length = in.varint();
        if (!length || *length > chunk.payload.size() - m_offsets.back())
            return flaw(chunk, at,
                        "expected the length of column " + std::to_string(c) + " within the payload");
        m_offsets.push_back(m_offsets.back() + static_cast<std::size_t>(*length));
    }
    if (m_offsets.back() != in.remaining())
        return flaw(chunk, in.position(),
                    "expected columns of " + std::to_string(m_offsets.back()) + " bytes, found " +
                        std::to_string(in.remaining()));
    for (std::size_t& offset : m_offsets)
        offset += in.position();
    return {};
}

core::Result<void> ChunkDecoder::decodeColumn(const Chunk& chunk, std::size_t channel,
                                              std::span<std::int64_t> values) {
    const std::size_t start = m_offsets[channel];
    const auto bytes = std::span(chunk.payload).subspan(start, m_offsets[channel + 1] - start);
    if (refers(chunk, channel) && m_table.channels()[channel].reference == kNoReference)
        return flaw(chunk, start,
                    "expected channel \"" + m_table.channels()[channel].id + "\" to stand alone");
    if (auto decoded = m_decoder->decode(bytes, start, values); !decoded)
        return core::fail(decoded.error().code, "chunk " + std::to_string(chunk.sequence) + ", channel \"" +
                                                    m_table.channels()[channel].id + "\", payload " +
                                                    decoded.error().message);
    return {};
}

bool ChunkDecoder::refers(const Chunk& chunk, std::size_t channel) const noexcept {
    return m_offsets[channel + 1] > m_offsets[channel] &&
           (chunk.payload[m_offsets[channel]] & kReferred) != 0;
}

void ChunkDecoder::addReference(std::size_t channel, std::span<const std::int64_t> reference,
                                std::span<std::int64_t> values) const {
    const auto factor = static_cast<std::uint64_t>(m_table.channels()[channel].factor);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(values[i]) +
                                              factor * static_cast<std::uint64_t>(reference[i]));
}

core::Result<void> ChunkDecoder::decodeAll(const Chunk& chunk) {
    CHIRON_TRY(openPayload(chunk));
    const std::size_t n = chunk.frames;
    m_values.resize(m_fields.size() * n);
    const std::span<std::int64_t> all(m_values);
    for (std::size_t c = 0; c < m_fields.size(); ++c) {
        const auto values = all.subspan(c * n, n);
        CHIRON_TRY(decodeColumn(chunk, c, values));
        if (refers(chunk, c))
            addReference(c, all.subspan(static_cast<std::size_t>(m_table.channels()[c].reference) * n, n),
                         values);
    }
    if (m_tickChannel < m_fields.size() &&
        static_cast<std::uint64_t>(m_values[m_tickChannel * n]) != chunk.firstTick)
        return flaw(chunk, m_offsets[m_tickChannel],
                    "expected first tick " + std::to_string(chunk.firstTick));
    return {};
}

core::Result<void> ChunkDecoder::misfit(const Chunk& chunk, std::size_t channel, std::size_t row) const {
    return flaw(chunk, m_offsets[channel],
                "channel \"" + m_table.channels()[channel].id + "\", frame " + std::to_string(row) +
                    ": count " + std::to_string(m_values[channel * chunk.frames + row]) +
                    ", expected one that fits its field");
}

core::Result<void> ChunkDecoder::fill(const Chunk& chunk, std::size_t row, core::HapticFrame& frame) const {
    frame.tools = static_cast<std::uint32_t>(m_table.tools());
    for (std::size_t c = 0; c < m_fields.size(); ++c) {
        const std::int64_t count = m_values[c * chunk.frames + row];
        if (!put(m_fields[c], count, frame))
            return misfit(chunk, c, row);
    }
    return {};
}

core::Result<void> ChunkDecoder::decode(const Chunk& chunk, std::vector<core::HapticFrame>& frames) {
    CHIRON_TRY(decodeAll(chunk));
    const std::size_t before = frames.size();
    frames.resize(before + chunk.frames);
    const auto added = std::span(frames).subspan(before);
    for (core::HapticFrame& frame : added)
        frame.tools = static_cast<std::uint32_t>(m_table.tools());
    for (std::size_t c = 0; c < m_fields.size(); ++c) {
        const auto values = std::span<const std::int64_t>(m_values).subspan(c * chunk.frames, chunk.frames);
        const std::size_t row = scatter(m_fields[c], values, added);
        if (row == chunk.frames)
            continue;
        frames.resize(before);
        return misfit(chunk, c, row);
    }
    return {};
}

core::Result<core::HapticFrame> ChunkDecoder::decodeTick(const Chunk& chunk, std::uint64_t tick) {
    CHIRON_TRY(decodeAll(chunk));
    for (std::size_t row = 0; m_tickChannel < m_fields.size() && row < chunk.frames; ++row) {
        if (static_cast<std::uint64_t>(m_values[m_tickChannel * chunk.frames + row]) != tick)
            continue;
        core::HapticFrame frame;
        CHIRON_TRY(fill(chunk, row, frame));
        return frame;
    }
    return core::fail(core::ErrorCode::notFound,
                      "tick " + std::to_string(tick) + " is not in chunk " + std::to_string(chunk.sequence));
}

core::Result<void> ChunkDecoder::decodeChannel(const Chunk& chunk, std::size_t channel,
                                               std::vector<std::int64_t>& counts) {
    CHIRON_TRY(openPayload(chunk));
    const std::size_t before = counts.size();
    counts.resize(before + chunk.frames);
    const auto values = std::span(counts).subspan(before);
    auto decoded = decodeColumn(chunk, channel, values);
    if (decoded && refers(chunk, channel)) {
        m_reference.resize(chunk.frames);
        decoded =
            decodeColumn(chunk, static_cast<std::size_t>(m_table.channels()[channel].reference), m_reference);
        if (decoded)
            addReference(channel, m_reference, values);
    }
    if (!decoded)
        counts.resize(before);
    return decoded;
}

} // namespace chiron::recording
