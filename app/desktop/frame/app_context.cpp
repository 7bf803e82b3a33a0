// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/app_context.h"

#include "database/accounts/account_service.h"
#include "session/site.h"

namespace chiron::desktop {

namespace {
const QString kLanguage = QStringLiteral("language"); // of a person, in the settings

/// The token file is part of the program and a test checks it for each theme, so a failure here is a
/// programming error.
Theme themeOf(const Settings& settings) {
    return Theme::load(settings.theme(), settings.scale()).value();
}

struct Opened {
    session::OpenedSite site;
    catalogue::Catalogue catalogue;
};

core::Result<Opened> openWithContent(const std::string& file, const database::DatabaseOptions& options) {
    auto content = catalogue::findContentDirectory().and_then(
        [](const std::string& folder) { return catalogue::Catalogue::load(folder); });
    CHIRON_TRY(content);
    auto site = session::openSite(file, options);
    CHIRON_TRY(site);
    return Opened{std::move(*site), std::move(*content)};
}

} // namespace

AppContext::AppContext(DesktopSite& site, Settings& settings, QObject* parent)
    : QObject(parent), m_site(site), m_settings(settings), m_theme(themeOf(settings)) {}

void AppContext::openSite() {
    const std::string file = m_site.file().toStdString();
    const database::DatabaseOptions options = m_site.options();
    m_background.run(
        this, [file, options](WorkToken&) { return openWithContent(file, options); },
        [this](core::Result<Opened> opened) {
            if (!opened) {
                emit siteFailed(opened.error());
                return;
            }
            m_site.setCatalogue(std::move(opened->catalogue));
            m_site.setOpened(std::move(opened->site.database), std::move(opened->site.recovered));
            emit siteOpened();
        });
}

void AppContext::takeSite(std::unique_ptr<database::Database> database, catalogue::Catalogue catalogue) {
    m_site.setCatalogue(std::move(catalogue));
    m_site.setOpened(std::move(database), {});
    emit siteOpened();
}

QString AppContext::ownLanguage() const {
    const QString own =
        loggedIn() ? m_settings.ofPerson(m_actor.personId(), kLanguage, QString()).toString() : QString();
    return Settings::isLanguage(own) ? own : QString();
}

QString AppContext::language() const {
    const QString own = ownLanguage();
    return own.isEmpty() ? m_settings.language() : own;
}

void AppContext::setOwnLanguage(const QString& language) {
    const QString before = this->language();
    m_settings.setOfPerson(m_actor.personId(), kLanguage, language);
    if (this->language() != before)
        applyAppearance();
}

void AppContext::setStationLanguage(const QString& language) {
    m_settings.setLanguage(language);
    if (!ownLanguage().isEmpty())
        m_settings.setOfPerson(m_actor.personId(), kLanguage, language);
    applyAppearance();
}

QString AppContext::shownName() const {
    return QString::fromStdString(m_fullName.empty() ? m_loginName : m_fullName);
}

void AppContext::setNames(const std::string& loginName, const std::string& fullName) {
    m_loginName = loginName;
    m_fullName = fullName;
    emit namesChanged();
}

void AppContext::renewRoles() {
    m_background.run(
        this,
        [&database = m_site.database(), actor = m_actor](WorkToken&) {
            return database::AccountService(database).self(actor);
        },
        [this](const core::Result<database::Person>& self) {
            // The data layer looks them up itself, so nothing but the navigation depends on this reading.
            if (!self || self->id != m_actor.personId() || self->roles == m_roles)
                return;
            m_roles = self->roles;
            emit rolesChanged();
        });
}

void AppContext::setActor(const database::Actor& actor) {
    const QString before = language();
    m_actor = actor;
    m_roles = actor.roles();
    m_unread = 0;
    m_loginName = actor.name();
    m_fullName = actor.fullName();
    emit actorChanged();
    if (language() != before)
        applyAppearance();
}

void AppContext::logIn(const database::Actor& actor) {
    setActor(actor);
    m_navigator.replace({QStringLiteral("home"), {}});
    m_navigator.forget();
}

void AppContext::logOut() {
    m_navigator.replace({QStringLiteral("login"), {}});
    if (m_navigator.current().screen != QLatin1String("login"))
        return; // the screen may not be left now
    m_navigator.forget();
    setActor(database::Actor::anonymous());
}

void AppContext::logOutNow() {
    setActor(database::Actor::anonymous());
    m_navigator.replaceNow({QStringLiteral("login"), {}});
    m_navigator.forget();
}

void AppContext::applyAppearance() {
    m_theme = themeOf(m_settings);
    emit appearanceChanged();
}

void AppContext::setUnread(int sessions) {
    if (m_unread == sessions)
        return;
    m_unread = sessions;
    emit unreadChanged(sessions);
}

void AppContext::setTrialRuns(bool runs) {
    if (m_trialRuns == runs)
        return;
    m_trialRuns = runs;
    emit trialRunsChanged(runs);
}

} // namespace chiron::desktop
