// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace chiron::desktop {

/// Notices that nobody has touched key, pointer or device for a while. An event filter on the application; devices call
/// touch(). Asleep while held (a trial runs) or while nobody is logged in; then the whole time counts again. GUI thread.
class IdleLock : public QObject {
    Q_OBJECT
public:
    static constexpr int kIdle_ms = 10 * 60 * 1000; ///< data.md, Time

    explicit IdleLock(int idle_ms = kIdle_ms, QObject* parent = nullptr);

    void touch();              ///< somebody is there
    void setHeld(bool held);   ///< a trial runs: never idle
    void setActive(bool active); ///< somebody is logged in
    void setIdle(int idle_ms);   ///< how long is too long

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
