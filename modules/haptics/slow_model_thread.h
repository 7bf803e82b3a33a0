// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/slow_model.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace chiron::haptics {

/// Steps a scene's slow model on a thread of its own while a session runs in real time
/// (architecture.md, Threads). The thread sets the models' floating-point environment, looks for a request
/// every 2 ms (an answer takes effect 33 ticks after its request) and answers it. It requests no priority, so
/// that it never delays a tick. From construction to stop() nothing else may step the model, which must
/// outlive this object.
/// Thread: construction and stop() on one thread; stop() waits for the step in progress.
class SlowModelThread {
public:
    static constexpr std::chrono::microseconds kLook{2000};

    explicit SlowModelThread(simulation::ISlowModel& model);
    SlowModelThread(const SlowModelThread&) = delete;
    SlowModelThread& operator=(const SlowModelThread&) = delete;
    ~SlowModelThread(); ///< stops it

    void stop();
    /// Requests answered so far; any thread.
    std::uint64_t answered() const noexcept { return m_answered.load(std::memory_order_relaxed); }

private:
    void run() noexcept;

    simulation::ISlowModel& m_model;
    std::atomic<bool> m_stop{false};
    std::atomic<std::uint64_t> m_answered{0};
    std::thread m_thread; // last: it uses the rest
};

} // namespace chiron::haptics
