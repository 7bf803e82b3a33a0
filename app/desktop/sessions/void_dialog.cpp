// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/void_dialog.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QPlainTextEdit>

namespace chiron::desktop {

namespace {

/// The texts that differ between the two decisions.
struct VoidDialogWords {
    QString name; ///< object name prefix of the dialog's parts
    QString title, question, effect, example, keep, confirm;
    const char* kind; ///< of the confirming button
    const char* icon;
};

VoidDialogWords voidDialogWords(VoidSessionDialog::Decision decision) {
    if (decision == VoidSessionDialog::Decision::countAgain)
        return {QStringLiteral("reinstate"),
                VoidSessionDialog::tr("Count a session again"),
                VoidSessionDialog::tr("Count session %1 of %2 again?"),
                VoidSessionDialog::tr(
                    "The session counts as it did before it was voided: for passing its level and "
                    "in results. Both decisions are kept with it, each with a name, a time and a "
                    "reason."),
                VoidSessionDialog::tr("For example: another session was meant"),
                VoidSessionDialog::tr("Leave it void"),
                VoidSessionDialog::tr("Count it again"),
                "primary",
                "edit-undo"};
    return {QStringLiteral("void"),
            VoidSessionDialog::tr("Void a session"),
            VoidSessionDialog::tr("Void session %1 of %2?"),
            VoidSessionDialog::tr("Recording, scores and comments stay and can still be viewed. The session "
                                  "no longer counts for anything: neither for passing "
                                  "a level nor in anybody's results. Your name and the reason are stored "
                                  "with it. If it was a mistake, the session can be "
                                  "counted again, with a reason of its own."),
            VoidSessionDialog::tr("For example: the device was not calibrated"),
            VoidSessionDialog::tr("Keep it as it is"),
            VoidSessionDialog::tr("Void the session"),
            "danger",
            "dialog-cancel"};
}

} // namespace

VoidSessionDialog::VoidSessionDialog(const Theme& theme, qint64 session, const QString& person,
                                     const QString& what, QWidget* parent, Decision decision)
    : QDialog(parent) {
    const VoidDialogWords words = voidDialogWords(decision);
    setObjectName(words.name);
    setWindowTitle(words.title);
    setMinimumWidth(theme.px(440));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(20), theme.px(20), theme.px(20), theme.px(20));
    column->setSpacing(theme.px(12));
    column->addWidget(kit::label(theme, words.question.arg(session).arg(person), TextStyle::title));
    auto* which = kit::label(theme, what);
    which->setObjectName(words.name + QStringLiteral(".which"));
    column->addWidget(which);
    column->addWidget(kit::label(theme, words.effect));
    auto* label = kit::label(theme, tr("Reason (the trainee can read it)"), TextStyle::label);
    m_reason = new QPlainTextEdit;
    m_reason->setObjectName(words.name + QStringLiteral(".reason"));
    m_reason->setAccessibleName(label->text());
    m_reason->setPlaceholderText(words.example);
    m_reason->setTabChangesFocus(true);
    m_reason->setMinimumHeight(theme.px(88));
    label->setBuddy(m_reason);
    column->addWidget(label);
    column->addWidget(m_reason, 1);
    auto* row = new QHBoxLayout;
    row->addStretch();
    auto* keep = kit::button(theme, words.keep);
    keep->setObjectName(words.name + QStringLiteral(".cancel"));
    m_confirm = kit::button(theme, words.confirm, words.kind, QLatin1String(words.icon));
    m_confirm->setObjectName(words.name + QStringLiteral(".confirm"));
    m_confirm->setEnabled(false);
    row->addWidget(keep);
    row->addWidget(m_confirm);
    column->addLayout(row);
    connect(m_reason, &QPlainTextEdit::textChanged, this,
            [this] { m_confirm->setEnabled(!reason().isEmpty()); });
    connect(keep, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_confirm, &QPushButton::clicked, this, &QDialog::accept);
    m_reason->setFocus();
}

QString VoidSessionDialog::reason() const {
    return m_reason->toPlainText().trimmed();
}

} // namespace chiron::desktop
