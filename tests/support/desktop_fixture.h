// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/account_service.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/main_window.h"
#include "desktop/frame/program.h"
#include "desktop/frame/screen.h"
#include "support/session_fixture.h"

#include <QApplication>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>
#include <tuple>

namespace chiron::tests {

inline constexpr const char* kTestPassword = "eleven-fine-horses";

/// A site with an administrator (ada), a trainer (tom), a researcher (rhea) and two trainees (tina, theo),
/// all with kTestPassword at test cost, and the program's window on it, as main puts it together. Screens are
/// reached by login(), go() and screen<S>().
class DesktopFixture {
public:
    explicit DesktopFixture(bool demonstration = false) {
        database::DatabaseOptions made = options();
        made.demonstration = demonstration;
        auto created = database::Database::create(file().toStdString(), made);
        if (!created)
            qFatal("%s", created.error().message.c_str());
        addPeople(**created);
        settings.setLanguage(QStringLiteral("en"));
        desktop::applyAppearance(*qApp, context);
        QObject::connect(&context, &desktop::AppContext::appearanceChanged, qApp,
                         [this] { desktop::applyAppearance(*qApp, context); });
        window = std::make_unique<desktop::MainWindow>(context);
        auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        if (!catalogue)
            qFatal("%s", catalogue.error().message.c_str());
        context.takeSite(std::move(*created), std::move(*catalogue));
        window->show();
        window->activateWindow(); // shortcuts work in the active window only
        if (!QTest::qWaitForWindowActive(window.get()))
            qFatal("the window did not become active");
    }
    ~DesktopFixture() {
        context.background().cancelAndWait();
        window.reset();
    }

    QString file() const { return m_folder.filePath(QStringLiteral("test.db")); }
    QString folder() const { return m_folder.path(); }
    static database::DatabaseOptions options() {
        database::DatabaseOptions options;
        options.passwordCost = database::PasswordCost::minimalForTests();
        return options;
    }
    database::Database& database() { return context.site().database(); }

    /// The actor of a person who gave the right password.
    database::Actor actor(const std::string& name) {
        auto actor = database::AccountService(database()).login(name, kTestPassword);
        if (!actor)
            qFatal("%s", actor.error().message.c_str());
        return *actor;
    }
    /// As if that person had just logged in on the login screen: the home screen is there.
    void logIn(const std::string& name) { context.logIn(actor(name)); }
    void go(const QString& screen, const QVariantMap& parameters = {}) {
        context.navigator().go(screen, parameters);
    }

    /// A scripted session done in the name of a person, as fast as the machine can: level of sphere_apex with
    /// few trials.
    database::SessionId addSession(const std::string& person, int level = 1,
                                   const std::string& operatorName = "expert", std::uint64_t seed = 1,
                                   int trials = 2, double limit_s = 20.0) {
        session::TrainingRequest request;
        request.level = shortLevel(level, trials, limit_s);
        request.seed = seed;
        request.ringFolder = recording::defaultRingFolder();
        const auto kind = session::exerciseKind(request.level.exercise);
        auto station = session::scriptedStation(**kind, request.level, operatorName, seed);
        if (!station)
            qFatal("%s", station.error().message.c_str());
        request.station = std::move(*station);
        auto result = session::runTraining(database(), actor(person), std::move(request));
        if (!result)
            qFatal("%s", result.error().message.c_str());
        return result->session;
    }

    template <class S> S* screen() { return qobject_cast<S*>(window->screen()); }
    /// A control of the present screen (or of an open dialog) by its objectName; null if there is none.
    template <class W> W* find(const QString& name) {
        for (QWidget* top : QApplication::topLevelWidgets())
            if (W* found = top->findChild<W*>(name))
                return found;
        return nullptr;
    }

private:
    void addPeople(database::Database& database) {
        database::AccountService accounts(database);
        if (auto first = accounts.createFirstAdministrator("ada", kTestPassword, "Ada Lovelace"); !first)
            qFatal("%s", first.error().message.c_str());
        const auto ada = accounts.login("ada", kTestPassword);
        using enum database::Role;
        for (const auto& [name, display, roles] :
             {std::tuple{"tom", "Tom Trainer", database::RoleSet{trainer}},
              std::tuple{"rhea", "Rhea Research", database::RoleSet{researcher}},
              std::tuple{"tina", "Tina Trainee", database::RoleSet{trainee}},
              std::tuple{"theo", "Theo Trainee", database::RoleSet{trainee}}})
            if (auto made = accounts.createPerson(*ada, {name, display, roles, kTestPassword, false}); !made)
                qFatal("%s", made.error().message.c_str());
    }

    QTemporaryDir m_folder;

public:
    desktop::Settings settings{m_folder.filePath(QStringLiteral("desktop.ini"))};
    desktop::DesktopSite site{file(), options()};
    desktop::AppContext context{site, settings};
    std::unique_ptr<desktop::MainWindow> window;
};

/// Leaves the ready card of a session for one's own hand, where one is shown.
inline void pressGo(DesktopFixture& desktop) {
    if (auto* go = desktop.find<QPushButton>(QStringLiteral("training.ready.go")))
        go->click();
}

} // namespace chiron::tests
