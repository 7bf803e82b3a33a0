// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/person.h"
#include "desktop/people/form_dialog.h"

class QCheckBox;
class QLineEdit;

namespace chiron::desktop {

class WaitCountdown;

/// Erases a person for ever: says what goes and what stays, asks for a reason, the person's login name typed out, and the
/// administrator's own password. Where it stopped half-way it can be sent again and goes on. GUI thread.
class EraseDialog final : public FormDialog {
    Q_OBJECT
public:
    EraseDialog(AppContext& context, database::Person person, QWidget* parent);

protected:
    void submit() override;

private:
    void renew();
    void refused(const database::Refusal& refusal);
    void finished(const core::Result<void>& done);

    database::Person m_person;
    QLineEdit* m_reason;
    QCheckBox* m_withdraw;
    QLineEdit* m_typedName;
    QLineEdit* m_password;
    WaitCountdown* m_wait;
};

} // namespace chiron::desktop
