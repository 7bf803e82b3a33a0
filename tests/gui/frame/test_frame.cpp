// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/command_palette.h"
#include "desktop/frame/instance_link.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/frame/message_bar.h"
#include "desktop/settings/settings_screen.h"
#include "support/desktop_fixture.h"

#include <QVBoxLayout>
#include <QCursor>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
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

    void entriesOfTheSideBarAreAsWideAsIt() {
        tests::DesktopFixture desktop;
        desktop.logIn("ada");
        desktop.window->resize(1600, 1100); // so high that nothing scrolls
        auto* entry = desktop.find<QPushButton>(QStringLiteral("nav.people"));
        QVERIFY(entry);
        const QWidget* view = entry->parentWidget()->parentWidget(); // of the list, which would scroll
        QTRY_COMPARE(entry->width(), view->width());
        QCOMPARE(entry->parentWidget()->height(), view->height());
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

    /// What one program has set the next one reads, each by its own name.
    void whatIsSetIsReadAgain() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("desktop.ini"));
        {
            const Settings fresh(file);
            QVERIFY(fresh.sound() && fresh.soundCue(QStringLiteral("contact")));
            QCOMPARE(fresh.scale(), 1.0);
            QVERIFY(fresh.backupFolder().isEmpty());
            QCOMPARE(fresh.ofPerson(3, QStringLiteral("hand"), QStringLiteral("right")).toString(), QStringLiteral("right"));
        }
        {
            Settings set(file);
            set.setSound(false);
            set.setSoundCue(QStringLiteral("contact"), false);
            set.setBackupFolder(QStringLiteral("/a/folder"));
            set.setOfPerson(3, QStringLiteral("hand"), QStringLiteral("left"));
        }
        const Settings read(file);
        QVERIFY(!read.sound());
        QVERIFY(!read.soundCue(QStringLiteral("contact")) && read.soundCue(QStringLiteral("force")));
        QCOMPARE(read.backupFolder(), QStringLiteral("/a/folder"));
        QCOMPARE(read.ofPerson(3, QStringLiteral("hand"), QStringLiteral("right")).toString(), QStringLiteral("left"));
        QCOMPARE(read.ofPerson(4, QStringLiteral("hand"), QStringLiteral("right")).toString(), QStringLiteral("right")); // somebody else's
        for (const ThemeName theme : {ThemeName::dark, ThemeName::highContrast, ThemeName::light}) {
            Settings(file).setTheme(theme);
            QCOMPARE(Settings(file).theme(), theme);
        }
        for (const auto& [given, taken] : {std::pair{1.25, 1.25}, {2.5, 2.0}, {0.5, 1.0}, {2.0, 2.0}}) {
            Settings(file).setScale(given);
            QCOMPARE(Settings(file).scale(), taken);
        }
        for (const auto& [language, territory] : {std::pair{"de", QLocale::Germany}, {"el", QLocale::Greece}, {"en", QLocale::UnitedKingdom}}) {
            Settings(file).setLanguage(QLatin1String(language));
            QCOMPARE(Settings(file).language(), QLatin1String(language));
            QCOMPARE(Settings(file).locale().territory(), territory);
            QCOMPARE(Settings(file).locale().name().left(2), QLatin1String(language));
        }
    }

    /// Up and down stop at the ends of what was found; Enter runs what is chosen, Escape nothing.
    void paletteIsWalkedByArrows() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        QStringList ran;
        const auto command = [&](const char* text, const QKeySequence& keys) { return ScreenCommand{QLatin1String(text), keys, [&ran, text] { ran << QLatin1String(text); }}; };
        const std::vector<CommandGroup> groups{{QStringLiteral("Here"), {command("Open it", {}), command("Save the list", QKeySequence::Save)}},
                                               {QStringLiteral("Places"), {command("Go to: Saved", {}), {QStringLiteral("Nothing to do"), {}, {}}}}};
        const auto open = [&] {
            auto* palette = new CommandPalette(theme, groups, nullptr);
            palette->show();
            return palette;
        };
        auto* palette = open();
        auto* field = palette->findChild<QLineEdit*>();
        auto* list = palette->findChild<QListWidget*>();
        QCOMPARE(list->count(), 4); // nothing typed: all
        QVERIFY2(list->item(1)->text().endsWith(QStringLiteral("(Ctrl+S)")), qPrintable(list->item(1)->text()));
        QCOMPARE(list->item(0)->text(), QStringLiteral("Open it"));
        QCOMPARE(list->currentRow(), 0);
        for (const auto& [key, row] : {std::pair{Qt::Key_Up, 0}, {Qt::Key_Down, 1}, {Qt::Key_Down, 2}, {Qt::Key_Down, 3}, {Qt::Key_Down, 3}, {Qt::Key_Up, 2}}) {
            QTest::keyClick(field, key);
            QCOMPARE(list->currentRow(), row);
        }
        QTest::keyClicks(field, QStringLiteral("xyz"));
        QVERIFY(list->isHidden() && list->count() == 0);
        QTest::keyClick(field, Qt::Key_Return); // nothing to run
        QVERIFY(palette->isVisible() && ran.isEmpty());
        field->clear();
        QVERIFY(!list->isHidden());
        QTest::keyClicks(field, QStringLiteral("av")); // in the middle of both words: in their order
        QCOMPARE(list->count(), 2);
        QVERIFY(list->item(0)->text().startsWith(QStringLiteral("Save")));
        QTest::keyClicks(field, QStringLiteral("e"));
        field->setText(QStringLiteral("saved"));
        QCOMPARE(list->count(), 1);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(ran, QStringList{QStringLiteral("Go to: Saved")});
        palette = open();
        palette->findChild<QLineEdit*>()->setText(QStringLiteral("nothing"));
        QTest::keyClick(palette->findChild<QLineEdit*>(), Qt::Key_Return); // has no act
        palette = open();
        emit palette->findChild<QListWidget*>()->itemClicked(palette->findChild<QListWidget*>()->item(0)); // what is chosen is the first
        QCOMPARE(ran.last(), QStringLiteral("Open it"));
        palette = open();
        QTest::keyClick(palette, Qt::Key_Escape);
        QCOMPARE(ran.size(), 2);
    }

    /// Messages: what kind is seen and heard, errors stay until they are closed, an action is done once and the message goes.
    void messagesAreSaidByTheirKind() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        MessageBar bar(theme);
        QVERIFY(bar.isHidden());
        auto* timer = bar.findChild<QTimer*>();
        const auto colour = [&] {
            const QImage sign = bar.findChildren<QLabel*>().front()->pixmap().toImage();
            QRgb most = 0; // its thickest place
            for (int y = 0; y < sign.height(); ++y)
                for (int x = 0; x < sign.width(); ++x)
                    most = qAlpha(sign.pixel(x, y)) > qAlpha(most) ? sign.pixel(x, y) : most;
            return QColor(most);
        };
        for (const auto& [kind, look, ink] : {std::tuple{MessageKind::done, "good", Colour::good}, {MessageKind::information, "info", Colour::accent}, {MessageKind::warning, "warning", Colour::warning},
                                              {MessageKind::error, "bad", Colour::bad}}) {
            bar.tell({kind, QStringLiteral("words of kind %1").arg(static_cast<int>(kind)), {}, {}});
            QVERIFY(!bar.isHidden());
            QCOMPARE(bar.property("kind").toString(), QLatin1String(look));
            QCOMPARE(bar.findChild<QLabel*>(QStringLiteral("messages.text"))->text(), QStringLiteral("words of kind %1").arg(static_cast<int>(kind)));
            const QColor seen = colour(), wanted = theme.color(ink); // thin lines are not of the whole ink
            QVERIFY2(std::abs(seen.red() - wanted.red()) + std::abs(seen.green() - wanted.green()) + std::abs(seen.blue() - wanted.blue()) < 40, qPrintable(seen.name()));
            QCOMPARE(timer->isActive(), kind != MessageKind::error);
            QVERIFY(timer->isSingleShot() && timer->interval() >= 5000);
            QVERIFY(bar.findChild<QPushButton*>(QStringLiteral("messages.action"))->isHidden());
        }
        int undone = 0;
        bar.tell({MessageKind::done, QStringLiteral("Archived"), QStringLiteral("Undo"), [&undone] { ++undone; }});
        auto* action = bar.findChild<QPushButton*>(QStringLiteral("messages.action"));
        QVERIFY(!action->isHidden() && action->text() == QStringLiteral("Undo"));
        action->click();
        QVERIFY(undone == 1 && bar.isHidden());
        bar.tell({MessageKind::warning, QStringLiteral("Beware"), {}, {}});
        for (auto* button : bar.findChildren<QPushButton*>())
            if (button != action)
                button->click(); // closes
        QVERIFY(bar.isHidden());
        bar.tell({MessageKind::done, QStringLiteral("Soon gone"), {}, {}});
        timer->start(0);
        QTRY_VERIFY(bar.isHidden());
    }

    /// Nothing moves under the pointer when something is said, and nothing is said between the pointer and what it points at.
    void noControlMovesWhenSomethingIsSaid() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        QWidget window;
        window.resize(1280, 720);
        auto* column = new QVBoxLayout(&window);
        auto* above = new QPushButton(QStringLiteral("above"));
        auto* below = new QPushButton(QStringLiteral("below"));
        auto* area = new NoticeArea(theme);
        column->addWidget(above);
        column->addWidget(area);
        column->addWidget(below);
        column->addStretch();
        MessageBar bar(theme, &window);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const QPoint first = above->pos(), second = below->pos();
        const auto stays = [&](const char* when) {
            QCoreApplication::processEvents();
            QVERIFY2(above->pos() == first && below->pos() == second, when);
        };
        area->say("bad", QStringLiteral("This did not work. Try it again."));
        stays("a notice");
        area->clear();
        stays("no notice");
        QCursor::setPos(window.mapToGlobal(QPoint(640, 10)));
        bar.tell({MessageKind::done, QStringLiteral("It was saved."), {}, {}});
        stays("a message");
        QVERIFY(bar.geometry().center().y() > window.height() / 2);
        bar.hide();
        QCursor::setPos(window.mapToGlobal(QPoint(640, 700)));
        bar.tell({MessageKind::done, QStringLiteral("It was saved."), {}, {}});
        QVERIFY(!bar.geometry().contains(window.mapFromGlobal(QCursor::pos())));
        window.resize(1100, 600);
        QCoreApplication::processEvents();
        QVERIFY(window.rect().contains(bar.geometry()));
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
