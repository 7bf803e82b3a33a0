// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/accounts/field_note.h"

#include "desktop/accounts/form.h"
#include "desktop/widgets/kit.h"

#include <QAccessible>
#include <QLineEdit>

namespace chiron::desktop {

FieldNote::FieldNote(const Theme& theme, QVBoxLayout& layout, QLineEdit& field)
    : QObject(&field), m_field(field), m_label(kit::label(theme, {}, TextStyle::small, "bad")) {
    m_label->setObjectName(field.objectName() + QStringLiteral(".note"));
    layout.addWidget(m_label);
    m_label->hide();
    connect(&field, &QLineEdit::textChanged, this, &FieldNote::clear);
}

void FieldNote::say(const QString& text) {
    form::setKind(&m_field, "bad");
    m_label->setText(text);
    m_label->setAccessibleName(text);
    m_label->show();
    m_field.setAccessibleDescription(text);
    m_field.selectAll();
    m_field.setFocus();
    QAccessibleEvent event(m_label, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

void FieldNote::clear() {
    if (m_label->isHidden())
        return;
    form::setKind(&m_field, "");
    m_field.setAccessibleDescription({});
    m_label->hide();
}

} // namespace chiron::desktop
