// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/still_wheel.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>

namespace chiron::desktop {

StillWheel::StillWheel(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool StillWheel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Wheel)
        return false;
    if (!qobject_cast<QComboBox*>(watched) && !qobject_cast<QAbstractSpinBox*>(watched))
        return false;
    event->ignore(); // so that it reaches the page
    return true;
}

} // namespace chiron::desktop
