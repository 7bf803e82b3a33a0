// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/account/recovery_code_dialog.h"

#include "database/accounts/account_service.h"
#include "desktop/accounts/account_words.h"
#include "desktop/accounts/field_note.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/recovery_code_panel.h"
#include "desktop/accounts/wait_countdown.h"
#include "desktop/frame/app_context.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>

namespace chiron::desktop {

RecoveryCodeDialog::RecoveryCodeDialog(AppContext& context, bool hasOne, QWidget* parent)
    : FormDialog(context, QStringLiteral("recovery_code"), tr("Make a recovery code"), parent),
      m_hasOne(hasOne), m_wait(new WaitCountdown(this)) {
    column()->addWidget(kit::label(theme(), tr("With a recovery code you can set a new password yourself if "
                                               "you forget yours. It is shown once, to be written down.")));
    if (hasOne)
        column()->addWidget(kit::notice(
            theme(), "warning", tr("The recovery code that you have now will no longer be accepted.")));
    m_password = form::passwordField(theme(), column(), tr("Your own password"),
                                     QStringLiteral("recovery_code.password"));
    m_note = new FieldNote(theme(), *column(), *m_password);
    setAccept(tr("Make the code"));
    connect(m_wait, &WaitCountdown::changed, this, [this](int seconds) { setAccept(waitWords(seconds)); });
    connect(m_wait, &WaitCountdown::finished, this, [this] {
        setAccept(tr("Make the code"));
        renew();
    });
    connect(m_password, &QLineEdit::textChanged, this, &RecoveryCodeDialog::renew);
    m_password->setFocus();
}

void RecoveryCodeDialog::renew() {
    m_password->setEnabled(!m_wait->isRunning());
    setAcceptable(!m_wait->isRunning() && !m_password->text().isEmpty());
}

void RecoveryCodeDialog::submit() {
    setWorking(true);
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), password = m_password->text().toStdString()](WorkToken&) {
            return database::AccountService(*database).tryMakeRecoveryCode(actor, password);
        },
        [this](const tl::expected<std::string, database::Refusal>& code) { made(code); });
}

void RecoveryCodeDialog::made(const tl::expected<std::string, database::Refusal>& code) {
    setWorking(false);
    if (code) {
        emit changed();
        m_shown = new RecoveryCodePanel(
            theme(), QString::fromStdString(context().loginName()), QString::fromStdString(*code),
            m_hasOne ? RecoveryCodePanel::Backups::haveEarlierCode : RecoveryCodePanel::Backups::haveNoCode);
        connect(m_shown, &RecoveryCodePanel::finished, this, &QDialog::accept);
        showSecret(m_shown, m_shown->findChild<QPushButton*>(QStringLiteral("recovery.copy")));
        hideCancel(); // the panel's own button works only after the tick
        return;
    }
    if (code.error().kind == database::Refusal::Kind::wrong)
        m_note->say(wrongPasswordWords());
    else
        say(code.error().kind == database::Refusal::Kind::failed ? "bad" : "warning",
            tr("No recovery code was made.\n%1").arg(refusalWords(code.error())));
    m_wait->start(code.error().wait_ns);
    renew();
}

void RecoveryCodeDialog::reject() {
    if (m_shown && !m_shown->isConfirmed() && !m_warned) {
        m_warned = true;
        say("warning", tr("The recovery code is not shown again. Write it down and tick the box first. If "
                          "you close this window again, it is gone; you can then make a new one."));
        return;
    }
    FormDialog::reject();
}

} // namespace chiron::desktop
