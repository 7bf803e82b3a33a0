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

/// Hands each frame to the recording and to a witness (live plots, a test), and remembers where the trial stands.
class TeeSink final : public core::IFrameSink {
public:
    TeeSink(core::IFrameSink& recording, core::IFrameSink* witness) noexcept
        : m_recording(recording), m_witness(witness) {}
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        const bool stored = m_recording.tryPush(frame);
        if (m_witness)
            m_witness->tryPush(frame); // a witness that is full misses a frame; the recording is what counts
        m_phase = frame.header.phase;
        return stored;
    }
    core::TrialPhase phase() const noexcept { return m_phase; } ///< haptic thread

private:
    core::IFrameSink& m_recording;
    core::IFrameSink* m_witness;
    core::TrialPhase m_phase = core::TrialPhase::idle;
};

/// What ends a scripted run, beside the exercise itself.
struct RunLimits {
    std::uint64_t tickLimit = 0;
    const devices::IDevice* device = nullptr; ///< where it comes to an end (IDevice::finished()), that marks the last position and ends the session
    const std::atomic<bool>* cancel = nullptr;
    LiveLink* live = nullptr; ///< a window that looks on: gets every tick
    bool endIsMark = true; ///< ExerciseKind::traceEndIsMark()
};

/// The loop as a runner drives it: ends it by command, so that the end is recorded like everything else. A TickTask.
class RunTask {
public:
    RunTask(haptics::HapticLoop& loop, haptics::LiveInputs& inputs, const TeeSink& sink, RunLimits limits) noexcept
        : m_loop(loop), m_inputs(inputs), m_sink(sink), m_limits(limits) {}

    bool tick(const realtime::HapticTick& now) noexcept {
        const bool goOn = m_loop.tick(now);
        if (m_limits.live)
            m_limits.live->publish(m_loop.shown());
        if (!m_ending && wantsEnd(now)) {
            m_ending = true;
            if (m_limits.endIsMark && m_limits.device && m_limits.device->finished() && m_sink.phase() == core::TrialPhase::running)
                m_inputs.postOwn({core::CommandKind::mark, kMarkOfTraceEnd}); // a trace without a mark: its last position is the answer
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
