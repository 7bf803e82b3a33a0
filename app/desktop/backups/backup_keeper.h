// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <chrono>
#include <functional>
#include <memory>

namespace chiron::desktop {

class AppContext;
class WorkToken;
struct Place;

/// Makes the daily backup automatically, off the GUI thread, once nobody has used the keyboard, pointer or
/// device for a while. It never runs while a training session or a study run is open: if one starts, a backup
/// in progress stops at once and leaves nothing behind. After a failure it informs administrators and tries
/// again, with a longer wait after each failure. It is an event filter on the application.
/// Thread: GUI.
class BackupKeeper final : public QObject {
    Q_OBJECT
public:
    static constexpr int kQuiet_ms = 5 * 60 * 1000;
    static constexpr int kLook_ms = 30 * 1000;

    BackupKeeper(AppContext& context, QObject* parent);

    void look(); ///< checks now instead of at the next half minute
    bool isRunning() const { return m_token != nullptr; }
    void setQuiet(int ms) { m_quiet_ms = ms; }
    /// Sets the function that gives the waiting time after a number of consecutive failures.
    void setWaits(std::function<std::chrono::milliseconds(int failures)> waits) {
        m_waits = std::move(waits);
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool mayBegin() const;
    void left(const Place& place);
    void stop();
    void failed(const QString& why);

    AppContext& m_context;
    QTimer m_timer;
    QElapsedTimer m_sinceTouch;
    QElapsedTimer m_sinceFailure; ///< monotonic, so that setting the clock does not matter
    int m_quiet_ms = kQuiet_ms;
    int m_failures = 0; ///< consecutive failures
    std::function<std::chrono::milliseconds(int)> m_waits;
    std::shared_ptr<WorkToken> m_token; ///< of the backup in progress
};

} // namespace chiron::desktop
