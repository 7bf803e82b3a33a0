// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recorder.h"

#include "recording/recording_reader.h"
#include "recording/ring_layout.h"

#include <algorithm>
#include <cstring>

namespace chiron::recording {

Recorder::Recorder(ChannelTable table, const IPositionOf& positionOf, TrialSink& sink,
                   const RecorderSettings& settings)
    : m_encoder(std::move(table)), m_summaries(positionOf, settings.forceLimit_N), m_sink(sink),
      m_settings(settings) {
    m_settings.framesPerChunk = std::clamp<std::uint32_t>(settings.framesPerChunk, 1, kMaximumFramesPerChunk);
    m_open.resize(m_settings.framesPerChunk);
}

core::Result<void> Recorder::resume(ChunkSource& stored) {
    auto reader = RecordingReader::open(stored);
    CHIRON_TRY(reader);
    // Reads all chunks, although only the last second is missing: when a device's clock was set back, a
    // second may depend on any earlier one. A whole session takes a fraction of a second.
    std::vector<SecondSummary> storedAlready;
    for (std::size_t i = 0; i < reader->chunkCount(); ++i) {
        const auto frames = reader->framesOf(i);
        CHIRON_TRY(frames);
        for (const core::HapticFrame& frame : *frames)
            m_summaries.add(frame, storedAlready);
        m_nextTick = frames->back().header.index + 1;
    }
    m_sequence = static_cast<std::uint32_t>(reader->chunkCount());
    return {};
}

core::Result<void> Recorder::add(std::span<const core::HapticFrame> frames) {
    if (m_finished)
        return core::fail(core::ErrorCode::wrongUse, "recording: a frame after the end");
    const auto tools = static_cast<std::uint32_t>(m_encoder.table().tools());
    for (const core::HapticFrame& frame : frames) {
        if (m_openCount == m_open.size()) // a chunk that could not be closed before
            CHIRON_TRY(closeChunk());
        if (frame.tools != tools)
            return core::fail(core::ErrorCode::wrongUse,
                              "recording: tick " + std::to_string(frame.header.index) + " has " +
                                  std::to_string(frame.tools) + " tools, expected " + std::to_string(tools));
        ++m_taken;
        if (frame.header.index < m_nextTick)
            continue; // stored before the crash
        m_nextTick = frame.header.index + 1;
        std::memcpy(static_cast<void*>(&m_open[m_openCount++]), &frame, usedFrameBytes(tools));
        if (m_openCount < m_open.size())
            continue;
        CHIRON_TRY(closeChunk());
    }
    return {};
}

core::Result<void> Recorder::closeOld(std::int64_t now_ns) {
    if (m_openCount == 0 || now_ns - m_open.front().header.now_ns < m_settings.chunkSpan_ns)
        return {};
    return closeChunk();
}

core::Result<void> Recorder::closeChunk() {
    const auto frames = std::span<const core::HapticFrame>(m_open).first(m_openCount);
    auto chunk = m_encoder.encode(m_sequence, frames);
    CHIRON_TRY(chunk);
    for (const core::HapticFrame& frame : frames)
        m_summaries.add(frame, m_done);
    m_closed.push_back(std::move(*chunk));
    ++m_sequence;
    m_openCount = 0;
    m_takenInClosed = m_taken;
    return {};
}

core::Result<void> Recorder::write() {
    if (!m_closed.empty() || !m_done.empty()) {
        CHIRON_TRY(m_sink.write(m_closed, m_done));
    }
    m_chunksWritten += static_cast<std::uint32_t>(m_closed.size());
    for (const Chunk& chunk : m_closed)
        m_bytes += chunk.payload.size();
    m_closed.clear();
    m_done.clear();
    m_committed = m_openCount == 0 ? m_taken : m_takenInClosed;
    return {};
}

core::Result<void> Recorder::finish() {
    if (m_openCount > 0) {
        CHIRON_TRY(closeChunk());
    }
    if (!m_finished)
        m_summaries.finish(m_done);
    m_finished = true;
    return write();
}

} // namespace chiron::recording
