// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/study_reader.h"
#include "desktop/debrief/debrief_screen.h"
#include "desktop/exercise_setup/exercise_setup_screen.h"
#include "desktop/frame/command_palette.h"
#include "desktop/frame/palette_search.h"
#include "desktop/people/people_screen.h"
#include "desktop/sessions/sessions_screen.h"
#include "gui/lists/many_sessions.h"
#include "support/desktop_fixture.h"
#include "support/made_study.h"
#include "support/patience.h"

#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTimer>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::desktop;

namespace {

using tests::DesktopFixture;

/// The palette as it is after these letters were typed and everything was found.
class Palette {
public:
    explicit Palette(DesktopFixture& desktop) : m_desktop(desktop) {
        desktop.window->activateWindow(); // as a window manager does when a dialog has closed
        (void)QTest::qWaitForWindowActive(desktop.window.get());
        QTest::keyClick(desktop.window.get(), Qt::Key_K, Qt::ControlModifier);
        (void)QTest::qWaitFor([this] { return field() != nullptr; }, kPatience_ms);
    }
    QLineEdit* field() const { return m_desktop.find<QLineEdit>(QStringLiteral("palette.field")); }
    QListWidget* list() const { return m_desktop.find<QListWidget>(QStringLiteral("palette.list")); }
    void type(const QString& text) {
        field()->setText(text);
        QTest::qWait(200); // letters may still come: then it looks
        (void)QTest::qWaitFor([this] { return m_desktop.context.background().idle(); }, kPatience_ms);
    }
    /// Lines below this heading, up to the next.
    QStringList below(const QString& heading) const {
        QStringList lines;
        bool inside = false;
        for (int row = 0; row < list()->count(); ++row) {
            const QListWidgetItem* item = list()->item(row);
            const bool isHeading = !item->flags().testFlag(Qt::ItemIsSelectable);
            if (inside && isHeading)
                break;
            if (inside)
                lines << item->text();
            inside = inside || (isHeading && item->text().startsWith(heading));
        }
        return lines;
    }
    QStringList headings() const {
        QStringList titles;
        for (int row = 0; row < list()->count(); ++row)
            if (!list()->item(row)->flags().testFlag(Qt::ItemIsSelectable))
                titles << list()->item(row)->text();
        return titles;
    }
    bool choose(const QString& text) {
        for (int row = 0; row < list()->count(); ++row)
            if (list()->item(row)->text().startsWith(text)) {
                list()->setCurrentRow(row);
                QTest::keyClick(field(), Qt::Key_Return);
                return true;
            }
        return false;
    }
    void close() { QTest::keyClick(field(), Qt::Key_Escape); }

private:
    DesktopFixture& m_desktop;
};

} // namespace

/// Ctrl+K finds people, exercises, sessions, studies, and what can be done on other screens.
class TestPaletteSearch : public QObject {
    Q_OBJECT
private slots:
    void wordsAreFoundInAnyOrder();
    void peopleLeadToTheirPlace();
    void exercisesAndSessionsOpen();
    void nobodyFindsWhatIsNotTheirs();
    void studiesAreTheResearchers();
    void otherScreensCommandsLeadThere();
    void otherWordsLeadThere_data();
    void otherWordsLeadThere();
    void arrowsPassTheHeadings();
    void lettersInOnePieceGoBeforeNames();
    void tenThousandSessionsAreCapped();
};

void TestPaletteSearch::wordsAreFoundInAnyOrder() {
    SearchIndex index;
    auto& people = index.things[static_cast<std::size_t>(ThingKind::person)];
    for (const char* name : {"Martina Ober", "Tina Trainee", "Tína Ω Other"})
        people.push_back({QString::fromUtf8(name), forSearch(QString::fromUtf8(name)), {}});
    const auto find = [&](const char* typed, int most) {
        QStringList names;
        for (const NamedThing* thing :
             findThings(index, ThingKind::person, QString::fromUtf8(typed), most).best)
            names << thing->text;
        return names;
    };
    QCOMPARE(find("tina", 9), (QStringList{QStringLiteral("Tina Trainee"), QStringLiteral("Tína Ω Other"),
                                           QStringLiteral("Martina Ober")})); // beginnings first
    QCOMPARE(find("tr TI", 9), QStringList{QStringLiteral("Tina Trainee")});
    QCOMPARE(find("ω", 9).size(), 1);
    QVERIFY(find("tinx", 9).isEmpty() && find("  ", 9).isEmpty());
    QCOMPARE(find("tina", 1).size(), 1);
    QCOMPARE(findThings(index, ThingKind::person, QStringLiteral("tina"), 1).all, 3);
    people.clear();
    for (const char* name : {"Anna Mothering", "Zoe Other"})
        people.push_back({QString::fromUtf8(name), forSearch(QString::fromUtf8(name)), {}});
    QCOMPARE(find("other", 9), (QStringList{QStringLiteral("Zoe Other"), // the beginning of any word
                                            QStringLiteral("Anna Mothering")}));
}

