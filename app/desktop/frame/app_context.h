// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/actor.h"
#include "desktop/frame/background.h"
#include "desktop/frame/messages.h"
#include "desktop/frame/navigator.h"
#include "desktop/frame/settings.h"
#include "desktop/site/desktop_site.h"
#include "desktop/theme/theme.h"

#include <QObject>

namespace chiron::desktop {

/// Gives the screens access to the objects that main() assembles, and knows who is logged in. It owns none of
/// the site's data and contains no rules.
/// Thread: GUI.
class AppContext : public QObject {
    Q_OBJECT
public:
    AppContext(DesktopSite& site, Settings& settings, QObject* parent = nullptr);

    DesktopSite& site() noexcept { return m_site; }
    Settings& settings() noexcept { return m_settings; }
    Navigator& navigator() noexcept { return m_navigator; }
    Messages& messages() noexcept { return m_messages; }
    Background& background() noexcept { return m_background; }
    const Theme& theme() const noexcept { return m_theme; }
    QLocale locale() const { return Settings::localeOf(language()); }
    /// The language that the logged-in person chose, or else the station's.
    QString language() const;
    QString ownLanguage() const; ///< empty if the person chose none
    /// Stored for the person on this station; empty selects the station's language again.
    void setOwnLanguage(const QString& language);
    /// Also replaces the person's own choice, if any, so that the change is visible.
    void setStationLanguage(const QString& language);

    /// The person who is logged in; anonymous before login. Copy it into the work that you hand to
    /// Background.
    const database::Actor& actor() const noexcept { return m_actor; }
    bool loggedIn() const noexcept { return m_actor.kind() == database::ActorKind::person; }
    /// The current login name, which may have changed since the login.
    const std::string& loginName() const noexcept { return m_loginName; }
    /// The person as screens and records name them: by their full name, or by the login name if they have
    /// none.
    QString shownName() const;
    void setNames(const std::string& loginName, const std::string& fullName);
    /// The person's current roles, which may have changed since the login.
    const database::RoleSet& roles() const noexcept { return m_roles; }
    bool has(database::Role role) const { return m_roles.contains(role); }
    /// Reads the person's roles anew, after accounts were changed. Emits rolesChanged() if they are others.
    void renewRoles();
    /// Opens the site's database on a worker, which also recovers what a crash left behind, and loads the
    /// content. Emits siteOpened() or siteFailed().
    void openSite();
    /// Takes over a database that was just created (first start, demonstration) instead of opening the site's
    /// own file.
    void takeSite(std::unique_ptr<database::Database> database, catalogue::Catalogue catalogue);

    /// Goes to the home screen after a correct password. The login screen calls it.
    void logIn(const database::Actor& actor);
    /// Goes back to the login screen, to log out or switch users. Everything recorded is kept.
    void logOut();
    /// The same without asking the current screen, for the case that another person takes over a locked
    /// window.
    void logOutNow();
    /// Rebuilds everything on the screen after theme, scale or language was changed in the settings.
    void applyAppearance();

    /// Whether a session is running now. The idle lock and theme changes wait until it ends.
    bool trialRuns() const noexcept { return m_trialRuns; }
    void setTrialRuns(bool runs);
    /// The number of the person's sessions with comments by others that they have not read. The screens that
    /// show the comments count them.
    int unread() const noexcept { return m_unread; }
    void setUnread(int sessions);
    /// Reports that a device moved, which counts as activity for the idle lock.
    void touch() { emit activity(); }

signals:
    void siteOpened();
    void siteFailed(const chiron::core::Error& error);
    void appearanceChanged();
    void actorChanged();
    void namesChanged();
    void rolesChanged();
    void trialRunsChanged(bool runs);
    void unreadChanged(int sessions);
    void activity();
    void lockAsked(); ///< Ctrl+L or idle: the main window shows the lock
    void unlocked();
    void backupEnded(); ///< a scheduled backup succeeded or failed: anything that shows backups reloads

private:
    void setActor(const database::Actor& actor);

    DesktopSite& m_site;
    Settings& m_settings;
    Navigator m_navigator;
    Messages m_messages;
    Background m_background;
    Theme m_theme;
    database::Actor m_actor = database::Actor::anonymous();
    std::string m_loginName;
    std::string m_fullName;
    database::RoleSet m_roles;
    bool m_trialRuns = false;
    int m_unread = 0;
};

} // namespace chiron::desktop
