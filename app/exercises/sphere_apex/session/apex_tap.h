// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "realtime/spsc_ring.h"
#include "session/study/fidelity_sample.h"

#include <cstdint>

namespace chiron::session {

/// A tick as input of ApexWatch, with the tool's own counts, from which the position of a mark is computed.
struct ApexTick {
    FidelitySample sample;
    core::ToolFrame tool;
    bool lost = false; ///< earlier ticks were lost because the ring was full, so the position of a mark among
                       ///< them is unknown
};

/// Like SampleTap, with the tool.
/// Thread: tryPush() haptic, ring() one other.
class ApexTap final : public core::IFrameSink {
public:
    static constexpr std::size_t kTicks = 8192;

    bool tryPush(const core::HapticFrame& frame) noexcept override {
        ApexTick tick{fidelitySampleOf(frame), frame.tool[0], m_lost};
        m_missed |= tick.sample.events;
        tick.sample.events = m_missed;
        m_lost = !m_ring.tryPush(tick);
        if (!m_lost)
            m_missed = 0;
        return !m_lost;
    }
    realtime::SpscRing<ApexTick, kTicks>& ring() noexcept { return m_ring; }

private:
    realtime::SpscRing<ApexTick, kTicks> m_ring;
    std::uint32_t m_missed = 0; ///< belongs to the haptic thread, as does m_lost
    bool m_lost = false;
};

} // namespace chiron::session
