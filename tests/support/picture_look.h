// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/desktop_fixture.h"
#include "support/languages.h"

#include <QDir>
#include <QScreen>
#include <QWindow>

namespace chiron::tests {

/// Whether pictures of a test are wanted so: CHIRON_PICTURE_LOOK=dark,de ("dark", "contrast", "de", "el",
/// "scene": the drawn scene instead of the flat one). For eyes alone: what a test compares are English words.
inline bool hasLook(const char* look) {
    return qEnvironmentVariable("CHIRON_PICTURE_LOOK").split(QLatin1Char(',')).contains(QLatin1String(look));
}

inline void applyLook(DesktopFixture& desktop) {
    if (hasLook("dark"))
        desktop.settings.setTheme(desktop::ThemeName::dark);
    if (hasLook("contrast"))
        desktop.settings.setTheme(desktop::ThemeName::highContrast);
    for (const char* language : tests::otherLanguages())
        if (hasLook(language))
            desktop.settings.setLanguage(QLatin1String(language));
    desktop.context.applyAppearance();
}

/// As it is on the screen, scene included, in the folder CHIRON_KEEP_PICTURES where there is one.
inline void keepPicture(DesktopFixture& desktop, const QString& name) {
    const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES");
    if (folder.isEmpty())
        return;
    QTest::qWait(500); // scenes draw their first frames
    QWidget& window = *desktop.window;
    (void)window.windowHandle()
        ->screen()
        ->grabWindow(window.winId())
        .save(QDir(folder).filePath(name + QStringLiteral(".png")));
}

} // namespace chiron::tests
