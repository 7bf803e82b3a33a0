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

/// What every signed-in person may change about themselves: full name, language, password; an administrator's recovery code. Place
/// {focus: "language"} after the language was changed, which builds the screen anew; {focus: "recovery"} from whatever asks for a code.
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
    QLabel* m_recoveryState = nullptr; ///< of an administrator, with the button
    QPushButton* m_recovery = nullptr;
    bool m_hasRecoveryCode = false;
    QString m_storedName;
    bool m_savesName = false;
    bool m_changesPassword = false;
};

} // namespace chiron::desktop
