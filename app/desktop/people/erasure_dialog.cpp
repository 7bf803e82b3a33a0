// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/erasure_dialog.h"

#include "desktop/accounts/account_words.h"
#include "desktop/accounts/field_note.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/wait_countdown.h"
#include "desktop/frame/app_context.h"

#include <QLineEdit>
#include <optional>

namespace chiron::desktop {

namespace {

/// Either the refusal of the administrator's login, or the result of the erasure.
struct Outcome {
    std::optional<database::Refusal> refusal;
    core::Result<void> done;
};

} // namespace

ErasureDialog::ErasureDialog(AppContext& context, const QString& objectName, const QString& title,
                             QWidget* parent)
    : FormDialog(context, objectName, title, parent), m_wait(new WaitCountdown(this)) {}

QLineEdit* ErasureDialog::addReason() {
    m_reason =
        form::textField(theme(), column(), tr("Reason (kept)"), objectName() + QStringLiteral(".reason"));
    connect(m_reason, &QLineEdit::textChanged, this, &ErasureDialog::renew);
    return m_reason;
}

void ErasureDialog::addPassword() {
    m_password = form::passwordField(theme(), column(), tr("Your own password"),
                                     objectName() + QStringLiteral(".password"));
    m_passwordNote = new FieldNote(theme(), *column(), *m_password);
    setAccept(tr("Erase permanently"), "danger");
    connect(m_wait, &WaitCountdown::changed, this,
            [this](int seconds) { setAccept(waitWords(seconds), "danger"); });
    connect(m_wait, &WaitCountdown::finished, this, [this] {
        setAccept(tr("Erase permanently"), "danger");
        renew();
    });
    connect(m_password, &QLineEdit::textChanged, this, &ErasureDialog::renew);
    renew();
}

void ErasureDialog::renew() {
    if (!m_password)
        return; // still being built
    m_password->setEnabled(!m_wait->isRunning());
    setAcceptable(!m_wait->isRunning() && isChosen() && !m_reason->text().trimmed().isEmpty() &&
                  !m_password->text().isEmpty());
}

void ErasureDialog::submit() {
    setWorking(true);
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), erase = erasure(), password = m_password->text().toStdString(),
         reason = m_reason->text().trimmed().toStdString()](WorkToken&) {
            database::AccountService accounts(*database);
            if (const auto confirmed = accounts.tryConfirm(actor, password); !confirmed)
                return Outcome{confirmed.error(), {}};
            return Outcome{std::nullopt, erase(accounts, actor, password, reason)};
        },
        [this](Outcome outcome) { outcome.refusal ? refused(*outcome.refusal) : finished(outcome.done); });
}

void ErasureDialog::refused(const database::Refusal& refusal) {
    setWorking(false);
    m_password->clear();
    const bool wrong = refusal.kind == database::Refusal::Kind::wrong;
    say("warning",
        wrong ? tr("Nobody was erased.") : tr("Nobody was erased.\n%1").arg(refusalWords(refusal)));
    if (wrong)
        m_passwordNote->say(wrongPasswordWords());
    m_wait->start(refusal.wait_ns);
    renew();
}

void ErasureDialog::finished(const core::Result<void>& done) {
    setWorking(false);
    if (done) {
        emit changed();
        context().messages().done(doneWords());
        accept();
    } else if (done.error().code == core::ErrorCode::wrongUse) {
        say("bad", cannotWords());
    } else if (done.error().code == core::ErrorCode::storage) {
        emit changed(); // the list shows how far the erasure got
        say("bad", tr("The erasure of %1 is not complete: the file may still contain old copies. Press the "
                      "button again to continue where "
                      "it stopped.\n%2")
                       .arg(whom(), inWords(done.error())));
    } else {
        say("bad", tr("%1 was not erased.\n%2").arg(whom(), inWords(done.error())));
    }
}

} // namespace chiron::desktop
