// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDeadlineTimer>
#include <QObject>
#include <QTimer>
#include <cstdint>

namespace chiron::desktop {

/// Counts the seconds that an account has to wait after wrong passwords. The data layer keeps the wait; this only shows
/// it, so that nobody has to guess. GUI thread.
class WaitCountdown : public QObject {
    Q_OBJECT
public:
    explicit WaitCountdown(QObject* parent = nullptr);
    void start(std::int64_t wait_ns); ///< 0: nothing happens
    bool isRunning() const { return m_timer.isActive(); }

signals:
    void changed(int seconds); ///< whole seconds that are left, from the first on
    void finished();

private:
    void look();

    QTimer m_timer;
    QDeadlineTimer m_deadline;
    int m_shown = -1;
};

} // namespace chiron::desktop