void TestPaletteSearch::peopleLeadToTheirPlace() {
    DesktopFixture desktop;
    desktop.addSession("tina", 1, "expert", 1, 1, 5.0);
    desktop.logIn("ada");
    {
        Palette palette(desktop);
        palette.type(QStringLiteral("trainee tin"));
        QCOMPARE(palette.below(QStringLiteral("People")), QStringList{QStringLiteral("Tina Trainee (tina)")});
        QVERIFY(palette.headings().contains(QStringLiteral("People"))); // all of them, so no number
        QVERIFY(palette.choose(QStringLiteral("Tina Trainee")));
    }
    QTRY_VERIFY_WITH_TIMEOUT(desktop.screen<PeopleScreen>(), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(
        desktop.find<QLabel>(QStringLiteral("people.chosen"))->text().contains(QStringLiteral("tina")),
        kPatience_ms);
    desktop.logIn("tom"); // a trainer looks at what somebody did
    Palette palette(desktop);
    palette.type(QStringLiteral("tina"));
    QVERIFY(palette.choose(QStringLiteral("Tina Trainee")));
    QTRY_VERIFY_WITH_TIMEOUT(desktop.screen<SessionsScreen>(), kPatience_ms);
    QCOMPARE(desktop.context.navigator().current().parameters.value(QStringLiteral("person")).toLongLong(),
             desktop.actor("tina").personId());
}

void TestPaletteSearch::exercisesAndSessionsOpen() {
    DesktopFixture desktop;
    const auto id = desktop.addSession("tina", 1, "expert", 1, 1, 5.0);
    desktop.logIn("tina");
    {
        Palette palette(desktop);
        palette.type(QStringLiteral("apex level 2"));
        const QStringList exercises = palette.below(QStringLiteral("Exercises"));
        QVERIFY(!exercises.isEmpty() && exercises.front().contains(QStringLiteral("level 2")));
        QVERIFY(palette.choose(exercises.front()));
    }
    QTRY_VERIFY_WITH_TIMEOUT(desktop.screen<ExerciseSetupScreen>(), kPatience_ms);
    QCOMPARE(desktop.context.navigator().current().parameters.value(QStringLiteral("level")).toInt(), 2);
    Palette palette(desktop);
    palette.type(QStringLiteral("session %1").arg(id));
    QVERIFY(palette.choose(QStringLiteral("Session %1:").arg(id)));
    QTRY_VERIFY_WITH_TIMEOUT(desktop.screen<DebriefScreen>(), kPatience_ms);
    QCOMPARE(desktop.context.navigator().current().parameters.value(QStringLiteral("session")).toLongLong(),
             id);
}

void TestPaletteSearch::nobodyFindsWhatIsNotTheirs() {
    DesktopFixture desktop;
    desktop.addSession("theo", 1, "expert", 1, 1, 5.0);
    desktop.logIn("tina");
    {
        Palette palette(desktop);
        palette.type(QStringLiteral("theo"));
        QVERIFY(palette.below(QStringLiteral("People")).isEmpty());
        QVERIFY(palette.below(QStringLiteral("Sessions")).isEmpty());
        palette.close();
    }
    desktop.logIn("rhea"); // by code, not by name
    Palette palette(desktop);
    palette.type(QStringLiteral("theo"));
    QVERIFY(palette.below(QStringLiteral("People")).isEmpty() &&
            palette.below(QStringLiteral("Sessions")).isEmpty());
    palette.type(QStringLiteral("session 1"));
    QCOMPARE(palette.below(QStringLiteral("Sessions")).size(), 1);
    palette.close();
}

void TestPaletteSearch::studiesAreTheResearchers() {
    DesktopFixture desktop;
    const tests::VisitedStudies studies = tests::addVisitedStudies(desktop);
    QVERIFY(studies.data != 0);
    desktop.logIn("rhea");
    QString title;
    {
        auto reader = desktop.database().openReader();
        title = QString::fromStdString(
            database::StudyReader(**reader, desktop.actor("rhea")).study(studies.data)->summary.title);
    }
    Palette palette(desktop);
    palette.type(title.left(8));
    QVERIFY2(!palette.below(QStringLiteral("Studies")).isEmpty(), qPrintable(title));
    QVERIFY(palette.choose(palette.below(QStringLiteral("Studies")).front()));
    QTRY_COMPARE_WITH_TIMEOUT(desktop.context.navigator().current().screen, QStringLiteral("study"),
                              kPatience_ms);
    desktop.logIn("tina");
    Palette hers(desktop);
    hers.type(title.left(8));
    QVERIFY(hers.below(QStringLiteral("Studies")).isEmpty());
    hers.close();
}

void TestPaletteSearch::otherScreensCommandsLeadThere() {
    DesktopFixture desktop;
    desktop.logIn("ada");
    {
        Palette palette(desktop);
        QTest::qWait(300); // one screen a turn
        palette.type(QStringLiteral("back up now"));
        QCOMPARE(palette.below(QStringLiteral("On other screens")),
                 QStringList{QStringLiteral("Storage: Back up now")});
        QVERIFY(palette.choose(QStringLiteral("Storage: Back up now")));
    }
    QTRY_COMPARE_WITH_TIMEOUT(desktop.context.navigator().current().screen, QStringLiteral("storage"),
                              kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(desktop.window->focusWidget() && desktop.window->focusWidget()->objectName() ==
                                                                  QLatin1String("storage.back_up"),
                             kPatience_ms);
    QVERIFY(!QDir(desktop.folder()).exists(QStringLiteral("backups"))); // nothing is done before it is seen
    for (const char* person : {"tina", "ada"}) { // what there is is looked for again for everybody
        desktop.logIn(person);
        Palette palette(desktop);
        QTest::qWait(300);
        palette.type(QStringLiteral("back up now"));
        QCOMPARE(palette.below(QStringLiteral("On other screens")),
                 person == std::string("ada") ? QStringList{QStringLiteral("Storage: Back up now")}
                                              : QStringList());
        palette.close();
    }
}

void TestPaletteSearch::otherWordsLeadThere_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("person");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("screen");
    const auto add = [](const char* language, const char* person, const char* typed, const char* screen) {
        QTest::addRow("%s %s: %s", language, person, typed)
            << QString::fromLatin1(language) << QString::fromLatin1(person) << QString::fromUtf8(typed)
            << QString::fromLatin1(screen);
    };
    for (const char* word : {"group", "progress", "overview", "class", "results"})
        add("en", "tom", word, "progress");
    add("en", "tom", "review", "sessions");
    add("en", "tom", "feedback", "sessions");
    add("en", "ada", "backup", "storage");
    add("en", "ada", "users", "people");
    add("en", "tina", "scores", "results");
    add("en", "tina", "log out", "login");
    for (const char* word : {"Gruppe", "Fortschritt", "Übersicht", "Kurs", "Ergebnisse"})
        add("de", "tom", word, "progress");
    add("de", "tom", "Begutachtung", "sessions");
    add("de", "ada", "Sicherung", "storage");
    add("de", "tina", "abmelden", "login");
    for (const char* word : {"ομάδα", "πρόοδος", "επισκόπηση", "τάξη", "αποτελέσματα"})
        add("el", "tom", word, "progress");
    add("el", "tom", "αξιολόγηση", "sessions");
    add("el", "ada", "αντίγραφο", "storage");
    add("el", "tina", "αποσύνδεση", "login");
}

/// The first line that is found by another word than its own leads to the right screen, and says why it is
/// there.
void TestPaletteSearch::otherWordsLeadThere() {
    QFETCH(QString, language);
    QFETCH(QString, person);
    QFETCH(QString, typed);
    QFETCH(QString, screen);
    DesktopFixture desktop;
    desktop.context.settings().setLanguage(language);
    desktop.context.applyAppearance();
    desktop.logIn(person.toStdString());
    Palette palette(desktop);
    palette.field()->setText(typed); // at once: nobody waits for what is read
    QTest::keyClick(palette.field(), Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(desktop.context.navigator().current().screen, screen, kPatience_ms);
    desktop.context.settings().setLanguage(QStringLiteral("en")); // the translators are the program's
    desktop.context.applyAppearance();
}

void TestPaletteSearch::arrowsPassTheHeadings() {
    const Theme theme = Theme::load(ThemeName::light, 1.0).value();
    QStringList ran;
    const auto command = [&ran](const char* text) {
        return ScreenCommand{QLatin1String(text), {}, [&ran, text] { ran << QLatin1String(text); }};
    };
    auto* palette = new CommandPalette(
        theme, {{QStringLiteral("Here"), {command("Go to: Tina's box"), command("Train again")}}}, nullptr);
    palette->show();
    auto* field = palette->findChild<QLineEdit*>();
    auto* list = palette->findChild<QListWidget*>();
    field->setText(QStringLiteral("tina"));
    palette->showFound({{QStringLiteral("People"), {command("Tina"), command("Martina")}}},
                       QStringLiteral("some words"));
    QStringList lines;
    for (int row = 0; row < list->count(); ++row)
        lines << list->item(row)->text();
    // Heading, command, heading, two people, heading, what merely has the letters.
    QCOMPARE(lines.mid(0, 5),
             (QStringList{QStringLiteral("Commands"), QStringLiteral("Go to: Tina's box"),
                          QStringLiteral("People"), QStringLiteral("Tina"), QStringLiteral("Martina")}));
    QVERIFY(palette->findChild<QLabel*>(QStringLiteral("palette.words"))->isVisible());
    QCOMPARE(list->currentRow(), 1);
    QTest::keyClick(field, Qt::Key_Down);
    QCOMPARE(list->currentRow(), 3);
    QTest::keyClick(field, Qt::Key_Up);
    QCOMPARE(list->currentRow(), 1);
    QTest::keyClick(field, Qt::Key_Up);
    QCOMPARE(list->currentRow(), 1);
    QTest::keyClick(field, Qt::Key_Down);
    palette->showFound({{QStringLiteral("Studies"), {command("Tinajero")}},
                        {QStringLiteral("People"), {command("Tina"), command("Martina")}}},
                       {});
    QCOMPARE(list->currentItem()->text(),
             QStringLiteral("Tina")); // what came later took nothing from under the hand
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(ran, QStringList{QStringLiteral("Tina")});
}

/// A command that has the letters in one piece is meant before a name, others after it.
void TestPaletteSearch::lettersInOnePieceGoBeforeNames() {
    const Theme theme = Theme::load(ThemeName::light, 1.0).value();
    const auto command = [](const char* text) { return ScreenCommand{QLatin1String(text), {}, [] {}}; };
    auto* palette = new CommandPalette(
        theme, {{QStringLiteral("Here"), {command("Retinal view"), command("Train again")}}}, nullptr);
    palette->show();
    palette->findChild<QLineEdit*>()->setText(QStringLiteral("tina"));
    palette->showFound({{QStringLiteral("People"), {command("Tina")}}}, {});
    const auto* list = palette->findChild<QListWidget*>();
    QStringList lines;
    for (int row = 0; row < list->count(); ++row)
        lines << list->item(row)->text();
    QCOMPARE(lines.mid(0, 5), (QStringList{QStringLiteral("Commands"), QStringLiteral("Retinal view"),
                                           QStringLiteral("People"), QStringLiteral("Tina"),
                                           QStringLiteral("Further commands")}));
    palette->close();
}

void TestPaletteSearch::tenThousandSessionsAreCapped() {
    DesktopFixture desktop;
    tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 10'000);
    desktop.logIn("tom");
    Palette palette(desktop);
    int turns = 0;
    QTimer turn;
    connect(&turn, &QTimer::timeout, this, [&turns] { ++turns; });
    turn.start(0);
    palette.type(QStringLiteral("tina"));
    QVERIFY(turns > 10); // the window was alive meanwhile
    QCOMPARE(palette.below(QStringLiteral("Sessions")).size(), 6);
    QVERIFY(palette.list()->count() < 60);
    palette.type(QStringLiteral("session 9999"));
    QCOMPARE(palette.below(QStringLiteral("Sessions")).size(), 1);
    palette.close();
}

QTEST_MAIN(TestPaletteSearch)
#include "test_palette_search.moc"
