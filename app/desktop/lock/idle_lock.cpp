// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/lock/idle_lock.h"

#include "desktop/frame/activity.h"

#include <QCoreApplication>
#include <QEvent>

namespace chiron::desktop {

IdleLock::IdleLock(int idle_ms, QObject* parent) : QObject(parent), m_idle_ms(idle_ms) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &IdleLock::look);
    QCoreApplication::instance()->installEventFilter(this);
}

void IdleLock::touch() {
    // The timer checks this when it expires, which avoids restarting a timer a thousand times per second.
    m_sinceTouch.start();
}

void IdleLock::setHeld(bool held) {
    m_held = held;
    restart();
}

void IdleLock::setActive(bool active) {
    m_active = active;
    restart();
}

void IdleLock::setIdle(int idle_ms) {
    m_idle_ms = idle_ms;
    restart();
}

void IdleLock::restart() {
    m_timer.stop();
    m_sinceTouch.start();
    if (isAwake())
        m_timer.start(m_idle_ms);
}

void IdleLock::look() {
    const qint64 left = m_idle_ms - m_sinceTouch.elapsed();
    if (left > 0) {
        m_timer.start(static_cast<int>(left));
        return;
    }
    emit idle();
}

bool IdleLock::eventFilter(QObject* watched, QEvent* event) {
    if (isActivity(*event))
        touch();
    return QObject::eventFilter(watched, event);
}

} // namespace chiron::desktop
