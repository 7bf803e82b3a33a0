// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/live_training.h"

#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

namespace chiron::desktop {

/// The screen's side of a running session. 60 times per second it sends the window's heartbeat, takes the
/// newest state and every sample since the previous frame, and emits frame(). Destroying it ends the session
/// and waits until it is stored.
/// Thread: GUI.
class LiveFeed final : public QObject {
    Q_OBJECT
public:
    static constexpr int kFrame_ms = 16;

    /// Starts a session.
    /// Errors: as for LiveTraining::start().
    static core::Result<std::unique_ptr<LiveFeed>>
    start(database::Database& database, const database::Actor& actor, session::TrainingRequest request);
    ~LiveFeed() override;

    session::LiveTraining& training() noexcept { return *m_training; }
    const haptics::DisplayState& state() const noexcept { return m_state; }
    /// Since the previous frame.
    const std::vector<session::LiveSample>& samples() const noexcept { return m_samples; }
    std::uint32_t contacts() const noexcept { return m_contacts; } ///< contacts begun so far
    /// Seconds since the first trial, without pauses.
    double worked_s() const noexcept { return 1e-3 * static_cast<double>(m_worked_ms); }

signals:
    void frame();    ///< state() and samples() are new
    void finished(); ///< training().result() is available

private:
    LiveFeed() = default;
    void tick();

    haptics::DisplayState m_state;
    std::vector<session::LiveSample> m_samples;
    std::uint32_t m_contacts = 0;
    std::int64_t m_worked_ms = 0;
    QTimer m_timer;
    /// Declared last, because its thread posts to this object.
    std::unique_ptr<session::LiveTraining> m_training;
};

} // namespace chiron::desktop
