// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/add_person_dialog.h"

#include "database/accounts/account_service.h"
#include "desktop/accounts/form.h"
#include "desktop/frame/app_context.h"
#include "desktop/people/login_name_field.h"
#include "desktop/people/password_choice.h"
#include "desktop/people/role_choice.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>

namespace chiron::desktop {

AddPersonDialog::AddPersonDialog(AppContext& context, QWidget* parent)
    : FormDialog(context, QStringLiteral("add_person"), tr("Add a person"), parent) {
    m_name = new LoginNameField(theme(), QStringLiteral("add_person"));
    column()->addWidget(m_name);
    m_fullName = form::textField(theme(), column(), tr("Full name (may be left empty)"),
                                 QStringLiteral("add_person.full_name"));
    m_roles = new RoleChoice(theme(), QStringLiteral("add_person"), {database::Role::trainee});
    column()->addWidget(m_roles);
    m_password = new PasswordChoice(theme(), QStringLiteral("add_person"));
    column()->addWidget(m_password);
    setAccept(tr("Add"));
    connect(m_name, &LoginNameField::changed, this, [this] { m_password->setLoginName(m_name->name()); });
    connect(m_name, &LoginNameField::changed, this, &AddPersonDialog::renew);
    connect(m_roles, &RoleChoice::changed, this, &AddPersonDialog::renew);
    connect(m_password, &PasswordChoice::changed, this, &AddPersonDialog::renew);
    m_name->focusField();
    renew();
}

void AddPersonDialog::renew() {
    setAcceptable(m_name->isGood() && !m_roles->roles().empty() && m_password->isGood());
}

void AddPersonDialog::submit() {
    setWorking(true);
    const QString name = m_name->name();
    const std::string password = m_password->password();
    const database::PersonRequest request{name.toStdString(), m_fullName->text().trimmed().toStdString(),
                                          m_roles->roles(), password, true};
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), request](WorkToken&) {
            return database::AccountService(*database).createPerson(actor, request);
        },
        [this, name, password](core::Result<database::PersonId> id) { added(id, name, password); });
}

void AddPersonDialog::added(const core::Result<database::PersonId>& id, const QString& name,
                            const std::string& password) {
    setWorking(false);
    if (!id) {
        // Name and password were checked during typing, so badInput can only mean that the name is taken.
        const bool taken = id.error().code == core::ErrorCode::badInput;
        if (taken)
            m_name->showTaken();
        say("bad", taken ? tr("%1 was not added: somebody has this name already. Names that differ only in "
                              "capital letters count as the same.")
                               .arg(name)
                         : tr("%1 was not added.\n%2").arg(name, inWords(id.error())));
        return;
    }
    emit changed();
    if (m_password->isGenerated()) {
        auto* handed =
            handedPassword(theme(), tr("%1 was added.").arg(name), name, QString::fromStdString(password));
        showSecret(handed, handed->findChild<QPushButton*>(QStringLiteral("handed.copy")));
        return;
    }
    context().messages().done(tr("%1 was added.").arg(name));
    accept();
}

} // namespace chiron::desktop
