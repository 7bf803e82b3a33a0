// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/languages.h"
#include "database/access/access_table.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/frame/background.h"
#include "desktop/frame/command_palette.h"
#include "desktop/frame/focus_keeper.h"
#include "desktop/frame/help_dialogs.h"
#include "desktop/frame/instance_link.h"
#include "desktop/frame/interface_language.h"
#include "desktop/frame/key_names.h"
#include "desktop/frame/message_bar.h"
#include "desktop/login/login_screen.h"
#include "desktop/sessions/session_table_model.h"
#include "desktop/sessions/sessions_screen.h"
#include "desktop/settings/settings_screen.h"
#include "desktop/studies/studies_screen.h"
#include "desktop/widgets/logo.h"
#include "desktop/widgets/state_panel.h"
#include "gui/lists/many_sessions.h"
#include "support/desktop_fixture.h"
#include "support/image_region.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCursor>
#include <QDialog>
#include <QDir>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <memory>
#include <tuple>
#include <utility>

using chiron::tests::kPatience_ms;

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
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QLineEdit>(QStringLiteral("palette.field")), kPatience_ms);
        auto* field = desktop.find<QLineEdit>(QStringLiteral("palette.field"));
        QTest::keyClicks(field, QStringLiteral("settings"));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.screen<SettingsScreen>(), kPatience_ms);
    }

    /// As the access table has it: whoever may do what a screen is for finds the screen.
    void everyRoleFindsWhatItMayDo() {
        using database::Action;
        const std::pair<const char*, Action> screens[]{
            {"studies", Action::createStudy},    {"study_run", Action::beginRun},
            {"study_data", Action::studyTrials}, {"progress", Action::listPeople},
            {"people", Action::createPerson},    {"storage", Action::backup}};
        for (const char* person : {"ada", "tom", "rhea", "tina"}) {
            tests::DesktopFixture desktop;
            desktop.logIn(person);
            for (const auto& [screen, action] : screens) {
                const bool may = database::scopeOf(action, database::ActorKind::person,
                                                   desktop.actor(person).roles()) != database::Scope::none;
                const QString name = QStringLiteral("nav.") + QLatin1String(screen);
                QVERIFY2((desktop.find<QPushButton>(name) != nullptr) == may,
                         qPrintable(QString::fromLatin1(person) + QLatin1Char(' ') + name));
            }
        }
    }

    void anAdministratorFindsTheStudies() {
        tests::DesktopFixture desktop;
        desktop.logIn("ada");
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QPushButton>(QStringLiteral("home.studies")), kPatience_ms);
        QTest::keyClick(desktop.window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QLineEdit>(QStringLiteral("palette.field")), kPatience_ms);
        auto* field = desktop.find<QLineEdit>(QStringLiteral("palette.field"));
        QTest::keyClicks(field, QStringLiteral("studies"));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.screen<StudiesScreen>(), kPatience_ms);
    }

    /// Whoever scrolls a page with the pointer over a field does not change the field.
    void theWheelChangesNoClosedField() {
        tests::DesktopFixture desktop;
        QComboBox choice;
        choice.addItems({QStringLiteral("one"), QStringLiteral("two"), QStringLiteral("three")});
        choice.setCurrentIndex(1);
        QSpinBox number;
        number.setValue(7);
        const auto turn = [](QWidget& over, int by) {
            QWheelEvent wheel(QPointF(5.0, 5.0), over.mapToGlobal(QPointF(5.0, 5.0)), {}, {0, by},
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&over, &wheel);
            return wheel.isAccepted();
        };
        for (QWidget* field : {static_cast<QWidget*>(&choice), static_cast<QWidget*>(&number)}) {
            field->resize(120, 30);
            field->show();
            field->setFocus();
            for (const int by : {120, -120, 240})
                QVERIFY(!turn(*field, by));
        }
        QCOMPARE(choice.currentIndex(), 1);
        QCOMPARE(number.value(), 7);
    }

    /// Under that name below one's own, and by Ctrl+K; somebody who looks for "switch user" finds it, too.
    void loggingOutIsFound() {
        for (const char* typed : {"log out", "switch user", ""}) {
            tests::DesktopFixture desktop;
            desktop.logIn("tina");
            if (typed[0] == '\0') {
                auto* button = desktop.find<QPushButton>(QStringLiteral("nav.log_out"));
                QVERIFY(button && button->text() == QLatin1String("Log out"));
                button->click();
            } else {
                QTest::keyClick(desktop.window.get(), Qt::Key_K, Qt::ControlModifier);
                QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QLineEdit>(QStringLiteral("palette.field")),
                                         kPatience_ms);
                auto* field = desktop.find<QLineEdit>(QStringLiteral("palette.field"));
                QTest::keyClicks(field, QLatin1String(typed));
                QTest::keyClick(field, Qt::Key_Return);
            }
            QTRY_VERIFY_WITH_TIMEOUT(!desktop.context.loggedIn(), kPatience_ms);
            QCOMPARE(desktop.context.navigator().current().screen, QStringLiteral("login"));
        }
    }

    void entriesOfTheSideBarAreAsWideAsIt() {
        tests::DesktopFixture desktop;
        desktop.logIn("ada");
        desktop.window->resize(1600, 1100); // so high that nothing scrolls
        auto* entry = desktop.find<QPushButton>(QStringLiteral("nav.people"));
        QVERIFY(entry);
        const QWidget* view = entry->parentWidget()->parentWidget(); // of the list, which would scroll
        QTRY_COMPARE_WITH_TIMEOUT(entry->width(), view->width(), kPatience_ms);
        QCOMPARE(entry->parentWidget()->height(), view->height());
    }

    void languageThemeAndScaleChangeAtOnce() {
        tests::DesktopFixture desktop;
        desktop.logIn("tina");
        desktop.go(QStringLiteral("settings"));
        QTest::mouseClick(desktop.find<QRadioButton>(QStringLiteral("settings.theme.1")), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(desktop.context.theme().name(), ThemeName::dark, kPatience_ms);
        for (const QPalette::ColorRole role : {QPalette::Window, QPalette::Text, QPalette::Highlight})
            QCOMPARE(qApp->palette().color(role), desktop.context.theme().palette().color(role));
        QCOMPARE(qApp->styleSheet(), desktop.context.theme().styleSheet());
        QCOMPARE(qApp->font().pixelSize(), desktop.context.theme().font(TextStyle::body).pixelSize());
        QTest::mouseClick(desktop.find<QRadioButton>(QStringLiteral("settings.scale.200")), Qt::LeftButton,
                          {}, QPoint(5, 5));
        QTRY_COMPARE_WITH_TIMEOUT(desktop.context.theme().scale(), 2.0, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.screen<SettingsScreen>(), kPatience_ms); // still there, built anew
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
        QTRY_VERIFY_WITH_TIMEOUT(desktop.window->screen() != before, kPatience_ms);
    }

    void brokenSettingsGiveDefaults() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("broken.ini"));
        QFile broken(file);
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("language=klingon\ntheme=pink\nscale=huge\nsound=\n");
        broken.close();
        const Settings settings(file);
        QVERIFY(Settings::isLanguage(settings.language()));
        QCOMPARE(settings.theme(), ThemeName::light);
        QCOMPARE(settings.scale(), 1.0);
    }

    /// A language of the list is offered under its own name, has a catalogue of texts, and writes numbers in
    /// its own way; no other is.
    void everyLanguageOfTheListIsThere() {
        const auto choices = languageChoices();
        QCOMPARE(choices.size(), core::kLanguages.size());
        for (std::size_t i = 0; i < choices.size(); ++i) {
            const auto& [id, name] = choices[i];
            QCOMPARE(id.toStdString(), std::string(core::kLanguages[i].id));
            QVERIFY2(Settings::isLanguage(id), qPrintable(id));
            QCOMPARE(languageName(id), name);
            QCOMPARE(Settings::localeOf(id).name().toStdString(), std::string(core::kLanguages[i].locale));
            installLanguage(*QCoreApplication::instance(), id);
            QVERIFY2(QFile::exists(QStringLiteral(":/i18n/chiron_%1.qm").arg(id)), qPrintable(id));
        }
        installLanguage(*QCoreApplication::instance(), QStringLiteral("en"));
        for (const char* stranger : {"", "xx", "EN", "en_GB"})
            QVERIFY2(!Settings::isLanguage(QLatin1String(stranger)), stranger);
        QCOMPARE(Settings::localeOf(QStringLiteral("xx")), Settings::localeOf(QStringLiteral("en")));
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
            QCOMPARE(fresh.ofPerson(3, QStringLiteral("hand"), QStringLiteral("right")).toString(),
                     QStringLiteral("right"));
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
        QCOMPARE(read.ofPerson(3, QStringLiteral("hand"), QStringLiteral("right")).toString(),
                 QStringLiteral("left"));
        QCOMPARE(read.ofPerson(4, QStringLiteral("hand"), QStringLiteral("right")).toString(),
                 QStringLiteral("right")); // somebody else's
        for (const ThemeName theme : {ThemeName::dark, ThemeName::highContrast, ThemeName::light}) {
            Settings(file).setTheme(theme);
            QCOMPARE(Settings(file).theme(), theme);
        }
        for (const auto& [given, taken] : {std::pair{1.25, 1.25}, {2.5, 2.0}, {0.5, 1.0}, {2.0, 2.0}}) {
            Settings(file).setScale(given);
            QCOMPARE(Settings(file).scale(), taken);
        }
        for (const core::Language& language : core::kLanguages) {
            const QString id = QString::fromStdString(std::string(language.id));
            Settings(file).setLanguage(id);
            QCOMPARE(Settings(file).language(), id);
            QCOMPARE(Settings::localeOf(Settings(file).language()).name().toStdString(),
                     std::string(language.locale));
        }
    }

    /// Up and down stop at the ends of what was found; Enter runs what is chosen, Escape nothing.
    void paletteIsWalkedByArrows() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        QStringList ran;
        const auto command = [&](const char* text, const QKeySequence& keys) {
            return ScreenCommand{QLatin1String(text), keys, [&ran, text] { ran << QLatin1String(text); }};
        };
        const std::vector<CommandGroup> groups{
            {QStringLiteral("Here"), {command("Open it", {}), command("Save the list", QKeySequence::Save)}},
            {QStringLiteral("Places"),
             {command("Go to: Saved", {}), {QStringLiteral("Nothing to do"), {}, {}}}}};
        const auto open = [&] {
            auto* palette = new CommandPalette(theme, groups, nullptr);
            palette->show();
            return palette;
        };
        auto* palette = open();
        auto* field = palette->findChild<QLineEdit*>();
        auto* list = palette->findChild<QListWidget*>();
        QCOMPARE(list->count(), 4); // nothing typed: all
        QVERIFY2(list->item(1)->text().endsWith(QStringLiteral("(Ctrl+S)")),
                 qPrintable(list->item(1)->text()));
        QCOMPARE(list->item(0)->text(), QStringLiteral("Open it"));
        QCOMPARE(list->currentRow(), 0);
        for (const auto& [key, row] : {std::pair{Qt::Key_Up, 0},
                                       {Qt::Key_Down, 1},
                                       {Qt::Key_Down, 2},
                                       {Qt::Key_Down, 3},
                                       {Qt::Key_Down, 3},
                                       {Qt::Key_Up, 2}}) {
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
        emit palette->findChild<QListWidget*>()->itemClicked(
            palette->findChild<QListWidget*>()->item(0)); // what is chosen is the first
        QCOMPARE(ran.last(), QStringLiteral("Open it"));
        palette = open();
        QTest::keyClick(palette, Qt::Key_Escape);
        QCOMPARE(ran.size(), 2);
    }

    /// Lists of shortcuts name keys as all other texts do, in the language of the program.
    void keysAreNamedAsInTheTexts() {
        tests::DesktopFixture desktop; // in English
        QCOMPARE(shortcutInWords(QKeySequence(Qt::CTRL | Qt::Key_PageDown)),
                 QStringLiteral("Ctrl+Page Down"));
        QCOMPARE(shortcutInWords(QKeySequence(Qt::Key_PageUp)), QStringLiteral("Page Up"));
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter})
            QCOMPARE(shortcutInWords(QKeySequence(key)), QStringLiteral("Enter"));
        QCOMPARE(shortcutInWords(QKeySequence(Qt::Key_Delete)), QStringLiteral("Delete"));
        QCOMPARE(shortcutInWords(QKeySequence(Qt::CTRL | Qt::Key_K)), QStringLiteral("Ctrl+K"));
        QCOMPARE(shortcutInWords(QKeySequence(Qt::Key_Escape)), QStringLiteral("Esc"));
        QVERIFY(shortcutInWords({}).isEmpty());
        const CommandGroup group{
            QStringLiteral("Here"),
            {{QStringLiteral("Read on"), QKeySequence(Qt::CTRL | Qt::Key_PageDown), {}}}};
        QDialog* list = showShortcuts(desktop.context.theme(), {group}, desktop.window.get());
        CommandPalette palette(desktop.context.theme(), {group}, nullptr);
        QStringList shown;
        for (const auto* label : list->findChildren<QLabel*>())
            shown << label->text();
        QVERIFY2(shown.contains(QStringLiteral("Ctrl+Page Down")), qPrintable(shown.join(u'|')));
        const QString found = palette.findChild<QListWidget*>()->item(0)->text();
        QVERIFY2(found.endsWith(QStringLiteral("(Ctrl+Page Down)")), qPrintable(found));
        list->close();
        desktop.settings.setLanguage(QStringLiteral("de"));
        desktop.context.applyAppearance();
        QCOMPARE(shortcutInWords(QKeySequence(Qt::CTRL | Qt::Key_PageDown)), QStringLiteral("Strg+Bild ab"));
        QCOMPARE(shortcutInWords(QKeySequence(Qt::Key_Return)), QStringLiteral("Enter"));
        desktop.settings.setLanguage(QStringLiteral("en"));
        desktop.context.applyAppearance();
    }

    /// Messages: what kind is seen and heard, errors stay until they are closed, an action is done once and
    /// the message goes.
    void messagesAreSaidByTheirKind() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        MessageBar bar(theme);
        QVERIFY(bar.isHidden());
        auto* timer = bar.findChild<QTimer*>();
        for (const auto& [kind, look, icon, ink] :
             {std::tuple{MessageKind::done, "good", "dialog-ok-apply", Colour::good},
              {MessageKind::information, "info", "dialog-information", Colour::accent},
              {MessageKind::warning, "warning", "dialog-warning", Colour::warning},
              {MessageKind::error, "bad", "dialog-error", Colour::bad}}) {
            bar.tell({kind, QStringLiteral("words of kind %1").arg(static_cast<int>(kind)), {}, {}});
            QVERIFY(!bar.isHidden());
            QCOMPARE(bar.property("kind").toString(), QLatin1String(look));
            QCOMPARE(bar.findChild<QLabel*>(QStringLiteral("messages.text"))->text(),
                     QStringLiteral("words of kind %1").arg(static_cast<int>(kind)));
            const QPixmap sign = bar.findChildren<QLabel*>().front()->pixmap();
            QCOMPARE(sign.toImage(), theme.icon(QLatin1String(icon), ink).pixmap(sign.size()).toImage());
            QCOMPARE(timer->isActive(), kind != MessageKind::error);
            QVERIFY(timer->isSingleShot() && timer->interval() >= 5000);
            QVERIFY(bar.findChild<QPushButton*>(QStringLiteral("messages.action"))->isHidden());
        }
        int undone = 0;
        bar.tell(
            {MessageKind::done, QStringLiteral("Archived"), QStringLiteral("Undo"), [&undone] { ++undone; }});
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
        QTRY_VERIFY_WITH_TIMEOUT(bar.isHidden(), kPatience_ms);
    }

    /// Nothing moves under the pointer when something is said, and nothing is said between the pointer and
    /// what it points at.
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

    /// In its room: long words are shortened there and shown whole when asked for; short ones are not.
    void longMessagesStayInTheirRoom() {
        for (const double scale : {1.0, 2.0}) {
            tests::DesktopFixture desktop;
            desktop.settings.setScale(scale);
            desktop.context.applyAppearance();
            desktop.logIn("tina");
            desktop.go(QStringLiteral("settings"));
            QTRY_VERIFY_WITH_TIMEOUT(desktop.screen<SettingsScreen>(), kPatience_ms);
            const int height = desktop.window->screen()->height();
            desktop.context.messages().done(QStringLiteral("It was saved."));
            auto* bar = desktop.find<MessageBar>(QStringLiteral("messages"));
            auto* more = desktop.find<QPushButton>(QStringLiteral("messages.more"));
            auto* text = desktop.find<QLabel>(QStringLiteral("messages.text"));
            QCoreApplication::processEvents();
            QVERIFY(bar->isVisible() && !more->isVisible());
            QCOMPARE(text->text(), QStringLiteral("It was saved."));
            const QRect place = bar->geometry();
            QString whole = QStringLiteral("The beginning.");
            for (int i = 0; i < 60; ++i)
                whole += QStringLiteral(" What happened was long, number %1.").arg(i);
            desktop.context.messages().tell({MessageKind::error, whole, QStringLiteral("Undo"), {}});
            QCoreApplication::processEvents();
            QCOMPARE(bar->geometry(), place);
            QVERIFY(more->isVisible() && text->text().startsWith(QStringLiteral("The beginning.")) &&
                    text->text().endsWith(QStringLiteral("…")));
            QVERIFY2(
                text->heightForWidth(text->width()) <= text->height() + 2,
                qPrintable(
                    QStringLiteral("%1 of %2").arg(text->height()).arg(text->heightForWidth(text->width()))));
            QCOMPARE(text->accessibleName(), whole);
            QCOMPARE(desktop.window->screen()->height(), height); // nothing made room for it
            more->click();
            QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QLabel>(QStringLiteral("words.text")), kPatience_ms);
            QCOMPARE(desktop.find<QLabel>(QStringLiteral("words.text"))->text(), whole);
            desktop.find<QDialog>(QStringLiteral("words"))->close();
        }
    }

    /// Long work says what it does just now, below what was announced.
    void longWorkSaysWhatItDoes() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        StatePanel panel(theme);
        const auto token = std::make_shared<WorkToken>();
        token->setDoing(QStringLiteral("The third of five"));
        panel.showLoading(QStringLiteral("Making it …"), token);
        panel.show();
        const auto says = [&panel] {
            for (const QLabel* label : panel.findChildren<QLabel*>())
                if (label->text() == QStringLiteral("Making it …\nThe third of five"))
                    return true;
            return false;
        };
        QVERIFY(!says()); // short work does not flicker
        QTRY_VERIFY_WITH_TIMEOUT(says(), kPatience_ms);
    }

    /// The bar fills if the work tells how far it is; otherwise it has no end and only moves.
    void workOfUnknownLengthIsShownAsBusy() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        StatePanel counted(theme), uncounted(theme);
        const auto token = std::make_shared<WorkToken>();
        token->setProgress(40, 100);
        counted.showLoading(QStringLiteral("Reading …"), token);
        uncounted.showLoading(QStringLiteral("Reading …"), nullptr);
        counted.show();
        uncounted.show();
        const auto shown = [](const StatePanel& panel) {
            const auto* bar = panel.findChild<QProgressBar*>();
            return bar && bar->isVisible() ? bar : nullptr;
        };
        QTRY_VERIFY_WITH_TIMEOUT(shown(counted) && shown(uncounted), kPatience_ms);
        const QProgressBar& fills = *shown(counted);
        QVERIFY(fills.minimum() == 0 && fills.maximum() == 100 && fills.value() == 40);
        const QProgressBar& moves = *shown(uncounted);
        QVERIFY(moves.minimum() == 0 && moves.maximum() == 0);
    }

    /// On a screen Enter presses the button that has the focus, once however long it is held; nothing else
    /// changes its meaning.
    void enterPressesTheFocusedButton() {
        tests::DesktopFixture desktop;
        desktop.logIn("tina");
        auto* settings = desktop.find<QPushButton>(QStringLiteral("nav.settings"));
        settings->setFocus();
        QTest::keyClick(settings, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.screen<SettingsScreen>(), kPatience_ms);
        int pressed = 0;
        QWidget* const page = desktop.window->screen();
        const auto add = [&](QAbstractButton* button) {
            button->setParent(page);
            button->resize(60, 30);
            button->show();
            connect(button, &QAbstractButton::clicked, this, [&pressed] { ++pressed; });
            button->setFocus();
            return button;
        };
        auto* push = add(new QPushButton);
        QTest::keyClick(push, Qt::Key_Enter, Qt::KeypadModifier);
        QCOMPARE(pressed, 1);
        QTest::keyClick(push, Qt::Key_Return, Qt::ControlModifier); // a shortcut of somebody else
        QCOMPARE(pressed, 1);
        QKeyEvent held(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, QString(), true);
        QApplication::sendEvent(push, &held);
        QCOMPARE(pressed, 1);
        QTest::keyClick(add(new QToolButton), Qt::Key_Return);
        QCOMPARE(pressed, 2);
        QTest::keyClick(add(new QRadioButton), Qt::Key_Return); // is chosen by Space, as everywhere
        QCOMPARE(pressed, 2);
        push->setFocus();
        QLineEdit field(page);
        field.show();
        field.setFocus();
        QSignalSpy entered(&field, &QLineEdit::returnPressed);
        QTest::keyClick(&field, Qt::Key_Return);
        QCOMPARE(entered.count(), 1);
        QCOMPARE(pressed, 2);
    }

    /// What a button began disables it: the focus is in the list that was worked in, on the same line.
    void focusReturnsToTheList() {
        tests::DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 5);
        desktop.logIn("tom");
        desktop.go(QStringLiteral("sessions"));
        auto* screen = desktop.screen<SessionsScreen>();
        QTRY_VERIFY_WITH_TIMEOUT(screen->isComplete(), kPatience_ms);
        auto* table = desktop.find<QTableView>(QStringLiteral("sessions.table"));
        table->setFocus();
        table->selectRow(2);
        const auto chosen = screen->model().at(2).summary.id;
        auto* voids = desktop.find<QPushButton>(QStringLiteral("sessions.void"));
        voids->setFocus();
        QTest::keyClick(voids, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QPlainTextEdit>(QStringLiteral("void.reason")), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(
            QApplication::focusWidget(),
            static_cast<QWidget*>(desktop.find<QPlainTextEdit>(QStringLiteral("void.reason"))),
            kPatience_ms);                 // ready to type
        const auto comeBack = [&desktop] { // as a window manager does when a dialog has closed
            desktop.window->activateWindow();
            return QTest::qWaitForWindowActive(desktop.window.get());
        };
        QTest::keyClick(QApplication::activeModalWidget(), Qt::Key_Escape);
        QVERIFY(comeBack());
        QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), static_cast<QWidget*>(voids),
                                  kPatience_ms); // nothing was done: where it was
        QTest::keyClick(voids, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(QApplication::activeModalWidget(), kPatience_ms);
        QApplication::activeModalWidget()->findChild<QPlainTextEdit*>()->setPlainText(
            QStringLiteral("wrong hand"));
        QApplication::activeModalWidget()->findChild<QPushButton*>(QStringLiteral("void.confirm"))->click();
        QVERIFY(comeBack());
        QTRY_COMPARE_WITH_TIMEOUT(screen->model().at(2).summary.state, database::SessionState::voided,
                                  kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), static_cast<QWidget*>(table), kPatience_ms);
        QCOMPARE(table->currentIndex().row(), 2);
        QCOMPARE(screen->model().at(2).summary.id, chosen);
    }

    /// Without a list the control has the focus again as soon as it can take it; unless somebody has moved
    /// on.
    void focusReturnsToTheControl() {
        tests::DesktopFixture desktop;
        desktop.logIn("tina");
        desktop.go(QStringLiteral("settings"));
        auto* first = desktop.find<QRadioButton>(QStringLiteral("settings.theme.0"));
        auto* other =
            desktop.find<QCheckBox>(QStringLiteral("settings.sound")); // not the one that Qt would choose
        for (const bool hide : {false, true}) {
            first->setFocus();
            QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), static_cast<QWidget*>(first),
                                      kPatience_ms);
            if (hide)
                first->hide();
            else
                first->setEnabled(false);
            QVERIFY(QApplication::focusWidget() != first);
            if (hide)
                first->show();
            else
                first->setEnabled(true);
            QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), static_cast<QWidget*>(first),
                                      kPatience_ms);
        }
        first->setEnabled(false);
        QCoreApplication::processEvents();
        other->setFocus();
        first->setEnabled(true);
        QTest::qWait(20);
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(other));
    }

    /// When a page goes with its control, the focus stays near it; but not where somebody, or the program,
    /// has put it elsewhere meanwhile.
    void focusStaysWhereItWasPut() {
        QWidget window;
        new FocusKeeper(window);
        auto* column = new QVBoxLayout(&window);
        const auto button = [](const char* name, QLayout& in) {
            auto* made = new QPushButton(QLatin1String(name));
            in.addWidget(made);
            return made;
        };
        button("side", *column);
        auto* search = new QLineEdit;
        column->addWidget(search);
        auto* holder = new QWidget;
        auto* pages = new QVBoxLayout(holder);
        column->addWidget(holder);
        QPushButton* stays = button("stays", *pages);
        QWidget other;
        auto* elsewhere = new QLineEdit(&other);
        window.show();
        other.show();
        const auto activate = [](QWidget& which) {
            which.activateWindow();
            return QTest::qWaitForWindowActive(&which);
        };
        const auto worksOnAPage = [&] {
            auto page = std::make_unique<QWidget>();
            QPushButton* on = button("on the page", *new QVBoxLayout(page.get()));
            pages->addWidget(page.get());
            page->show();
            const bool active = activate(window);
            on->setFocus(Qt::TabFocusReason);
            if (!active || QApplication::focusWidget() != on)
                page.reset();
            return page;
        };
        const auto at = [](const QWidget* control) { return QApplication::focusWidget() == control; };

        auto page = worksOnAPage();
        QVERIFY(page);
        page.reset();
        QTRY_VERIFY_WITH_TIMEOUT(at(stays), kPatience_ms); // rather than nowhere

        page = worksOnAPage();
        QVERIFY(page);
        page.reset();
        search->setFocus(Qt::OtherFocusReason); // as code does
        QTest::qWait(20);
        QVERIFY(at(search));

        page = worksOnAPage();
        QVERIFY(page && activate(other));
        elsewhere->setFocus();
        page.reset(); // a list is read anew in the background
        QVERIFY(activate(window));
        QTRY_VERIFY_WITH_TIMEOUT(at(stays), kPatience_ms);

        page = worksOnAPage();
        QVERIFY(page && activate(other));
        page.reset();
        search->setFocus(Qt::MouseFocusReason); // as a click by which somebody comes back does
        QVERIFY(activate(window));
        QTest::qWait(20);
        QVERIFY(at(search));
    }

    /// The sign is a picture of its own in every size, and it stands where the program says its name.
    void logoIsShown() {
        for (const int size : {16, 32, 256}) {
            const QImage sign = logoIcon().pixmap(size, size).toImage();
            QCOMPARE(sign.width(), size);
            // Round: what is behind it shows in the corners, and the disc reaches the middle of each side.
            const QRegion clear = tests::regionOfAlpha(sign, 0), solid = tests::regionOfAlpha(sign, 255);
            for (const QPoint corner :
                 {QPoint(0, 0), QPoint(size - 1, 0), QPoint(0, size - 1), QPoint(size - 1, size - 1)})
                QVERIFY(clear.contains(corner));
            for (const QPoint side : {QPoint(size / 2, 1), QPoint(size / 2, size - 2), QPoint(1, size / 2),
                                      QPoint(size - 2, size / 2)})
                QVERIFY(!clear.contains(side));
            QVERIFY2(tests::areaOf(solid) > size * size / 2, qPrintable(QString::number(size)));
            QVERIFY(!sign.allGray()); // a disc in its colour, with a hand that is lighter
            QVERIFY(sign != tests::inOneColour(sign, QColor(0, 0x58, 0x7d)));
        }
        tests::DesktopFixture desktop;
        QVERIFY(!desktop.window->windowIcon().isNull());
        desktop.context.navigator().replace({QStringLiteral("login"), {}});
        QVERIFY(desktop.find<QLabel>(QStringLiteral("logo")) &&
                !desktop.find<QLabel>(QStringLiteral("logo"))->pixmap().isNull());
        desktop.context.navigator().replace({QStringLiteral("first_start"), {}});
        QTRY_VERIFY_WITH_TIMEOUT(desktop.window->screen()->findChild<QLabel*>(QStringLiteral("logo")),
                                 kPatience_ms);
        desktop.logIn("tina");
        QTest::keyClick(desktop.window.get(), Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QLineEdit>(QStringLiteral("palette.field")), kPatience_ms);
        QTest::keyClicks(desktop.find<QLineEdit>(QStringLiteral("palette.field")), QStringLiteral("about"));
        QTest::keyClick(desktop.find<QLineEdit>(QStringLiteral("palette.field")), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QDialog>(QStringLiteral("about")), kPatience_ms);
        auto* about = desktop.find<QDialog>(QStringLiteral("about"));
        QVERIFY(about->findChild<QLabel*>(QStringLiteral("logo")));
        QVERIFY(!about->findChild<QLabel*>(QStringLiteral("about.build"))->text().isEmpty());
        about->findChild<QPushButton*>(QStringLiteral("about.close"))->click();
    }

    void secondProgramRaisesTheFirst() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("site.db"));
        QVERIFY(!InstanceLink::raiseOther(file)); // nobody listens
        InstanceLink first(file);
        QVERIFY(first.listen());
        QSignalSpy raised(&first, &InstanceLink::raiseAsked);
        QVERIFY(InstanceLink::raiseOther(file));
        QTRY_COMPARE_WITH_TIMEOUT(raised.count(), 1, kPatience_ms);
    }

    /// The name of a socket holds 107 letters and a zero.
    void aNameThatIsTooLongForASocketIsRefused() {
        QTemporaryDir folder;
        const QByteArray before = qgetenv("XDG_RUNTIME_DIR");
        const auto putBack = qScopeGuard([&before] {
            before.isNull() ? qunsetenv("XDG_RUNTIME_DIR") : qputenv("XDG_RUNTIME_DIR", before);
        });
        const auto own = QStringLiteral("/chiron-.socket").size() + 24; // with a part of a digest
        for (const qsizetype length : {107, 108}) {
            const qsizetype rest = length - own - folder.path().size() - 1;
            QVERIFY(rest > 0);
            const QString runtime = folder.filePath(QString(rest, QLatin1Char('x')));
            QVERIFY(QDir().mkpath(runtime) &&
                    QFile::setPermissions(runtime, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner));
            qputenv("XDG_RUNTIME_DIR", runtime.toLocal8Bit());
            InstanceLink link(folder.filePath(QStringLiteral("site.db")));
            QCOMPARE(link.listen().has_value(), length == 107);
        }
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
