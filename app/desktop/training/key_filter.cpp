// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/key_filter.h"

#include <QAbstractButton>
#include <QApplication>
#include <QKeyEvent>
#include <QWidget>
#include <algorithm>

namespace chiron::desktop {

namespace {

bool isEnter(int key) {
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}
bool isTab(int key) {
    return key == Qt::Key_Tab || key == Qt::Key_Backtab;
}

} // namespace

KeyFilter::KeyFilter(QWidget& screen) : QObject(&screen), m_screen(screen) {}

KeyFilter::~KeyFilter() {
    setActive(false);
}

bool KeyFilter::isToolKey(int key) const {
    return std::find(m_toolKeys.begin(), m_toolKeys.end(), key) != m_toolKeys.end();
}

void KeyFilter::setActive(bool active) {
    if (m_active == active)
        return;
    m_active = active;
    if (active)
        qApp->installEventFilter(this);
    else
        qApp->removeEventFilter(this);
}

bool KeyFilter::elsewhere() const {
    if (QApplication::activeModalWidget() || QApplication::activePopupWidget())
        return true;
    const QWidget* focus = QApplication::focusWidget();
    return focus && (focus->window() != m_screen.window() || focus->testAttribute(Qt::WA_InputMethodEnabled));
}

bool KeyFilter::readsPanel(const QKeyEvent& event) const {
    return m_panelKeys && event.modifiers().testFlag(Qt::ControlModifier) &&
           event.type() != QEvent::KeyRelease &&
           (event.key() == Qt::Key_PageDown || event.key() == Qt::Key_PageUp);
}

bool KeyFilter::takes(const QKeyEvent& event, QObject* watched) const {
    const int key = event.key();
    if (key == Qt::Key_Escape)
        return !(m_held && elsewhere());
    if (elsewhere())
        return false;
    if (readsPanel(event))
        return true;
    // A tool key that is let go stops the tool, whatever else is held by then.
    const bool letGo = event.type() == QEvent::KeyRelease && isToolKey(key);
    if (!letGo && (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0)
        return false;
    if (isTab(key))
        return m_scene && watched == m_scene && !watched->isWidgetType();
    return key == Qt::Key_Space || key == Qt::Key_R || key == Qt::Key_F4 || key == Qt::Key_F5 ||
           (key == Qt::Key_F && m_depthOfFieldKey) || isEnter(key) || isToolKey(key);
}

bool KeyFilter::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    if (type != QEvent::KeyPress && type != QEvent::KeyRelease && type != QEvent::ShortcutOverride)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (!takes(key, watched))
        return false;
    if (type == QEvent::ShortcutOverride)
        event->accept(); // prevents shortcuts from taking it; the key press itself follows
    else if (!key.isAutoRepeat() && (type == QEvent::KeyPress || isToolKey(key.key())))
        act(key);
    return true;
}

void KeyFilter::act(const QKeyEvent& event) {
    const int key = event.key();
    if (readsPanel(event)) {
        emit panelAsked(key == Qt::Key_PageDown);
    } else if (isToolKey(key)) {
        emit toolKey(key, event.type() == QEvent::KeyPress);
    } else if (key == Qt::Key_Escape) {
        emit stopAsked();
    } else if ((key == Qt::Key_Space || isEnter(key)) && m_early && m_early()) {
        return;
    } else if (key == Qt::Key_Space) {
        emit pauseAsked();
    } else if (key == Qt::Key_R) {
        emit rearmAsked();
    } else if (key == Qt::Key_F4) {
        emit detailsAsked();
    } else if (key == Qt::Key_F5) {
        emit startAgainAsked();
    } else if (key == Qt::Key_F) {
        emit depthOfFieldAsked();
    } else if (isTab(key)) {
        emit leaveSceneAsked(key == Qt::Key_Tab);
    } else if (auto* button = qobject_cast<QAbstractButton*>(QApplication::focusWidget())) {
        button->click();
    } else {
        emit markAsked();
    }
}

} // namespace chiron::desktop
