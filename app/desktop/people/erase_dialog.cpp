// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/erase_dialog.h"

#include "database/accounts/account_service.h"
#include "desktop/accounts/account_words.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/wait_countdown.h"
#include "desktop/frame/app_context.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QLineEdit>
#include <optional>

namespace chiron::desktop {

namespace {

/// Either the administrator was not let in, or the erasure went so.
struct Outcome {
    std::optional<database::Refusal> refusal;
    core::Result<void> done;
};

} // namespace

EraseDialog::EraseDialog(AppContext& context, database::Person person, QWidget* parent)
    : FormDialog(context, QStringLiteral("erase"), tr("Erase %1").arg(QString::fromStdString(person.name)), parent),
      m_person(std::move(person)) {
    const QString name = QString::fromStdString(m_person.name);
    column()->addWidget(kit::notice(theme(), "bad", tr("This cannot be undone. Disabling the account keeps everything and can be undone.")));
    column()->addWidget(kit::label(theme(), tr("Overwritten: name, code, password, comments and reasons in free text."), TextStyle::body));
    column()->addWidget(kit::label(theme(), tr("Kept without a name: sessions, scores, and a note of when and why the person was erased. "
                                               "Earlier backups still contain the person until they are deleted; restoring one erases the "
                                               "person again."),
                                   TextStyle::body));
    m_reason = form::textField(theme(), column(), tr("Reason (kept)"), QStringLiteral("erase.reason"));
    m_withdraw = new QCheckBox(tr("Consent is withdrawn: overwrite the recordings too"));
    m_withdraw->setObjectName(QStringLiteral("erase.withdraw"));
    column()->addWidget(m_withdraw);
    m_typedName = form::textField(theme(), column(), tr("Type the login name to confirm: %1").arg(name), QStringLiteral("erase.name"));
    m_password = form::passwordField(theme(), column(), tr("Your own password"), QStringLiteral("erase.password"));
    setAccept(tr("Erase permanently"), "danger");
    m_wait = new WaitCountdown(this);
    connect(m_wait, &WaitCountdown::changed, this, [this](int seconds) { setAccept(waitWords(seconds), "danger"); });
    connect(m_wait, &WaitCountdown::finished, this, [this] {
        setAccept(tr("Erase permanently"), "danger");
        renew();
    });
    for (QLineEdit* field : {m_reason, m_typedName, m_password})
        connect(field, &QLineEdit::textChanged, this, &EraseDialog::renew);
    m_reason->setFocus();
}

void EraseDialog::renew() {
    m_password->setEnabled(!m_wait->isRunning());
    setAcceptable(!m_wait->isRunning() && !m_reason->text().trimmed().isEmpty() &&
                  m_typedName->text() == QString::fromStdString(m_person.name) && !m_password->text().isEmpty());
}

void EraseDialog::submit() {
    setWorking(true);
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), id = m_person.id, password = m_password->text().toStdString(),
         reason = m_reason->text().trimmed().toStdString(), withdraw = m_withdraw->isChecked()](WorkToken&) {
            database::AccountService accounts(*database);
            if (const auto confirmed = accounts.tryConfirm(actor, password); !confirmed)
                return Outcome{confirmed.error(), {}};
            return Outcome{std::nullopt, accounts.erasePerson(actor, password, id, reason, withdraw)};
        },
        [this](Outcome outcome) { outcome.refusal ? refused(*outcome.refusal) : finished(outcome.done); });
}

void EraseDialog::refused(const database::Refusal& refusal) {
    setWorking(false);
    m_password->clear();
    say("warning", tr("Wrong password. Nobody was erased.\n%1").arg(refusalWords(refusal)));
    m_wait->start(refusal.wait_ns);
    renew();
}

void EraseDialog::finished(const core::Result<void>& done) {
    setWorking(false);
    const QString name = QString::fromStdString(m_person.name);
    if (done) {
        emit changed();
        context().messages().done(tr("%1 was erased. Sessions and scores are kept without a name.").arg(name));
        accept();
        return;
    }
    if (done.error().code == core::ErrorCode::wrongUse) {
        say("bad", tr("%1 cannot be erased now. You cannot erase yourself, and no session may be running.").arg(name));
    } else if (done.error().code == core::ErrorCode::storage) {
        emit changed(); // the list shows how far it came
        say("bad", tr("The erasure of %1 is not complete: the file may still contain old copies. Press the button again to continue where "
                      "it stopped.\n%2")
                       .arg(name, inWords(done.error())));
    } else {
        say("bad", tr("%1 was not erased.\n%2").arg(name, inWords(done.error())));
    }
}

} // namespace chiron::desktop
