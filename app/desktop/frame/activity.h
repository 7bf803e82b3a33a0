// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>

namespace chiron::desktop {

/// Whether an event shows that somebody is using the computer: keyboard, pointer or touch.
inline bool isActivity(const QEvent& event) {
    switch (event.type()) {
    case QEvent::KeyPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::Wheel:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TabletMove:
    case QEvent::TabletPress:
        return true;
    default:
        return false;
    }
}

} // namespace chiron::desktop
