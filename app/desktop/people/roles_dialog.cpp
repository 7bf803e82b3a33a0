// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/roles_dialog.h"

#include "database/accounts/account_service.h"
#include "desktop/frame/app_context.h"
#include "desktop/people/role_choice.h"
#include "desktop/widgets/kit.h"

namespace chiron::desktop {

RolesDialog::RolesDialog(AppContext& context, database::Person person, QWidget* parent)
    : FormDialog(context, QStringLiteral("roles"), tr("Roles of %1").arg(QString::fromStdString(person.name)),
                 parent),
      m_person(std::move(person)) {
    m_roles = new RoleChoice(theme(), QStringLiteral("roles"), m_person.roles);
    column()->addWidget(m_roles);
    column()->addWidget(kit::label(theme(),
                                   tr("The change takes effect at once, even for people who are logged in."),
                                   TextStyle::small, "muted"));
    setAccept(tr("Save"));
    connect(m_roles, &RoleChoice::changed, this,
            [this] { setAcceptable(!m_roles->roles().empty() && m_roles->roles() != m_person.roles); });
}

void RolesDialog::submit() {
    setWorking(true);
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), id = m_person.id, roles = m_roles->roles()](WorkToken&) {
            return database::AccountService(*database).setRoles(actor, id, roles);
        },
        [this](core::Result<void> done) {
            setWorking(false);
            const QString name = QString::fromStdString(m_person.name);
            if (done) {
                emit changed();
                context().messages().done(m_person.id == context().actor().personId()
                                              ? tr("Your roles have been changed. The list on the left shows "
                                                   "the screens that go with them.")
                                              : tr("The roles of %1 have been changed.").arg(name));
                accept();
            } else if (done.error().code == core::ErrorCode::wrongUse) {
                // This is the only rule that a choice of roles can violate.
                say("bad", tr("%1 remains an administrator: a site needs at least one who can log in. Make "
                              "another person an administrator "
                              "first.")
                               .arg(name));
            } else {
                say("bad", tr("The roles of %1 were not changed.\n%2").arg(name, inWords(done.error())));
            }
        });
}

} // namespace chiron::desktop
