// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/void_dialog.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QPlainTextEdit>

namespace chiron::desktop {

VoidDialog::VoidDialog(const Theme& theme, QWidget* parent) : QDialog(parent), m_reason(new QPlainTextEdit) {
    setObjectName(QStringLiteral("void_dialog"));
    setWindowTitle(tr("Declare this session void"));
    setMinimumWidth(theme.px(440));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(20), theme.px(20), theme.px(20), theme.px(20));
    column->setSpacing(theme.px(12));
    column->addWidget(kit::label(theme, tr("Declare this session void?"), TextStyle::title));
    column->addWidget(kit::label(theme, tr("Recording, scores and comments stay and can still be viewed. The session no longer counts for "
                                           "anything: no gate, no curve, no certificate. Your name and the reason are stored with it. This "
                                           "cannot be undone.")));
    auto* label = kit::label(theme, tr("Reason (the trainee can read it)"), TextStyle::label);
    label->setBuddy(m_reason);
    column->addWidget(label);
    m_reason->setObjectName(QStringLiteral("void.reason"));
    m_reason->setAccessibleName(tr("Reason (the trainee can read it)"));
    m_reason->setTabChangesFocus(true);
    m_reason->setFixedHeight(theme.px(88));
    column->addWidget(m_reason);
    auto* row = new QHBoxLayout;
    row->addStretch();
    auto* keep = kit::button(theme, tr("Keep it as it is"));
    keep->setObjectName(QStringLiteral("void.cancel"));
    auto* confirm = kit::button(theme, tr("Declare void"), "danger", QStringLiteral("dialog-cancel"));
    confirm->setObjectName(QStringLiteral("void.confirm"));
    confirm->setEnabled(false);
    row->addWidget(keep);
    row->addWidget(confirm);
    column->addLayout(row);
    connect(keep, &QPushButton::clicked, this, &QDialog::reject);
    connect(confirm, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_reason, &QPlainTextEdit::textChanged, this, [this, confirm] { confirm->setEnabled(!reason().isEmpty()); });
    m_reason->setFocus();
}

QString VoidDialog::reason() const {
    return m_reason->toPlainText().trimmed();
}

} // namespace chiron::desktop
