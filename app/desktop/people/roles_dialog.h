// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/people/form_dialog.h"

namespace chiron::desktop {

class RoleChoice;

/// Changes the roles of a person.
/// Thread: GUI.
class RolesDialog final : public FormDialog {
    Q_OBJECT
public:
    RolesDialog(AppContext& context, database::Person person, QWidget* parent);

protected:
    void submit() override;

private:
    database::Person m_person;
    RoleChoice* m_roles;
};

} // namespace chiron::desktop
