// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "devices/api/device.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "session/live_link.h"
#include "session/trace_mark.h"

#include <atomic>
#include <cstdint>

namespace chiron::session {

/// Passes each frame to the recording and to an optional witness (live plots, a test), and stores the current
/// phase of the trial.
class TeeSink final : public core::IFrameSink {
public:
    TeeSink(core::IFrameSink& recording, core::IFrameSink* witness) noexcept
        : m_recording(recording), m_witness(witness) {}
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        const bool stored = m_recording.tryPush(frame);
        if (m_witness)
            // A witness that is full misses the frame; only the recording must be complete.
            m_witness->tryPush(frame);
        m_phase = frame.header.phase;
        return stored;
    }
    core::TrialPhase phase() const noexcept { return m_phase; } ///< haptic thread

private:
    core::IFrameSink& m_recording;
    core::IFrameSink* m_witness;
    core::TrialPhase m_phase = core::TrialPhase::idle;
};

/// The conditions that end a scripted run, in addition to the exercise itself.
struct RunLimits {
    std::uint64_t tickLimit = 0;
    /// When the device has finished (IDevice::finished()), the last position is marked and the session ends.
    const devices::IDevice* device = nullptr;
    const std::atomic<bool>* cancel = nullptr;
    LiveLink* live = nullptr; ///< an observing window, which receives every tick
    bool endIsMark = true;    ///< the last position counts as the answer (ExerciseKind::markRole())
};

/// Adapts the loop to a runner and ends it by a command, so that the end is recorded like everything else. A
/// TickTask.
class RunTask {
public:
    RunTask(haptics::HapticLoop& loop, haptics::LiveInputs& inputs, const TeeSink& sink,
            RunLimits limits) noexcept
        : m_loop(loop), m_inputs(inputs), m_sink(sink), m_limits(limits) {}

    bool tick(const realtime::HapticTick& now) noexcept {
        const bool goOn = m_loop.tick(now);
        if (m_limits.live)
            m_limits.live->publish(m_loop.shown());
        if (!m_ending && wantsEnd(now)) {
            m_ending = true;
            if (m_limits.endIsMark && m_limits.device && m_limits.device->finished() &&
                m_sink.phase() == core::TrialPhase::running)
                // A trace without a mark: its last position is the answer.
                m_inputs.postOwn({core::CommandKind::mark, kMarkOfTraceEnd});
            else
                m_inputs.postOwn({core::CommandKind::end});
        } else if (m_ending && !m_ended) {
            m_ended = true;
            m_inputs.postOwn({core::CommandKind::end});
        }
        return goOn;
    }
    void timing(const realtime::TickTiming& timing) noexcept {
        m_loop.timing(timing);
        if (m_limits.live)
            m_limits.live->publish(m_loop.statistics());
    }

private:
    bool wantsEnd(const realtime::HapticTick& now) const noexcept {
        return now.index() >= m_limits.tickLimit || (m_limits.device && m_limits.device->finished()) ||
               (m_limits.cancel && m_limits.cancel->load(std::memory_order_relaxed));
    }

    haptics::HapticLoop& m_loop;
    haptics::LiveInputs& m_inputs;
    const TeeSink& m_sink;
    RunLimits m_limits;
    bool m_ending = false;
    bool m_ended = false;
};

} // namespace chiron::session
