// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/result.h"
#include "recording/recorder.h"
#include "recording/ring_drain.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace chiron::recording {

/// Moves frames from the ring to the Recorder. The writer thread calls it every 20 ms for each live session.
/// Ring and recorder must outlive it.
class FrameDrain {
public:
    FrameDrain(CrashRing& ring, Recorder& recorder);

    /// Takes the new frames, writes closed chunks, and frees the slots of stored frames. now_ns is in the
    /// clock of TickHeader::now_ns.
    /// Errors: those of the recorder and of the sink; no frame is lost until the ring overflows, and the next
    /// call tries again.
    core::Result<void> drain(std::int64_t now_ns);
    /// For use after the last push: takes all frames, closes the chunk and writes it. May be repeated after
    /// an Error.
    core::Result<void> finish();

    /// Frames that never reached the recording: dropped because the ring was full, or damaged in it. If not
    /// 0, the recording is incomplete.
    std::uint64_t lost() const noexcept { return m_ring.dropped() + m_ring.damaged(); }

private:
    core::Result<void> take();
    void commit() noexcept;

    RingDrain m_ring;
    Recorder& m_recorder;
    std::vector<core::HapticFrame> m_frames; ///< as last read from the ring
    /// Those of them that the recorder has not taken yet: from the first to before the last. None is read
    /// from the ring while there are any.
    std::size_t m_first = 0, m_last = 0;
};

} // namespace chiron::recording
