// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/command_palette.h"
#include "desktop/frame/instance_link.h"
#include "desktop/settings/settings_screen.h"
#include "support/desktop_fixture.h"

#include <QLineEdit>
#include <QListWidget>
#include <QRadioButton>
#include <QSignalSpy>

using namespace chiron;
using namespace chiron::desktop;

class TestFrame : public QObject {
    Q_OBJECT
private slots:
    void paletteFindsWords() {
        QCOMPARE(CommandPalette::fit({}, QStringLiteral("Anything")), 1);
        QCOMPARE(CommandPalette::fit(QStringLiteral("set"), QStringLiteral("Go to: Settings")), 4);
        QCOMPARE(CommandPalette::fit(QStringLiteral("tings"), QStringLiteral("Go to: Settings")), 3);
        QCOMPARE(CommandPalette::fit(QStringLiteral("gst"), QStringLiteral("Go to: Settings")), 2);
        QCOMPARE(CommandPalette::fit(QStringLiteral("xyz"), QStringLiteral("Go to: Settings")), 0);
        QCOMPARE(CommandPalette::fit(QStringLiteral("ubersicht"), QStringLiteral("Übersicht")), 4);
        QCOMPARE(CommandPalette::fit(QStringLiteral("αρχικη"), QStringLiteral("Αρχική")), 4);
    }

    void paletteOpensAScreenByKeysAlone() {
        tests::DesktopFixture desktop;
        desktop.logIn("tina");
        desktop.go(QStringLiteral("settings"));
        desktop.go(QStringLiteral("home"));
        QTest::keyClick(desktop.window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(desktop.find<QLineEdit>(QStringLiteral("palette.field")));
        auto* field = desktop.find<QLineEdit>(QStringLiteral("palette.field"));
        QTest::keyClicks(field, QStringLiteral("settings"));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY(desktop.screen<SettingsScreen>());
    }

    void languageThemeAndScaleChangeAtOnce() {
        tests::DesktopFixture desktop;
        desktop.logIn("tina");
        desktop.go(QStringLiteral("settings"));
        QTest::mouseClick(desktop.find<QRadioButton>(QStringLiteral("settings.theme.1")), Qt::LeftButton);
        QTRY_COMPARE(desktop.context.theme().name(), ThemeName::dark);
        QTest::mouseClick(desktop.find<QRadioButton>(QStringLiteral("settings.scale.200")), Qt::LeftButton, {}, QPoint(5, 5));
        QTRY_COMPARE(desktop.context.theme().scale(), 2.0);
        QTRY_VERIFY(desktop.screen<SettingsScreen>()); // still there, built anew
        QVERIFY(Settings(desktop.folder() + QStringLiteral("/desktop.ini")).scale() == 2.0);
    }

    void appearanceWaitsForTheTrialsEnd() {
        tests::DesktopFixture desktop;
        desktop.logIn("tina");
        desktop.go(QStringLiteral("settings"));
        const Screen* before = desktop.window->screen();
        desktop.context.setTrialRuns(true);
        desktop.settings.setTheme(ThemeName::dark);
        desktop.context.applyAppearance();
        QTest::qWait(20);
        QCOMPARE(desktop.window->screen(), before);
        desktop.context.setTrialRuns(false);
        QTRY_VERIFY(desktop.window->screen() != before);
    }

    void brokenSettingsGiveDefaults() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("broken.ini"));
        QFile broken(file);
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("language=klingon\ntheme=pink\nscale=huge\nsound=\n");
        broken.close();
        const Settings settings(file);
        QVERIFY(QStringList({QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("el")}).contains(settings.language()));
        QCOMPARE(settings.theme(), ThemeName::light);
        QCOMPARE(settings.scale(), 1.0);
    }

    void secondProgramRaisesTheFirst() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("site.db"));
        QVERIFY(!InstanceLink::raiseOther(file)); // nobody listens
        InstanceLink first(file);
        QVERIFY(first.listen());
        QSignalSpy raised(&first, &InstanceLink::raiseAsked);
        QVERIFY(InstanceLink::raiseOther(file));
        QTRY_COMPARE(raised.count(), 1);
    }

    void secondProgramIsNotFooledByALeftOver() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("site.db"));
        {
            InstanceLink first(file);
            QVERIFY(first.listen());
        }
        QVERIFY(!InstanceLink::raiseOther(file));
        InstanceLink next(file);
        QVERIFY(next.listen());
        QVERIFY(next.listen()); // twice is once
    }
};

QTEST_MAIN(TestFrame)
#include "test_frame.moc"
