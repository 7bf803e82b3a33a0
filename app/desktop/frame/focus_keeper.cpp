// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/focus_keeper.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QFocusEvent>

namespace chiron::desktop {

FocusKeeper::FocusKeeper(QWidget& window) : QObject(&window), m_window(window) {
    connect(qApp, &QApplication::focusChanged, this, &FocusKeeper::moved);
}

bool FocusKeeper::canTake(const QWidget* control) const {
    return control && control->window() == &m_window && control->isVisible() && control->isEnabled();
}

void FocusKeeper::moved(QWidget* before, QWidget* now) {
    if (now && now != m_place)
        m_waiting = nullptr; // the person moved it elsewhere
    m_before = before;
    m_place = now;
    m_justMoved = true;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_justMoved = false;
            m_hidden = nullptr;
        },
        Qt::QueuedConnection);
    if (before && before == m_hidden)
        lost(before);
    if (!now || now->window() != &m_window)
        return;
    now->installEventFilter(this); // the filter stays until the control is destroyed
    if (qobject_cast<QAbstractItemView*>(now))
        m_list = now;
}

bool FocusKeeper::eventFilter(QObject* watched, QEvent* event) {
    auto* control = static_cast<QWidget*>(watched);
    switch (event->type()) {
    case QEvent::FocusOut:
        m_movedOn = static_cast<QFocusEvent*>(event)->reason() == Qt::TabFocusReason;
        break;
    case QEvent::EnabledChange:
    case QEvent::Hide:
    case QEvent::Show:
        if (canTake(control) && control == m_waiting)
            // Deferred until the other controls are in their final state.
            QMetaObject::invokeMethod(this, &FocusKeeper::giveBack, Qt::QueuedConnection);
        else if (!canTake(control) && control == QApplication::focusWidget())
            m_hidden = control;
        else if (!canTake(control) && control == m_before && m_justMoved && (m_movedOn || !m_place))
            lost(control);
        break;
    default:
        break;
    }
    return false;
}

void FocusKeeper::lost(QWidget* control) {
    m_justMoved = false;
    m_waiting = m_list && m_list != control ? m_list : QPointer<QWidget>(control);
    QMetaObject::invokeMethod(this, &FocusKeeper::giveBack, Qt::QueuedConnection);
}

void FocusKeeper::giveBack() {
    if (!m_waiting || !canTake(m_waiting) || QApplication::activeModalWidget() ||
        QApplication::focusWidget() != m_place)
        return;
    QWidget* const control = m_waiting;
    m_waiting = nullptr;
    control->setFocus(Qt::OtherFocusReason);
}

} // namespace chiron::desktop
