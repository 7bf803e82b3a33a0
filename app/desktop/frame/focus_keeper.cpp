// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/focus_keeper.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QFocusEvent>

namespace chiron::desktop {

namespace {

std::vector<QPointer<QWidget>> placesAround(const QWidget& control) {
    std::vector<QPointer<QWidget>> places;
    for (QWidget* each = control.parentWidget(); each && !each->isWindow(); each = each->parentWidget())
        places.emplace_back(each);
    return places;
}

} // namespace

FocusKeeper::FocusKeeper(QWidget& window) : QObject(&window), m_window(window) {
    connect(qApp, &QApplication::focusChanged, this, &FocusKeeper::moved);
    // A timer, because a widget that was put into a layout is shown by an event that waits in the queue.
    m_pageComes.setSingleShot(true);
    connect(&m_pageComes, &QTimer::timeout, this, &FocusKeeper::stayNear);
    window.installEventFilter(this);
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
    if (now && now->window() != &m_window)
        return;
    // A control that is being destroyed has not gone yet, so that stayNear() looks again.
    if (!now || (hasGoneWithItsPage() && movedByQt(before))) {
        m_goneFrom = m_around;
        m_fellTo = now;
        m_pageComes.start();
    }
    if (!now)
        return;
    m_seeks = false;
    m_last = now;
    m_around = placesAround(*now);
    now->installEventFilter(this); // the filter stays until the control is destroyed
    if (qobject_cast<QAbstractItemView*>(now))
        m_list = now;
}

bool FocusKeeper::eventFilter(QObject* watched, QEvent* event) {
    auto* control = static_cast<QWidget*>(watched);
    switch (event->type()) {
    case QEvent::WindowActivate:
        if (control == &m_window)
            comesBack();
        break;
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

/// A control that was hidden by itself is none: its page is still there.
bool FocusKeeper::hasGoneWithItsPage() const {
    return !m_around.empty() && (!m_last || (!m_last->isVisible() && !m_last->isHidden()));
}

/// Qt moves the focus on from a control that is hidden, and to the first control of a window that becomes
/// active while none of its controls can take the focus. Any other change is a person's, or the program's
/// own.
bool FocusKeeper::movedByQt(const QWidget* before) const {
    return m_seeks || (before && before == m_last && m_movedOn);
}

/// Comes before the focus does. A control that can take it was chosen while the window was not active.
void FocusKeeper::comesBack() {
    const QWidget* chosen = m_window.focusWidget();
    m_seeks = !chosen || !chosen->isVisible();
    QMetaObject::invokeMethod(
        this, [this] { m_seeks = false; }, Qt::QueuedConnection);
}

void FocusKeeper::stayNear() {
    const QWidget* at = QApplication::focusWidget();
    if (at != m_fellTo.data() || (!at && !hasGoneWithItsPage()) || QApplication::activeModalWidget() ||
        QApplication::activeWindow() != &m_window)
        return;
    for (const QPointer<QWidget>& place : m_goneFrom) {
        if (!canTake(place))
            continue;
        if (at && (place->isAncestorOf(at) || at->isAncestorOf(place)))
            return; // still there, or on no control of what is around it, where somebody put it
        QWidget* first = firstControlIn(*place);
        (first ? first : place.data())->setFocus(Qt::OtherFocusReason);
        return;
    }
}

/// In the order of Tab.
QWidget* FocusKeeper::firstControlIn(QWidget& place) const {
    for (QWidget* each = place.nextInFocusChain(); each != &place; each = each->nextInFocusChain())
        if (place.isAncestorOf(each) && canTake(each) && (each->focusPolicy() & Qt::TabFocus) == Qt::TabFocus)
            return each;
    return nullptr;
}

} // namespace chiron::desktop
