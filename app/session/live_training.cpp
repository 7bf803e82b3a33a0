// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/live_training.h"

#include "core/clock.h"

#include <algorithm>

namespace chiron::session {

core::Result<std::unique_ptr<LiveTraining>> LiveTraining::start(database::Database& database,
                                                                const database::Actor& actor,
                                                                TrainingRequest request,
                                                                std::function<void()> onFinished) {
    if (!database.isWritable())
        return core::fail(core::ErrorCode::wrongUse,
                          database.file() + ": opened read-only, nothing can be recorded");
    if (request.station.tools.empty())
        return core::fail(core::ErrorCode::wrongUse, "a session needs a device");
    return std::unique_ptr<LiveTraining>(
        new LiveTraining(database, actor, std::move(request), std::move(onFinished)));
}

LiveTraining::LiveTraining(database::Database& database, const database::Actor& actor,
                           TrainingRequest request, std::function<void()> onFinished)
    : m_database(database), m_actor(actor), m_request(std::move(request)),
      m_onFinished(std::move(onFinished)),
      m_result(core::fail(core::ErrorCode::wrongUse, "the session has not ended yet")) {
    m_felt = m_request.station.felt();
    m_request.realtime = true;
    m_request.live = &m_link;
    m_request.cancel = &m_cancel;
    m_thread = std::thread([this] { run(); });
}

LiveTraining::~LiveTraining() {
    requestStop();
    m_thread.join();
}

void LiveTraining::run() {
    m_result = runTrainingOn(m_database, m_actor, m_request);
    m_finished.store(true, std::memory_order_release);
    if (m_onFinished)
        m_onFinished();
}

void LiveTraining::beat() noexcept {
    m_link.inputs().beat(core::monotonicNow_ns());
}

} // namespace chiron::session
