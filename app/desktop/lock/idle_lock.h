// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace chiron::desktop {

/// Emits idle() when nobody has used keyboard, pointer or device for a while. It is an event filter on the
/// application; devices call touch(). It does not run while held (a trial runs) or while nobody is logged in;
/// afterwards the full time counts from the start.
/// Thread: GUI.
class IdleLock : public QObject {
    Q_OBJECT
public:
    static constexpr int kIdle_ms = 10 * 60 * 1000; ///< data.md, Time

    explicit IdleLock(int idle_ms = kIdle_ms, QObject* parent = nullptr);

    void touch();                ///< reports that somebody is there
    void setHeld(bool held);     ///< true while a trial runs: never idle
    void setActive(bool active); ///< true while somebody is logged in
    void setIdle(int idle_ms);   ///< sets the idle time

signals:
    void idle();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isAwake() const { return m_active && !m_held; }
    void restart();
    void look();

    int m_idle_ms;
    QTimer m_timer;
    QElapsedTimer m_sinceTouch;
    bool m_held = false;
    bool m_active = false;
};

} // namespace chiron::desktop
