// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/enter_key.h"

#include <QApplication>
#include <QKeyEvent>
#include <QPushButton>
#include <QToolButton>

namespace chiron::desktop {

namespace {

bool isPlainEnter(const QKeyEvent& key) {
    return (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter) &&
           (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
}

} // namespace

EnterKey::EnterKey(QObject* parent) : QObject(parent) {
    qApp->installEventFilter(this);
}

bool EnterKey::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    auto* button = qobject_cast<QAbstractButton*>(watched);
    if (!button || !isPlainEnter(key) || !button->hasFocus())
        return false;
    const bool pushes = qobject_cast<QPushButton*>(button) || qobject_cast<QToolButton*>(button);
    if (!pushes)
        return false;
    if (!key.isAutoRepeat()) // a held key presses only once
        button->click();
    return true;
}

} // namespace chiron::desktop
