// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "session/study/fidelity_sample.h"

#include <algorithm>
#include <cstdint>

namespace chiron::session {

/// The duration of a trial, in ticks. Ticks and contacts during a pause do not count.
/// Thread: any one.
class TrialClock {
public:
    void begin(std::uint64_t tick) noexcept {
        m_first = m_last = m_lastContact = tick;
        m_paused = m_pausedSinceContact = 0;
    }
    void take(const FidelitySample& sample, bool inContact) noexcept {
        m_last = sample.tick;
        if (sample.paused != 0) {
            ++m_paused;
            ++m_pausedSinceContact;
        } else if (inContact) {
            m_lastContact = sample.tick;
            m_pausedSinceContact = 0;
        }
    }

    std::uint64_t first() const noexcept { return m_first; }
    std::uint64_t last() const noexcept { return m_last; }
    /// Since the trial began.
    double exploration_s() const noexcept { return seconds(m_last - m_first, m_paused); }
    /// Since the last contact, or since the trial began if there was none.
    double sinceContact_s() const noexcept { return seconds(m_last - m_lastContact, m_pausedSinceContact); }
    double paused_s() const noexcept { return static_cast<double>(m_paused) * core::kTickSeconds; }

private:
    static double seconds(std::uint64_t ticks, std::uint64_t paused) noexcept {
        return static_cast<double>(ticks - std::min(ticks, paused)) * core::kTickSeconds;
    }

    std::uint64_t m_first = 0, m_last = 0, m_lastContact = 0;
    std::uint64_t m_paused = 0, m_pausedSinceContact = 0;
};

} // namespace chiron::session
