// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "realtime/spsc_ring.h"
#include "session/study/fidelity_sample.h"

#include <cstdint>

namespace chiron::session {

/// Passes the data for a trial's fidelity from the haptic thread to the window's thread. It holds eight
/// seconds. A window that stalls longer misses ticks but no events: events of ticks that found the ring full
/// are added to the next sample that is accepted.
/// Thread: tryPush() haptic, ring() one other.
class SampleTap final : public core::IFrameSink {
public:
    static constexpr std::size_t kSamples = 8192;

    bool tryPush(const core::HapticFrame& frame) noexcept override {
        FidelitySample sample = fidelitySampleOf(frame);
        m_missed |= sample.events;
        sample.events = m_missed;
        if (!m_ring.tryPush(sample))
            return false;
        m_missed = 0;
        return true;
    }
    realtime::SpscRing<FidelitySample, kSamples>& ring() noexcept { return m_ring; }

private:
    realtime::SpscRing<FidelitySample, kSamples> m_ring;
    std::uint32_t m_missed = 0; ///< belongs to the haptic thread
};

} // namespace chiron::session
