// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_reader.h"

#include "recording/digest.h"
#include "recording/wrench_rounding.h"

#include <algorithm>

namespace chiron::recording {

using core::ErrorCode;

RecordingReader::RecordingReader(ChunkSource& source, ChannelTable table, std::vector<ChunkInfo> index)
    : m_source(&source), m_decoder(std::move(table)), m_index(std::move(index)), m_checked(m_index.size(), false) {
    for (const ChunkInfo& info : m_index)
        m_frames += info.frames;
}

core::Result<RecordingReader> RecordingReader::open(ChunkSource& source) {
    const auto bytes = source.channelTable();
    if (!bytes)
        return tl::make_unexpected(bytes.error());
    auto table = ChannelTable::decode(*bytes);
    if (!table)
        return tl::make_unexpected(table.error());
    auto index = source.index();
    if (!index)
        return tl::make_unexpected(index.error());
    for (std::size_t i = 0; i < index->size(); ++i) {
        const ChunkInfo& info = (*index)[i];
        if (info.sequence != i)
            return core::fail(ErrorCode::badInput, "recording: found chunk " + std::to_string(info.sequence) +
                                                       ", expected chunk " + std::to_string(i));
        if (i > 0 && info.firstTick <= (*index)[i - 1].firstTick)
            return core::fail(ErrorCode::badInput, "recording: chunk " + std::to_string(i) + " begins at tick " +
                                                       std::to_string(info.firstTick) + ", expected one after " +
                                                       std::to_string((*index)[i - 1].firstTick));
    }
    return RecordingReader(source, std::move(*table), std::move(*index));
}

core::Result<Chunk> RecordingReader::checkedChunk(std::size_t sequence) {
    if (sequence >= m_index.size())
        return core::fail(ErrorCode::notFound, "chunk " + std::to_string(sequence) + " of " + std::to_string(m_index.size()));
    auto chunk = m_source->chunk(sequence);
    if (!chunk)
        return chunk;
    const ChunkInfo& info = m_index[sequence];
    if (chunk->sequence != info.sequence || chunk->firstTick != info.firstTick || chunk->frames != info.frames)
        return core::fail(ErrorCode::doesNotHold,
                          "chunk " + std::to_string(sequence) + ": its number, first tick or length is not that of the index");
    if (m_checked[sequence])
        return chunk;
    const Digest found = payloadDigestOf(*chunk);
    if (found != chunk->payloadDigest)
        return core::fail(ErrorCode::doesNotHold, "chunk " + std::to_string(sequence) + ": its digest is " + toHex(found) +
                                                      ", expected " + toHex(chunk->payloadDigest));
    m_checked[sequence] = true;
    return chunk;
}

core::Result<std::vector<core::HapticFrame>> RecordingReader::framesOf(std::size_t sequence) {
    const auto chunk = checkedChunk(sequence);
    if (!chunk)
        return tl::make_unexpected(chunk.error());
    std::vector<core::HapticFrame> frames;
    if (auto decoded = m_decoder.decode(*chunk, frames); !decoded)
        return tl::make_unexpected(decoded.error());
    return frames;
}

core::Result<std::vector<core::HapticFrame>> RecordingReader::allFrames() {
    std::vector<core::HapticFrame> all;
    for (std::size_t i = 0; i < m_index.size(); ++i) {
        const auto chunk = checkedChunk(i);
        if (!chunk)
            return tl::make_unexpected(chunk.error());
        if (auto decoded = m_decoder.decode(*chunk, all); !decoded)
            return tl::make_unexpected(decoded.error());
    }
    return all;
}

core::Result<core::HapticFrame> RecordingReader::frameAtTick(std::uint64_t tick) {
    const auto after = std::upper_bound(m_index.begin(), m_index.end(), tick,
                                        [](std::uint64_t t, const ChunkInfo& info) { return t < info.firstTick; });
    if (after == m_index.begin())
        return core::fail(ErrorCode::notFound, "tick " + std::to_string(tick) + " is before the recording");
    const auto chunk = checkedChunk(static_cast<std::size_t>(after - m_index.begin()) - 1);
    if (!chunk)
        return tl::make_unexpected(chunk.error());
    return m_decoder.decodeTick(*chunk, tick);
}

core::Result<std::vector<std::int64_t>> RecordingReader::channelCounts(std::uint8_t tool, std::string_view id) {
    const auto channel = table().find(tool, id);
    if (!channel)
        return core::fail(ErrorCode::notFound, "recording: tool " + std::to_string(tool) + " has no channel \"" +
                                                   std::string(id) + "\"");
    std::vector<std::int64_t> counts;
    for (std::size_t i = 0; i < m_index.size(); ++i) {
        const auto chunk = checkedChunk(i);
        if (!chunk)
            return tl::make_unexpected(chunk.error());
        if (auto decoded = m_decoder.decodeChannel(*chunk, *channel, counts); !decoded)
            return tl::make_unexpected(decoded.error());
    }
    return counts;
}

core::Result<std::vector<double>> RecordingReader::channelValues(std::uint8_t tool, std::string_view id) {
    const auto counts = channelCounts(tool, id);
    if (!counts)
        return tl::make_unexpected(counts.error());
    const Channel& channel = table().channels()[*table().find(tool, id)];
    const double steps = stepsPerUnit(channel.resolution);
    std::vector<double> values(counts->size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = channel.kind == ChannelKind::quantised ? dequantise((*counts)[i], steps)
                                                           : static_cast<double>((*counts)[i]) * channel.resolution;
    return values;
}

core::Result<Digest> RecordingReader::forceHash(std::size_t sequence) {
    const auto chunk = checkedChunk(sequence);
    if (!chunk)
        return tl::make_unexpected(chunk.error());
    return chunk->forceHash;
}

core::Result<void> RecordingReader::verify() {
    for (std::size_t i = 0; i < m_index.size(); ++i) {
        m_checked[i] = false; // the source may have changed since
        if (const auto frames = framesOf(i); !frames)
            return tl::make_unexpected(frames.error());
    }
    return {};
}

} // namespace chiron::recording
