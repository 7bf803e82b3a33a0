// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/person.h"
#include "desktop/people/form_dialog.h"

class QLabel;
class QLineEdit;

namespace chiron::desktop {

class LoginNameField;

/// Changes a person's full name and login name.
/// Thread: GUI.
class EditPersonDialog final : public FormDialog {
    Q_OBJECT
public:
    EditPersonDialog(AppContext& context, database::Person person, QWidget* parent);

protected:
    void submit() override;

private:
    void renew();
    void sayWhatRenamingDoes();
    void saved(const core::Result<void>& done);

    database::Person m_person;
    QLineEdit* m_fullName;
    LoginNameField* m_name;
    QLabel* m_renamed;
};

} // namespace chiron::desktop
