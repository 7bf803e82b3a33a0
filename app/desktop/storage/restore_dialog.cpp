// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/restore_dialog.h"

#include "desktop/frame/app_context.h"
#include "desktop/sessions/session_words.h"
#include "desktop/widgets/kit.h"
#include "session/backup_list.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>

namespace chiron::desktop {

namespace {

QString whatHappens(RestoreDialog::Replaces replaces) {
    switch (replaces) {
    case RestoreDialog::Replaces::working:
        return RestoreDialog::tr("Everything recorded after this backup is removed from view. The current database is kept as a copy; "
                                 "nothing is deleted. People who were erased stay erased. Everybody is logged out.");
    case RestoreDialog::Replaces::damaged:
        return RestoreDialog::tr("The site becomes what it was when this backup was made. The damaged file is kept as a copy; nothing is "
                                 "deleted. People who were erased stay erased. An administrator of the backup has to agree.");
    case RestoreDialog::Replaces::missing:
        return RestoreDialog::tr("The site becomes what it was when this backup was made. People who were erased stay erased. An "
                                 "administrator of the backup has to agree.");
    }
    return {};
}

} // namespace

RestoreDialog::RestoreDialog(const Theme& theme, const QString& when, const QString& administrator, QWidget* parent, Replaces replaces)
    : QDialog(parent), m_replaces(replaces) {
    const bool working = replaces == Replaces::working;
    setObjectName(QStringLiteral("restore"));
    setWindowTitle(tr("Restore a backup"));
    setMinimumWidth(theme.px(460));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(theme.px(20), theme.px(20), theme.px(20), theme.px(20));
    column->setSpacing(theme.px(8));
    column->addWidget(kit::label(theme, tr("Go back to the backup made %1?").arg(when), TextStyle::title));
    column->addWidget(kit::label(theme, whatHappens(replaces)));
    m_name = field(*column, theme, QStringLiteral("restore.name"), working ? tr("Administrator") : tr("Administrator in the backup"), false);
    m_name->setText(administrator);
    m_password = field(*column, theme, QStringLiteral("restore.password"), working ? tr("Password") : tr("Password in the backup"), true);
    m_other = new QCheckBox(working ? tr("The backup has a different administrator or password")
                                    : tr("The damaged file has a different administrator or password"));
    m_other->setObjectName(QStringLiteral("restore.other"));
    m_other->setVisible(replaces != Replaces::missing);
    column->addWidget(m_other);
    m_otherBox = new QWidget;
    auto* inner = new QVBoxLayout(m_otherBox);
    inner->setContentsMargins(theme.px(26), 0, 0, 0);
    m_otherName = field(*inner, theme, QStringLiteral("restore.other_name"), working ? tr("Administrator in the backup") : tr("Administrator in the damaged file"), false);
    m_otherPassword = field(*inner, theme, QStringLiteral("restore.other_password"),
                            working ? tr("Password in the backup") : tr("Password in the damaged file"), true);
    m_otherBox->hide();
    column->addWidget(m_otherBox);
    connect(m_other, &QCheckBox::toggled, this, &RestoreDialog::showOther);
    connect(m_other, &QCheckBox::toggled, this, &RestoreDialog::check);
    auto* row = new QHBoxLayout;
    row->addStretch();
    auto* keep = kit::button(theme, working ? tr("Keep the current database") : tr("Cancel"));
    m_confirm = kit::button(theme, tr("Restore"), "danger");
    m_confirm->setObjectName(QStringLiteral("restore.confirm"));
    row->addWidget(keep);
    row->addWidget(m_confirm);
    column->addSpacing(theme.px(8));
    column->addLayout(row);
    connect(keep, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_confirm, &QPushButton::clicked, this, &QDialog::accept);
    check();
    (administrator.isEmpty() ? m_name : m_password)->setFocus();
}

/// With room for every line, so that none lies over another.
void RestoreDialog::showOther(bool shown) {
    m_otherBox->setVisible(shown);
    layout()->invalidate();
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width()) : layout()->totalSizeHint().height();
    resize(width(), height);
}

QLineEdit* RestoreDialog::field(QVBoxLayout& column, const Theme& theme, const QString& name, const QString& label, bool secret) {
    auto* text = kit::label(theme, label, TextStyle::label);
    auto* edit = new QLineEdit;
    edit->setObjectName(name);
    edit->setAccessibleName(label);
    edit->setEchoMode(secret ? QLineEdit::Password : QLineEdit::Normal);
    text->setBuddy(edit);
    column.addWidget(text);
    column.addWidget(edit);
    connect(edit, &QLineEdit::textChanged, this, &RestoreDialog::check);
    return edit;
}

void RestoreDialog::check() {
    if (!m_confirm)
        return; // still being built
    const bool own = !m_name->text().isEmpty() && !m_password->text().isEmpty();
    const bool other = !m_other->isChecked() || (!m_otherName->text().isEmpty() && !m_otherPassword->text().isEmpty());
    m_confirm->setEnabled(own && other);
}

void RestoreDialog::ask(AppContext& context, const session::BackupEntry& backup, Replaces replaces, QWidget* parent,
                        std::function<void(database::RestoreRequest)> restore) {
    const QString when = SessionWords::ago(SessionWords::timeOf(backup.createdUtc), QDateTime::currentDateTimeUtc(), context.locale());
    const QString administrator = replaces == Replaces::working ? QString::fromStdString(context.loginName()) : QString();
    auto* dialog = new RestoreDialog(context.theme(), when, administrator, parent, replaces);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, parent, [dialog, folder = backup.folder, file = context.site().file().toStdString(), restore = std::move(restore)] {
        database::RestoreRequest request;
        request.backupFolder = folder;
        request.targetFile = file;
        dialog->fill(request);
        restore(std::move(request));
    });
    dialog->open();
}

void RestoreDialog::fill(database::RestoreRequest& request) const {
    request.name = m_name->text().toStdString();
    request.password = m_password->text().toStdString();
    if (!m_other->isChecked())
        return;
    request.presentName = m_otherName->text().toStdString();
    request.presentPassword = m_otherPassword->text().toStdString();
    if (m_replaces == Replaces::working) { // the first pair is of the database that stands here
        std::swap(request.name, request.presentName);
        std::swap(request.password, request.presentPassword);
    }
}

} // namespace chiron::desktop
