// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/accounts/wait_countdown.h"

namespace chiron::desktop {

namespace {
constexpr int kLook_ms = 200;
}

WaitCountdown::WaitCountdown(QObject* parent) : QObject(parent) {
    m_timer.setInterval(kLook_ms);
    connect(&m_timer, &QTimer::timeout, this, &WaitCountdown::look);
}

void WaitCountdown::start(std::int64_t wait_ns) {
    if (wait_ns <= 0)
        return;
    m_deadline.setPreciseRemainingTime(0, wait_ns);
    m_shown = -1;
    m_timer.start();
    look();
}

void WaitCountdown::look() {
    if (m_deadline.hasExpired()) {
        m_timer.stop();
        emit finished();
        return;
    }
    const int seconds = static_cast<int>((m_deadline.remainingTime() + 999) / 1000);
    if (seconds != m_shown) {
        m_shown = seconds;
        emit changed(seconds);
    }
}

} // namespace chiron::desktop
