// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/suggested_text.h"

#include <QFocusEvent>
#include <QLineEdit>

namespace chiron::desktop {

SuggestedText::SuggestedText(QLineEdit& field) : QObject(&field), m_field(field) {
    field.installEventFilter(this);
    connect(&field, &QLineEdit::textChanged, this, [this] { m_clicked = false; });
}

bool SuggestedText::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::FocusOut)
        m_clicked = false;
    if (m_field.isModified()) // somebody typed: it is no suggestion any more
        return false;
    if (event->type() == QEvent::FocusIn) {
        const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
        if (reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
            reason == Qt::ShortcutFocusReason || reason == Qt::OtherFocusReason)
            m_field.selectAll();
    } else if (event->type() == QEvent::MouseButtonRelease && !m_clicked) {
        m_clicked = true;
        if (!m_field.hasSelectedText()) // a part that was drawn over with the pointer stays selected
            m_field.selectAll();
    }
    return false;
}

} // namespace chiron::desktop
