// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/edit_person_dialog.h"

#include "database/accounts/account_rules.h"
#include "database/accounts/account_service.h"
#include "desktop/accounts/form.h"
#include "desktop/frame/app_context.h"
#include "desktop/people/login_name_field.h"
#include "desktop/widgets/kit.h"

#include <QLabel>
#include <QLineEdit>

namespace chiron::desktop {

EditPersonDialog::EditPersonDialog(AppContext& context, database::Person person, QWidget* parent)
    : FormDialog(context, QStringLiteral("edit_person"),
                 tr("Edit %1").arg(QString::fromStdString(person.name)), parent),
      m_person(std::move(person)) {
    m_fullName = form::textField(theme(), column(), tr("Full name (may be left empty)"),
                                 QStringLiteral("edit_person.full_name"));
    m_fullName->setText(QString::fromStdString(m_person.displayName));
    m_fullName->setMaxLength(database::kMaximumDisplayNameCharacters);
    m_name = new LoginNameField(theme(), QStringLiteral("edit_person"));
    m_name->setName(QString::fromStdString(m_person.name));
    column()->addWidget(m_name);
    m_renamed = kit::label(theme(), {}, TextStyle::body, "warning");
    m_renamed->setObjectName(QStringLiteral("edit_person.renamed"));
    column()->addWidget(m_renamed);
    column()->addWidget(kit::label(theme(),
                                   tr("Sessions recorded so far stay with this person and show the new name. "
                                      "The earlier names stay in the "
                                      "site's history. The password remains valid."),
                                   TextStyle::small, "muted"));
    setAccept(tr("Save"));
    connect(m_fullName, &QLineEdit::textChanged, this, &EditPersonDialog::renew);
    connect(m_name, &LoginNameField::changed, this, &EditPersonDialog::renew);
    m_fullName->setFocus();
    renew();
}

void EditPersonDialog::renew() {
    const bool changed = m_name->name().toStdString() != m_person.name ||
                         m_fullName->text().trimmed().toStdString() != m_person.displayName;
    setAcceptable(changed && m_name->isGood());
    sayWhatRenamingDoes();
}

/// Names that differ only in case are the same login name.
void EditPersonDialog::sayWhatRenamingDoes() {
    const bool renames = m_name->isGood() &&
                         database::nameKey(m_name->name().toStdString()) != database::nameKey(m_person.name);
    QStringList words;
    if (renames)
        words << tr("From now on, only %1 can be used to log in.").arg(m_name->name());
    if (renames && m_person.mustChangePassword)
        words << tr("A password slip that was handed out still shows the old login name.");
    m_renamed->setText(words.join(QLatin1Char(' ')));
    m_renamed->setVisible(renames);
}

void EditPersonDialog::submit() {
    setWorking(true);
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), id = m_person.id, name = m_name->name().toStdString(),
         displayName = m_fullName->text().trimmed().toStdString()](WorkToken&) {
            return database::AccountService(*database).changeNames(actor, id, name, displayName);
        },
        [this](const core::Result<void>& done) { saved(done); });
}

void EditPersonDialog::saved(const core::Result<void>& done) {
    setWorking(false);
    const QString name = m_name->name();
    if (done) {
        if (m_person.id == context().actor().personId())
            context().setNames(name.toStdString(), m_fullName->text().trimmed().toStdString());
        emit changed();
        context().messages().done(tr("%1 is saved.").arg(name));
        accept();
    } else if (done.error().code == core::ErrorCode::badInput) { // the rest was checked during typing
        m_name->showTaken();
    } else {
        say("bad",
            tr("%1 was not changed.\n%2").arg(QString::fromStdString(m_person.name), inWords(done.error())));
    }
}

} // namespace chiron::desktop
