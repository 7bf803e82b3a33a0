// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/people/form_dialog.h"

namespace chiron::desktop {

class PasswordChoice;

/// Sets a new password for a person, who must change it at the next login.
/// Thread: GUI.
class ResetPasswordDialog final : public FormDialog {
    Q_OBJECT
public:
    ResetPasswordDialog(AppContext& context, database::Person person, QWidget* parent);

protected:
    void submit() override;

private:
    database::Person m_person;
    PasswordChoice* m_password;
};

} // namespace chiron::desktop
