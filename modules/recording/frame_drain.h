// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/result.h"
#include "recording/recorder.h"
#include "recording/ring_drain.h"

#include <cstdint>
#include <vector>

namespace chiron::recording {

/// Ring -> Recorder: what the writer thread calls every 20 ms for each live session. Ring and recorder must
/// outlive it.
class FrameDrain {
public:
    FrameDrain(CrashRing& ring, Recorder& recorder);

    /// Takes what is new, writes closed chunks, and frees the slots that are stored. now_ns in the clock of
    /// TickHeader::now_ns. Error: the sink's; nothing is lost until the ring overflows, the next call tries
    /// again.
    core::Result<void> drain(std::int64_t now_ns);
    /// After the last push: takes everything, closes and writes it. May be repeated after an Error.
    core::Result<void> finish();

    /// Frames that never came into the recording: dropped at a full ring, or damaged in it. Not 0:
    /// incomplete.
    std::uint64_t lost() const noexcept { return m_ring.dropped() + m_ring.damaged(); }

private:
    core::Result<void> take();
    void commit() noexcept;

    RingDrain m_ring;
    Recorder& m_recorder;
    std::vector<core::HapticFrame> m_frames;
};

} // namespace chiron::recording
