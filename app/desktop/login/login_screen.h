// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/accounts/person.h"
#include "database/actor.h"
#include "desktop/frame/screen.h"

#include <tl/expected.hpp>
#include <vector>

class QLabel;
class QVBoxLayout;

namespace chiron::desktop {

class LoginForm;
class NewPasswordPage;
class PageFooter;
class RecoveryPage;
class ScrollPage;
class StatePanel;

/// The login screen: choose a name, enter the password, or learn what to do when it is forgotten. It is the
/// first screen that is painted, so the names are loaded in the background once the site is open. Passwords
/// are checked on a worker.
class LoginScreen final : public Screen {
    Q_OBJECT
public:
    LoginScreen(AppContext& context, const Place& place);

    QString title() const override;
    QString help() const override;
    void enter() override;

private:
    void makeForm();
    void showForm();
    void showForced(const database::Actor& actor, const QString& password);
    void showRecovery();
    void showNewCode(const database::Actor& actor, const QString& name, const QString& code);
    /// `foot`: the page's buttons, which stay in sight below it.
    void setPage(QWidget* page, QWidget* foot = nullptr);
    void loadNames();
    void namesLoaded(core::Result<std::vector<database::LoginName>> names);
    void loadSiteName();
    void siteFailed(const core::Error& error);
    void examine(const QString& what, const core::Error& error, std::function<void()> again);
    void openAgain();
    void logIn(const QString& name, const QString& password);
    void changePassword(NewPasswordPage* page, const database::Actor& actor, const QString& oldPassword,
                        const QString& newPassword);
    void recover(RecoveryPage* page, const QString& name, const QString& code, const QString& newPassword);

    ScrollPage* m_scroll;
    PageFooter* m_footer;
    QLabel* m_siteName; ///< below the program's name
    StatePanel* m_site; ///< shows the site as opening, failed or open
    QVBoxLayout* m_room = nullptr;
    QWidget* m_page = nullptr;
    LoginForm* m_form = nullptr; ///< kept alive behind the other pages
};

} // namespace chiron::desktop
