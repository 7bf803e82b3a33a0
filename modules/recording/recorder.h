// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/result.h"
#include "recording/chunk_encoder.h"
#include "recording/position_of.h"
#include "recording/second_summaries.h"
#include "recording/trial_sink.h"

#include <cstdint>
#include <span>
#include <vector>

namespace chiron::recording {

struct RecorderSettings {
    std::uint32_t framesPerChunk = 200;      ///< 1..kMaximumFramesPerChunk
    std::int64_t chunkSpan_ns = 200'000'000; ///< a chunk is closed when its first frame is this old
    double forceLimit_N = 4.0;               ///< for timeOverLimit_s
};

/// Encodes frames into chunks and per-second summaries and writes them to a TrialSink in batches. The chunks
/// and the summaries of the seconds that end in them go together. The sink stores all of a batch or nothing;
/// a refused batch is kept and offered again. A second is handed over once, when a later one begins or at
/// finish(). May allocate; not copyable.
/// Thread: writer.
class Recorder {
public:
    Recorder(ChannelTable table, const IPositionOf& positionOf, TrialSink& sink,
             const RecorderSettings& settings);
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// For use after a crash: continues after the frames that `stored` holds (same table). The unfinished
    /// second is added up again from the stored frames, so that the totals are those of an undisturbed
    /// session. add() leaves out frames whose tick is already stored.
    /// Errors: as for RecordingReader.
    core::Result<void> resume(ChunkSource& stored);

    /// Takes frames in the order of their ticks; closes chunks as they fill. After an error framesTaken()
    /// says how many of them were taken; the others have to be offered again. Errors: wrongUse for a frame
    /// with another number of tools than the table, or after finish().
    core::Result<void> add(std::span<const core::HapticFrame> frames);
    /// Closes the open chunk if its first frame is chunkSpan_ns or more before now_ns (clock of
    /// TickHeader::now_ns).
    core::Result<void> closeOld(std::int64_t now_ns);
    /// Hands over the closed chunks.
    /// Errors: those of the sink; everything is kept for the next call.
    core::Result<void> write();
    /// Closes the open chunk and second, and writes. May be called again after an Error.
    core::Result<void> finish();

    std::uint64_t framesTaken() const noexcept { return m_taken; } ///< by add(), left-out ones included
    /// Those of them that are stored permanently.
    std::uint64_t framesCommitted() const noexcept { return m_committed; }
    std::uint64_t bytesWritten() const noexcept { return m_bytes; } ///< payload bytes stored
    std::uint32_t chunksWritten() const noexcept { return m_chunksWritten; }

private:
    core::Result<void> closeChunk();

    ChunkEncoder m_encoder;
    SecondSummaries m_summaries;
    TrialSink& m_sink;
    RecorderSettings m_settings;
    std::vector<core::HapticFrame> m_open; ///< buffer for framesPerChunk frames, the first m_openCount in use
    std::size_t m_openCount = 0;
    std::vector<Chunk> m_closed;
    std::vector<SecondSummary> m_done;
    std::uint32_t m_sequence = 0;
    std::uint64_t m_nextTick = 0; ///< frames with a lower index are already stored
    std::uint64_t m_taken = 0;
    std::uint64_t m_takenInClosed = 0;
    std::uint64_t m_committed = 0;
    std::uint64_t m_bytes = 0;
    std::uint32_t m_chunksWritten = 0;
    bool m_finished = false;
};

} // namespace chiron::recording
