// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/people/form_dialog.h"

#include <string>
#include <tl/expected.hpp>

class QLineEdit;

namespace chiron::desktop {

class FieldNote;
class RecoveryCodePanel;
class WaitCountdown;

/// Makes a recovery code for the administrator who is logged in. It asks for the password and then shows the
/// code once.
/// Thread: GUI.
class RecoveryCodeDialog final : public FormDialog {
    Q_OBJECT
public:
    /// `hasOne`: an earlier code exists, which the new one replaces.
    RecoveryCodeDialog(AppContext& context, bool hasOne, QWidget* parent);

    void reject() override; ///< warns once if the code has not been written down

private:
    void renew();
    void submit() override;
    void made(const tl::expected<std::string, database::Refusal>& code);

    const bool m_hasOne;
    QLineEdit* m_password = nullptr;
    FieldNote* m_note = nullptr;
    WaitCountdown* m_wait = nullptr;
    RecoveryCodePanel* m_shown = nullptr;
    bool m_warned = false;
};

} // namespace chiron::desktop
