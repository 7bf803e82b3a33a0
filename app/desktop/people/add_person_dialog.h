// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"
#include "desktop/people/form_dialog.h"

#include <string>

class QLineEdit;

namespace chiron::desktop {

class LoginNameField;
class PasswordChoice;
class RoleChoice;

/// Adds a person: name, roles, first password.
/// Thread: GUI.
class AddPersonDialog final : public FormDialog {
    Q_OBJECT
public:
    AddPersonDialog(AppContext& context, QWidget* parent);

protected:
    void submit() override;

private:
    void renew();
    void added(const core::Result<database::PersonId>& id, const QString& name, const std::string& password);

    LoginNameField* m_name;
    QLineEdit* m_fullName;
    RoleChoice* m_roles;
    PasswordChoice* m_password;
};

} // namespace chiron::desktop
