// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/reset_password_dialog.h"

#include "database/accounts/account_service.h"
#include "desktop/frame/app_context.h"
#include "desktop/people/password_choice.h"
#include "desktop/widgets/kit.h"

namespace chiron::desktop {

ResetPasswordDialog::ResetPasswordDialog(AppContext& context, database::Person person, QWidget* parent)
    : FormDialog(context, QStringLiteral("reset"),
                 tr("New password for %1").arg(QString::fromStdString(person.name)), parent),
      m_person(std::move(person)) {
    column()->addWidget(
        kit::label(theme(), tr("The current password stops working at once. Sessions and scores are kept."),
                   TextStyle::body, "muted"));
    m_password = new PasswordChoice(theme(), QStringLiteral("reset"));
    m_password->setLoginName(QString::fromStdString(m_person.name));
    column()->addWidget(m_password);
    setAccept(tr("Set the password"));
    setAcceptable(true);
    connect(m_password, &PasswordChoice::changed, this, [this] { setAcceptable(m_password->isGood()); });
}

void ResetPasswordDialog::submit() {
    setWorking(true);
    const std::string password = m_password->password();
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), id = m_person.id, password](WorkToken&) {
            return database::AccountService(*database).resetPassword(actor, id, password);
        },
        [this, password](core::Result<void> done) {
            setWorking(false);
            const QString name = QString::fromStdString(m_person.name);
            if (!done) {
                say("bad", tr("The password of %1 was not changed.\n%2").arg(name, inWords(done.error())));
                return;
            }
            emit changed();
            const QString words = tr("%1 has a new password.").arg(name);
            if (m_password->isGenerated()) {
                auto* handed = handedPassword(theme(), words, name, QString::fromStdString(password));
                showSecret(handed, handed->findChild<QPushButton*>(QStringLiteral("handed.copy")));
                return;
            }
            context().messages().done(words);
            accept();
        });
}

} // namespace chiron::desktop
