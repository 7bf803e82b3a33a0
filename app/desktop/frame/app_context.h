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

/// What screens are given: the parts that main put together. Owns none of the site's data and no rule. GUI thread.
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
    /// Of whoever is logged in, where they have chosen one; otherwise the station's.
    QString language() const;
    QString ownLanguage() const;                   ///< empty: none was chosen
    void setOwnLanguage(const QString& language);  ///< remembered with the person on this station; empty: the station's again
    void setStationLanguage(const QString& language); ///< and, so that it is seen, the person's own where they have one

    /// Who is logged in; anonymous before login. Copy it into the work that is handed to Background.
    const database::Actor& actor() const noexcept { return m_actor; }
    bool loggedIn() const noexcept { return m_actor.kind() == database::ActorKind::person; }
    /// The login name as it is now: it may have been changed since the login.
    const std::string& loginName() const noexcept { return m_loginName; }
    void setLoginName(const std::string& name);
    bool has(database::Role role) const { return m_actor.roles().contains(role); }
    /// Opens the site's database on a worker (what a crash left behind is brought in) and loads the content; siteOpened()
    /// or siteFailed() follows.
    void openSite();
    /// A database that was just made (first start, demonstration): takes it over in the place of the file's own.
    void takeSite(std::unique_ptr<database::Database> database, catalogue::Catalogue catalogue);

    /// After a right password: the home screen. The login screen calls it.
    void logIn(const database::Actor& actor);
    /// Switch user and log out: back to the login screen; what was recorded is kept.
    void logOut();
    /// The same without asking the present screen: somebody else takes over a locked window.
    void logOutNow();
    /// Theme, scale or language was changed in the settings: everything on the screen is built anew.
    void applyAppearance();

    /// Something shows whether a session is running right now (idle lock, theme changes wait for its end).
    bool trialRuns() const noexcept { return m_trialRuns; }
    void setTrialRuns(bool runs);
    /// How many of the person's sessions have comments by others that they have not read; counted where they are shown.
    int unread() const noexcept { return m_unread; }
    void setUnread(int sessions);
    /// A device moved: counts as activity for the idle lock.
    void touch() { emit activity(); }

signals:
    void siteOpened();
    void siteFailed(const chiron::core::Error& error);
    void appearanceChanged();
    void actorChanged();
    void loginNameChanged();
    void trialRunsChanged(bool runs);
    void unreadChanged(int sessions);
    void activity();
    void lockAsked(); ///< Ctrl+L or idle: the main window covers itself with the lock
    void unlocked();
    void backupEnded(); ///< the schedule's, made or failed: what tells of backups reads again

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
    bool m_trialRuns = false;
    int m_unread = 0;
};

} // namespace chiron::desktop
