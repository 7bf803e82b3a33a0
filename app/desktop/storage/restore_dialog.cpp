// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/restore_dialog.h"

#include "database/accounts/account_service.h"
#include "desktop/accounts/account_words.h"
#include "desktop/accounts/field_note.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/wait_countdown.h"
#include "desktop/frame/app_context.h"
#include "desktop/sessions/session_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/suggested_text.h"
#include "session/backup_list.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>

namespace chiron::desktop {

namespace {

using By = database::RestoreRefusal::By;

QString whatHappens(RestoreDialog::Replaces replaces) {
    switch (replaces) {
    case RestoreDialog::Replaces::working:
        return RestoreDialog::tr(
            "Everything recorded after this backup is removed from view. The current database is kept as a "
            "copy; "
            "nothing is deleted. People who were erased stay erased. Everybody is logged out.");
    case RestoreDialog::Replaces::damaged:
        return RestoreDialog::tr(
            "The site becomes what it was when this backup was made. The damaged file is kept as a copy; "
            "nothing is "
            "deleted. People who were erased stay erased. An administrator of the backup has to agree.");
    case RestoreDialog::Replaces::missing:
        return RestoreDialog::tr(
            "The site becomes what it was when this backup was made. People who were erased stay erased. An "
            "administrator of the backup has to agree.");
    }
    return {};
}

QString accountsOfTheBackup() {
    return RestoreDialog::tr("A backup keeps the login names and passwords of the day it was made. If yours "
                             "have been changed since, enter the earlier ones.");
}

QString accountsOfTheDamagedFile() {
    return RestoreDialog::tr("The damaged file still has the login names and passwords of its last day. "
                             "Where they can be read, one of its administrators has to agree, so that "
                             "nobody puts an old backup in its place without permission.");
}

/// Checks the passwords. If the site is open, a wrong password counts like one at the login.
std::optional<database::RestoreRefusal> refusalOf(database::Database* open,
                                                  const database::RestoreRequest& request,
                                                  const database::DatabaseOptions& options) {
    if (open) {
        const bool same = request.presentName.empty();
        const auto present = database::AccountService(*open).tryLogin(
            same ? request.name : request.presentName, same ? request.password : request.presentPassword);
        if (!present)
            return database::RestoreRefusal{By::present, present.error()};
    }
    return database::restoreRefusal(request, options);
}

} // namespace

RestoreDialog::RestoreDialog(AppContext& context, const session::BackupEntry& backup, Replaces replaces,
                             QWidget* parent, std::function<void(database::RestoreRequest)> restore)
    : FormDialog(context, QStringLiteral("restore"), tr("Restore a backup"), parent), m_replaces(replaces),
      m_folder(backup.folder),
      m_administrator(replaces == Replaces::working ? QString::fromStdString(context.loginName())
                                                    : QString()),
      m_restore(std::move(restore)), m_wait(new WaitCountdown(this)) {
    const bool working = replaces == Replaces::working;
    const QString when = SessionWords::ago(SessionWords::timeOf(backup.createdUtc),
                                           QDateTime::currentDateTimeUtc(), context.locale());
    column()->addWidget(
        kit::label(theme(), tr("Go back to the backup made %1?").arg(when), TextStyle::title));
    column()->addWidget(kit::label(theme(), whatHappens(replaces)));
    m_first = addPair(*column(), QStringLiteral("restore."),
                      working ? tr("Administrator") : tr("Your login name when this backup was made"),
                      working ? tr("Password") : tr("Your password when this backup was made"));
    if (!working)
        column()->addWidget(explanation(QStringLiteral("restore.explanation"), accountsOfTheBackup()));
    new SuggestedText(*m_first.name);
    m_first.name->setText(m_administrator);
    addOther(*column());
    setAccept(acceptText(), "danger");
    setCancel(working ? tr("Keep the current database") : tr("Cancel"));
    connect(m_wait, &WaitCountdown::changed, this,
            [this](int seconds) { setAccept(waitWords(seconds), "danger"); });
    connect(m_wait, &WaitCountdown::finished, this, [this] {
        setAccept(acceptText(), "danger");
        check();
    });
    check();
    (m_administrator.isEmpty() ? m_first.name : m_first.password)->setFocus();
}

RestoreDialog::Pair RestoreDialog::addPair(QVBoxLayout& column, const QString& names, const QString& name,
                                           const QString& password) {
    Pair pair;
    pair.name = form::textField(theme(), &column, name, names + QStringLiteral("name"));
    pair.password = form::passwordField(theme(), &column, password, names + QStringLiteral("password"));
    pair.note = new FieldNote(theme(), column, *pair.password);
    for (QLineEdit* field : {pair.name, pair.password})
        connect(field, &QLineEdit::textChanged, this, &RestoreDialog::check);
    return pair;
}

void RestoreDialog::addOther(QVBoxLayout& column) {
    const bool working = m_replaces == Replaces::working;
    m_other = new QCheckBox(working ? tr("The backup has a different administrator or password")
                                    : tr("The damaged file has a different administrator or password"));
    m_other->setObjectName(QStringLiteral("restore.other"));
    m_other->setVisible(m_replaces != Replaces::missing);
    column.addWidget(m_other);
    if (m_replaces == Replaces::damaged)
        column.addWidget(explanation(QStringLiteral("restore.why_other"), accountsOfTheDamagedFile()));
    m_otherBox = new QWidget;
    auto* inner = new QVBoxLayout(m_otherBox);
    inner->setContentsMargins(theme().px(26), 0, 0, 0);
    inner->setSpacing(theme().px(12));
    m_second = addPair(
        *inner, QStringLiteral("restore.other_"),
        working ? tr("Your login name when this backup was made") : tr("Administrator in the damaged file"),
        working ? tr("Your password when this backup was made") : tr("Password in the damaged file"));
    if (working)
        inner->addWidget(explanation(QStringLiteral("restore.other_explanation"), accountsOfTheBackup()));
    m_otherBox->hide();
    column.addWidget(m_otherBox);
    connect(m_other, &QCheckBox::toggled, m_otherBox, &QWidget::setVisible);
    connect(m_other, &QCheckBox::toggled, this, &RestoreDialog::check);
}

QLabel* RestoreDialog::explanation(const QString& objectName, const QString& words) const {
    auto* label = kit::label(theme(), words, TextStyle::small, "muted");
    label->setObjectName(objectName);
    return label;
}

QString RestoreDialog::acceptText() const {
    return tr("Restore");
}

void RestoreDialog::check() {
    if (!m_other)
        return; // still being built
    const auto given = [](const Pair& pair) {
        return !pair.name->text().isEmpty() && !pair.password->text().isEmpty();
    };
    setAcceptable(!m_wait->isRunning() && given(m_first) && (!m_other->isChecked() || given(m_second)));
}

void RestoreDialog::ask(AppContext& context, const session::BackupEntry& backup, Replaces replaces,
                        QWidget* parent, std::function<void(database::RestoreRequest)> restore) {
    (new RestoreDialog(context, backup, replaces, parent, std::move(restore)))->open();
}

database::RestoreRequest RestoreDialog::request() const {
    database::RestoreRequest request;
    request.backupFolder = m_folder;
    request.targetFile = context().site().file().toStdString();
    request.name = m_first.name->text().toStdString();
    request.password = m_first.password->text().toStdString();
    if (!m_other->isChecked())
        return request;
    request.presentName = m_second.name->text().toStdString();
    request.presentPassword = m_second.password->text().toStdString();
    if (m_replaces == Replaces::working) { // the first pair belongs to the current database
        std::swap(request.name, request.presentName);
        std::swap(request.password, request.presentPassword);
    }
    return request;
}

void RestoreDialog::submit() {
    setWorking(true);
    m_first.note->clear();
    m_second.note->clear();
    database::Database* open = context().site().isOpen() ? &context().site().database() : nullptr;
    context().background().run(
        this,
        [open, asked = request(), options = context().site().options()](WorkToken&) {
            return refusalOf(open, asked, options);
        },
        [this](const std::optional<database::RestoreRefusal>& refusal) { answered(refusal); });
}

void RestoreDialog::answered(const std::optional<database::RestoreRefusal>& refusal) {
    setWorking(false);
    if (refusal) {
        refused(*refusal);
        return;
    }
    const auto restore = m_restore;
    const database::RestoreRequest asked = request();
    accept();
    restore(asked);
}

/// Shows the refusal at the field concerned. All input stays.
void RestoreDialog::refused(const database::RestoreRefusal& refusal) {
    const By firstIs = m_replaces == Replaces::working ? By::present : By::backup;
    const bool second = refusal.by != firstIs;
    const bool wrong = refusal.refusal.kind == database::Refusal::Kind::wrong;
    if (second && !m_other->isChecked()) { // the first pair is right, but not valid for the other database
        m_other->setChecked(true);
        say("warning",
            refusal.by == By::backup
                ? tr("The backup has a different administrator or password. Enter those of the backup, too.")
                : tr("The damaged file has a different administrator or password. Enter those, too."));
        m_second.name->setFocus();
        return;
    }
    const Pair& pair = second ? m_second : m_first;
    const bool ownName = !m_administrator.isEmpty() && pair.name->text() == m_administrator;
    pair.note->say(wrong && ownName ? wrongPasswordWords() : refusalWords(refusal.refusal));
    m_wait->start(refusal.refusal.wait_ns);
    check();
}

} // namespace chiron::desktop
