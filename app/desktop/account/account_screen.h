// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/person.h"
#include "desktop/frame/screen.h"

#include <tl/expected.hpp>

class QLabel;
class QLineEdit;
class QPushButton;

namespace chiron::desktop {

class NoticeArea;
class PasswordFields;
class ScrollPage;
class StatePanel;
class WaitCountdown;

/// Lets every logged-in person change their own full name, language and password, and lets an administrator
/// make a recovery code.
/// The place takes {focus: "language"} after a change of the language, which rebuilds the screen, and {focus:
/// "recovery"} when another screen asks for a recovery code.
class AccountScreen final : public Screen {
    Q_OBJECT
public:
    AccountScreen(AppContext& context, const Place& place);

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

private:
    QWidget* nameBox();
    QWidget* languageBox();
    QWidget* passwordBox();
    QWidget* recoveryBox();
    void load();
    void loaded(const core::Result<database::Person>& person);
    void loadRecovery();
    void makeRecoveryCode();
    void renewName();
    void saveName();
    void chooseLanguage(const QString& language);
    void renewPassword();
    void changePassword();
    void passwordChanged(const tl::expected<void, database::Refusal>& done);

    ScrollPage* m_page = nullptr;
    StatePanel* m_panel = nullptr;
    QLabel* m_loginName = nullptr;
    QLineEdit* m_fullName = nullptr;
    NoticeArea* m_nameNotice = nullptr;
    QPushButton* m_saveName = nullptr;
    QWidget* m_languageNow = nullptr;
    QLineEdit* m_oldPassword = nullptr;
    PasswordFields* m_newPassword = nullptr;
    NoticeArea* m_passwordNotice = nullptr;
    QPushButton* m_changePassword = nullptr;
    WaitCountdown* m_wait = nullptr;
    QLabel* m_recoveryState = nullptr; ///< shown to administrators only, like the button
    QPushButton* m_recovery = nullptr;
    bool m_hasRecoveryCode = false;
    QString m_storedName;
    bool m_savesName = false;
    bool m_changesPassword = false;
};

} // namespace chiron::desktop
