// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recording_reader.h"

#include "recording/digest.h"
#include "recording/wrench_rounding.h"

#include <algorithm>
#include <cmath>

namespace chiron::recording {

using core::ErrorCode;

RecordingReader::RecordingReader(ChunkSource& source, ChannelTable table)
    : m_source(&source), m_decoder(std::move(table)), m_checked(source.chunkCount(), false) {}

core::Result<RecordingReader> RecordingReader::open(ChunkSource& source) {
    const auto bytes = source.channelTable();
    CHIRON_TRY(bytes);
    auto table = ChannelTable::decode(*bytes);
    CHIRON_TRY(table);
    return RecordingReader(source, std::move(*table));
}

core::Result<Chunk> RecordingReader::checkedChunk(std::size_t sequence) {
    if (sequence >= m_checked.size())
        return core::fail(ErrorCode::notFound,
                          "chunk " + std::to_string(sequence) + " of " + std::to_string(m_checked.size()));
    auto chunk = m_source->chunk(sequence);
    CHIRON_TRY(chunk);
    if (chunk->sequence != sequence)
        return core::fail(ErrorCode::doesNotHold, "chunk " + std::to_string(sequence) + ": found number " +
                                                      std::to_string(chunk->sequence) + ", expected " +
                                                      std::to_string(sequence));
    if (m_checked[sequence])
        return chunk;
    const Digest found = payloadDigestOf(*chunk);
    if (found != chunk->payloadDigest)
        return core::fail(ErrorCode::doesNotHold, "chunk " + std::to_string(sequence) + ": its digest is " +
                                                      toHex(found) + ", expected " +
                                                      toHex(chunk->payloadDigest));
    m_checked[sequence] = true;
    return chunk;
}

core::Result<std::vector<core::HapticFrame>> RecordingReader::framesOf(std::size_t sequence) {
    const auto chunk = checkedChunk(sequence);
    CHIRON_TRY(chunk);
    std::vector<core::HapticFrame> frames;
    CHIRON_TRY(m_decoder.decode(*chunk, frames));
    return frames;
}

core::Result<std::vector<core::HapticFrame>> RecordingReader::allFrames() {
    std::vector<core::HapticFrame> all;
    for (std::size_t i = 0; i < m_checked.size(); ++i) {
        const auto chunk = checkedChunk(i);
        CHIRON_TRY(chunk);
        CHIRON_TRY(m_decoder.decode(*chunk, all));
    }
    return all;
}

core::Result<std::uint64_t> RecordingReader::frameCount() {
    std::uint64_t frames = 0;
    for (std::size_t i = 0; i < m_checked.size(); ++i) {
        const auto chunk = checkedChunk(i);
        CHIRON_TRY(chunk);
        frames += chunk->frames;
    }
    return frames;
}

core::Result<std::uint64_t> RecordingReader::lastTickOf(const Chunk& chunk) {
    const auto channel = table().find(kNoTool, "tick");
    if (!channel)
        return chunk.firstTick + (chunk.frames - 1);
    std::vector<std::int64_t> ticks;
    CHIRON_TRY(m_decoder.decodeChannel(chunk, *channel, ticks));
    return static_cast<std::uint64_t>(ticks.back());
}

core::Result<core::HapticFrame> RecordingReader::frameAtTick(std::uint64_t tick) {
    constexpr int kGuesses = 3; // chunks are alike, so the first or second guess is right; after that,
                                // bisection
    std::size_t low = 0, high = m_checked.size();
    std::size_t guess = 0;
    for (int tries = 0; low < high; ++tries) {
        const auto chunk = checkedChunk(guess);
        CHIRON_TRY(chunk);
        if (tick < chunk->firstTick) {
            high = guess;
        } else {
            const auto last = lastTickOf(*chunk);
            CHIRON_TRY(last);
            if (tick <= *last)
                return m_decoder.decodeTick(*chunk, tick);
            low = guess + 1;
        }
        if (low >= high)
            break;
        const auto away = (static_cast<double>(tick) - static_cast<double>(chunk->firstTick)) / chunk->frames;
        const double aim = std::floor(static_cast<double>(guess) + away);
        guess = tries < kGuesses ? static_cast<std::size_t>(std::clamp(aim, static_cast<double>(low),
                                                                       static_cast<double>(high - 1)))
                                 : low + (high - low) / 2;
    }
    return core::fail(ErrorCode::notFound, "tick " + std::to_string(tick) + " is not in the recording");
}

core::Result<std::vector<std::int64_t>> RecordingReader::channelCounts(std::uint8_t tool,
                                                                       std::string_view id) {
    const auto channel = table().find(tool, id);
    if (!channel)
        return core::fail(ErrorCode::notFound, "recording: tool " + std::to_string(tool) +
                                                   " has no channel \"" + std::string(id) + "\"");
    std::vector<std::int64_t> counts;
    for (std::size_t i = 0; i < m_checked.size(); ++i) {
        const auto chunk = checkedChunk(i);
        CHIRON_TRY(chunk);
        CHIRON_TRY(m_decoder.decodeChannel(*chunk, *channel, counts));
    }
    return counts;
}

core::Result<std::vector<double>> RecordingReader::channelValues(std::uint8_t tool, std::string_view id) {
    const auto counts = channelCounts(tool, id);
    CHIRON_TRY(counts);
    const Channel& channel = table().channels()[*table().find(tool, id)];
    const double steps = stepsPerUnit(channel.resolution);
    std::vector<double> values(counts->size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = channel.kind == ChannelKind::quantised
                        ? dequantise((*counts)[i], steps)
                        : static_cast<double>((*counts)[i]) * channel.resolution;
    return values;
}

core::Result<Digest> RecordingReader::forceHash(std::size_t sequence) {
    const auto chunk = checkedChunk(sequence);
    CHIRON_TRY(chunk);
    return chunk->forceHash;
}

core::Result<void> RecordingReader::verify() {
    std::uint64_t next = 0;
    for (std::size_t i = 0; i < m_checked.size(); ++i) {
        m_checked[i] = false; // the source may have changed meanwhile
        const auto frames = framesOf(i);
        CHIRON_TRY(frames);
        for (const core::HapticFrame& frame : *frames) {
            if (frame.header.index < next)
                return core::fail(ErrorCode::doesNotHold, "chunk " + std::to_string(i) + ": tick " +
                                                              std::to_string(frame.header.index) +
                                                              ", expected at least " + std::to_string(next));
            next = frame.header.index + 1;
        }
    }
    return {};
}

} // namespace chiron::recording
