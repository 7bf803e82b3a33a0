// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/live_training.h"

#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

namespace chiron::desktop {

/// A session on the screen's side: 60 times a second it says that the window is alive, takes the newest state and every
/// sample since the last time, and tells. GUI thread. Destroying it ends the session and waits until it is stored.
class LiveFeed final : public QObject {
    Q_OBJECT
public:
    static constexpr int kFrame_ms = 16;

    /// Failure: as LiveTraining::start.
    static core::Result<std::unique_ptr<LiveFeed>> start(database::Database& database, const database::Actor& actor,
                                                         session::TrainingRequest request);
    ~LiveFeed() override;

    session::LiveTraining& training() noexcept { return *m_training; }
    const haptics::DisplayState& state() const noexcept { return m_state; }
    const std::vector<session::LiveSample>& samples() const noexcept { return m_samples; } ///< since the frame before
    std::uint32_t contacts() const noexcept { return m_contacts; } ///< begun so far
    double worked_s() const noexcept { return 1e-3 * static_cast<double>(m_worked_ms); } ///< since the first trial, pauses left out

signals:
    void frame();    ///< state() and samples() are new
    void finished(); ///< training().result() is there

private:
    LiveFeed() = default;
    void tick();

    haptics::DisplayState m_state;
    std::vector<session::LiveSample> m_samples;
    std::uint32_t m_contacts = 0;
    std::int64_t m_worked_ms = 0;
    QTimer m_timer;
    std::unique_ptr<session::LiveTraining> m_training; ///< last: its thread posts to this
};

} // namespace chiron::desktop
