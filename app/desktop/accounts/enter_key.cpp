// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/accounts/enter_key.h"

#include <QKeyEvent>
#include <QPushButton>

namespace chiron::desktop::form {

namespace {

/// A button leaves Enter to its parents, up to the page.
class EnterKey final : public QObject {
public:
    explicit EnterKey(QWidget* page) : QObject(page), m_page(page) { page->installEventFilter(this); }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::KeyPress)
            return QObject::eventFilter(watched, event);
        const auto* key = static_cast<QKeyEvent*>(event);
        auto* button = qobject_cast<QPushButton*>(m_page->window()->focusWidget());
        const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
        if (!enter || !button || !button->isEnabled() || !m_page->isAncestorOf(button))
            return QObject::eventFilter(watched, event);
        if (!key->isAutoRepeat())
            button->click();
        return true;
    }

private:
    QWidget* m_page;
};

} // namespace

void pressFocusedByEnter(QWidget* page) {
    new EnterKey(page); // the page owns it
}

} // namespace chiron::desktop::form
