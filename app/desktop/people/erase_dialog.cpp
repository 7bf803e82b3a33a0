// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/erase_dialog.h"

#include "desktop/accounts/form.h"
#include "desktop/frame/app_context.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QLineEdit>

namespace chiron::desktop {

EraseDialog::EraseDialog(AppContext& context, database::Person person, QWidget* parent)
    : ErasureDialog(context, QStringLiteral("erase"), tr("Erase %1").arg(QString::fromStdString(person.name)),
                    parent),
      m_person(std::move(person)) {
    column()->addWidget(
        kit::notice(theme(), "bad",
                    tr("This cannot be undone. Disabling the account keeps everything and can be undone.")));
    auto* which =
        kit::label(theme(),
                   tr("This erases an account, and the identity of the person in studies whose key "
                      "table lists the account. A participant who is known only by a code is erased "
                      "with \"Erase a participant\"."),
                   TextStyle::body, "muted");
    which->setObjectName(QStringLiteral("erase.which"));
    column()->addWidget(which);
    column()->addWidget(
        kit::label(theme(), tr("Overwritten: name, code, password, comments and reasons in free text."),
                   TextStyle::body));
    column()->addWidget(kit::label(
        theme(),
        tr("Kept without a name: sessions, scores, and a note of when and why the person was erased. "
           "Earlier backups still contain the person until they are deleted; restoring one erases the "
           "person again."),
        TextStyle::body));
    QLineEdit* reason = addReason();
    m_withdraw = new QCheckBox(tr("Consent is withdrawn: overwrite the recordings too"));
    m_withdraw->setObjectName(QStringLiteral("erase.withdraw"));
    column()->addWidget(m_withdraw);
    m_typedName = form::textField(theme(), column(), tr("Type the login name to confirm: %1").arg(whom()),
                                  QStringLiteral("erase.name"));
    connect(m_typedName, &QLineEdit::textChanged, this, &EraseDialog::renew);
    addPassword();
    reason->setFocus();
}

bool EraseDialog::isChosen() const {
    return m_typedName->text() == whom();
}

ErasureDialog::Erasure EraseDialog::erasure() const {
    return [id = m_person.id, withdraw = m_withdraw->isChecked()](
               database::AccountService& accounts, const database::Actor& actor, const std::string& password,
               const std::string& reason) {
        return accounts.erasePerson(actor, password, id, reason, withdraw);
    };
}

QString EraseDialog::doneWords() const {
    return tr("%1 was erased. Sessions and scores are kept without a name.").arg(whom());
}

QString EraseDialog::cannotWords() const {
    return tr("%1 cannot be erased now. You cannot erase yourself, and no session may be running.")
        .arg(whom());
}

} // namespace chiron::desktop
