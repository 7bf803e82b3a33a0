// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDeadlineTimer>
#include <QObject>
#include <QTimer>
#include <cstdint>

namespace chiron::desktop {

/// Counts down the seconds that an account has to wait after wrong passwords. The data layer enforces the
/// wait; this class only makes it visible.
/// Thread: GUI.
class WaitCountdown : public QObject {
    Q_OBJECT
public:
    explicit WaitCountdown(QObject* parent = nullptr);
    void start(std::int64_t wait_ns); ///< does nothing if `wait_ns` is 0
    bool isRunning() const { return m_timer.isActive(); }

signals:
    void changed(int seconds); ///< whole seconds left; the first signal comes from start()
    void finished();

private:
    void look();

    QTimer m_timer;
    QDeadlineTimer m_deadline;
    int m_shown = -1;
};

} // namespace chiron::desktop
