// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/frame_drain.h"

namespace chiron::recording {

namespace {
constexpr std::size_t kFramesAtOnce = 64; // a drain every 20 ms finds 20 frames
}

FrameDrain::FrameDrain(CrashRing& ring, Recorder& recorder)
    : m_ring(ring), m_recorder(recorder), m_frames(kFramesAtOnce) {}

core::Result<void> FrameDrain::take() {
    for (;;) {
        if (m_first == m_last) {
            m_first = 0;
            m_last = m_ring.read(m_frames);
            if (m_last == 0)
                return {};
        }
        const std::uint64_t before = m_recorder.framesTaken();
        const auto added = m_recorder.add(std::span(m_frames).subspan(m_first, m_last - m_first));
        m_first += static_cast<std::size_t>(m_recorder.framesTaken() - before);
        CHIRON_TRY(added);
    }
}

// Damaged slots are not among the recorder's frames. If there are any, the mark lags by as many; it never
// runs ahead.
void FrameDrain::commit() noexcept {
    m_ring.commit(m_recorder.framesCommitted());
}

core::Result<void> FrameDrain::drain(std::int64_t now_ns) {
    CHIRON_TRY(take());
    CHIRON_TRY(m_recorder.closeOld(now_ns));
    auto written = m_recorder.write();
    commit();
    return written;
}

core::Result<void> FrameDrain::finish() {
    CHIRON_TRY(take());
    auto written = m_recorder.finish();
    commit();
    return written;
}

} // namespace chiron::recording
