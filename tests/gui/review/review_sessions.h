// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/session_reader.h"
#include "desktop/theme/theme_colour.h"
#include "desktop/widgets/state_panel.h"
#include "support/desktop_fixture.h"
#include "support/languages.h"
#include "support/made_session.h"
#include "support/settled.h"

#include <QDir>
#include <QScreen>
#include <QWindow>

namespace chiron::tests {

/// Scripted sessions to be done again in somebody's name, as if by their own hand: made once for a whole test
/// program.
class ReviewSessions {
public:
    explicit ReviewSessions(database::Database& database, int trials = 3, int level = 2) {
        for (std::uint64_t seed = 5; !passed; ++seed)
            good = made(database, level, "expert", seed, trials);
        bad = made(database, level, "unsafe", 6, trials);
    }

    MadeSession good; ///< passes
    MadeSession bad;  ///< far over the force limit
    /// The device as one that renders no force.
    static MadeSession shown(MadeSession session) {
        for (devices::DeviceDescriptor& device : session.setup.devices)
            device.rendersForce = false;
        return session;
    }

private:
    MadeSession made(database::Database& database, int level, const std::string& name, std::uint64_t seed,
                     int trials) {
        session::TrainingRequest request;
        request.level = shortLevel(level, trials, 20.0);
        request.seed = seed;
        request.ringFolder = recording::defaultRingFolder();
        auto station =
            session::scriptedStation(**session::exerciseKind("sphere_apex"), request.level, name, seed);
        if (!station)
            qFatal("%s", station.error().message.c_str());
        request.station = std::move(*station);
        auto result = session::runTraining(database, database::Actor::simulated(), std::move(request));
        if (!result)
            qFatal("%s", result.error().message.c_str());
        passed = result->scores.passed;
        MadeSession copy = copyOf(database, result->session);
        copy.operatorName.clear();
        return copy;
    }
    bool passed = false; ///< the last one made
};

inline desktop::StatePanel* panelOf(DesktopFixture& site) {
    return site.window->screen()->findChild<desktop::StatePanel*>();
}

inline bool isLoaded(DesktopFixture& site) {
    return panelOf(site) && panelOf(site)->state() == desktop::StatePanel::State::content;
}

/// What is cut off or without a name, at 100 and 200 % in every language. `show` brings the screen back after
/// each change.
template <class Show> QStringList findingsOn(DesktopFixture& site, Show show) {
    QStringList findings;
    for (const char* language : tests::languagesEnglishLast()) {
        for (const double scale : {2.0, 1.0}) {
            site.settings.setLanguage(QLatin1String(language));
            site.settings.setScale(scale);
            site.context.applyAppearance();
            site.window->resize(1280, 720);
            show();
            for (const QString& finding : settledFindings(site.window->screen()))
                findings << QStringLiteral("%1 %2: %3").arg(QLatin1String(language)).arg(scale).arg(finding);
        }
    }
    return findings;
}

/// Pictures of the present screen in every theme, where CHIRON_PICTURES names a folder; nothing else. `show`
/// brings the screen back after each change.
template <class Show> void takePictures(DesktopFixture& site, const QString& name, Show show) {
    const QString folder = qEnvironmentVariable("CHIRON_PICTURES");
    if (folder.isEmpty())
        return;
    const auto look = [&](desktop::ThemeName theme, double scale, const char* suffix) {
        site.settings.setTheme(theme);
        site.settings.setScale(scale);
        site.context.applyAppearance();
        site.window->resize(1280, 720);
        show();
        QTest::qWait(400);
        // The 3D scene is a window of its own: only the screen has it.
        const bool onScreen = QGuiApplication::platformName() == QLatin1String("xcb");
        const QPixmap picture = onScreen
                                    ? site.window->windowHandle()->screen()->grabWindow(site.window->winId())
                                    : site.window->grab();
        picture.save(QDir(folder).filePath(QStringLiteral("%1_%2.png").arg(name, QLatin1String(suffix))));
    };
    look(desktop::ThemeName::dark, 1.0, "dark");
    look(desktop::ThemeName::highContrast, 1.0, "contrast");
    look(desktop::ThemeName::light, 2.0, "light200");
    site.settings.setLanguage(QStringLiteral("de"));
    look(desktop::ThemeName::light, 1.0, "german");
    site.settings.setLanguage(QStringLiteral("en"));
    look(desktop::ThemeName::light, 1.0, "light");
}

} // namespace chiron::tests
