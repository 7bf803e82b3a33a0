// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "realtime/spsc_ring.h"
#include "session/study/fidelity_sample.h"

#include <cstdint>

namespace chiron::session {

/// Hands what a trial's fidelity needs from the haptic thread to the window's. Eight seconds fit. A window that sleeps longer misses ticks,
/// but no event: what a tick that found the ring full began or ended is told by the next that is taken. Threads: tryPush() haptic, ring()
/// one other.
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
    std::uint32_t m_missed = 0; ///< haptic thread's
};

} // namespace chiron::session
