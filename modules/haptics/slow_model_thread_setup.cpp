// SPDX-License-Identifier: GPL-3.0-or-later
// The thread of the slow model; the tick calls nothing here.
#include "haptics/slow_model_thread.h"

#include "core/fp_environment.h"

namespace chiron::haptics {

SlowModelThread::SlowModelThread(simulation::ISlowModel& model)
    : m_model(model), m_thread([this] { run(); }) {}

SlowModelThread::~SlowModelThread() {
    stop();
}

void SlowModelThread::stop() {
    m_stop.store(true, std::memory_order_release);
    if (m_thread.joinable())
        m_thread.join();
}

void SlowModelThread::run() noexcept {
    core::setModelFloatingPointEnvironment();
    while (!m_stop.load(std::memory_order_acquire)) {
        if (m_model.step())
            m_answered.fetch_add(1, std::memory_order_relaxed);
        else
            std::this_thread::sleep_for(kLook);
    }
}

} // namespace chiron::haptics
