// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/void_dialog.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QPlainTextEdit>

namespace chiron::desktop {

VoidSessionDialog::VoidSessionDialog(const Theme& theme, qint64 session, const QString& person, const QString& what, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("void"));
    setWindowTitle(tr("Void a session"));
    setMinimumWidth(theme.px(440));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(20), theme.px(20), theme.px(20), theme.px(20));
    column->setSpacing(theme.px(12));
    column->addWidget(kit::label(theme, tr("Void session %1 of %2?").arg(session).arg(person), TextStyle::title));
    auto* which = kit::label(theme, what);
    which->setObjectName(QStringLiteral("void.which"));
    column->addWidget(which);
    column->addWidget(kit::label(theme, tr("Recording, scores and comments stay and can still be viewed. The session no longer counts for "
                                           "anything: neither for passing a level nor in anybody's results. Your name and the reason are "
                                           "stored with it. This cannot be undone.")));
    auto* label = kit::label(theme, tr("Reason (the trainee can read it)"), TextStyle::label);
    m_reason = new QPlainTextEdit;
    m_reason->setObjectName(QStringLiteral("void.reason"));
    m_reason->setAccessibleName(label->text());
    m_reason->setPlaceholderText(tr("For example: the device was not calibrated"));
    m_reason->setTabChangesFocus(true);
    m_reason->setMinimumHeight(theme.px(88));
    label->setBuddy(m_reason);
    column->addWidget(label);
    column->addWidget(m_reason, 1);
    auto* row = new QHBoxLayout;
    row->addStretch();
    auto* keep = kit::button(theme, tr("Keep it as it is"));
    keep->setObjectName(QStringLiteral("void.cancel"));
    m_confirm = kit::button(theme, tr("Void the session"), "danger", QStringLiteral("dialog-cancel"));
    m_confirm->setObjectName(QStringLiteral("void.confirm"));
    m_confirm->setEnabled(false);
    row->addWidget(keep);
    row->addWidget(m_confirm);
    column->addLayout(row);
    connect(m_reason, &QPlainTextEdit::textChanged, this, [this] { m_confirm->setEnabled(!reason().isEmpty()); });
    connect(keep, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_confirm, &QPushButton::clicked, this, &QDialog::accept);
    m_reason->setFocus();
}

QString VoidSessionDialog::reason() const {
    return m_reason->toPlainText().trimmed();
}

} // namespace chiron::desktop
