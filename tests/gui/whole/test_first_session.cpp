// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/session_reader.h"
#include "desktop/debrief/debrief_screen.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/main_window.h"
#include "desktop/frame/program.h"
#include "desktop/frame/screen.h"
#include "gui/accounts/hands.h"
#include "support/content_copy.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QLabel>
#include <QScopeGuard>
#include <QTemporaryDir>

using namespace chiron;
using namespace chiron::tests;

namespace {

constexpr const char* kPassword = "eleven-fine-horses";

/// The shipped content with two spheres in the first level, so that a set takes seconds.
class ShortContent {
public:
    ShortContent() {
        const QString level = QStringLiteral("exercises/sphere_apex/levels/visible.json");
        QByteArray json = m_copy.read(level);
        json.replace("\"trials\": 10", "\"trials\": 2");
        m_copy.write(level, json);
        qputenv("CHIRON_CONTENT", QByteArray::fromStdString(m_copy.directory()));
    }
    ~ShortContent() { qunsetenv("CHIRON_CONTENT"); }

private:
    ContentCopy m_copy;
};

/// The program on a station that has no site, or the one in this folder.
class Station {
public:
    explicit Station(const QTemporaryDir& folder)
        : settings(folder.filePath(QStringLiteral("desktop.ini"))),
          site(folder.filePath(QStringLiteral("site.db")), cheap()), context(site, settings) {
        settings.setLanguage(QStringLiteral("en"));
        settings.setSound(false);
        desktop::applyAppearance(*qApp, context);
        QObject::connect(&context, &desktop::AppContext::appearanceChanged, qApp,
                         [this] { desktop::applyAppearance(*qApp, context); });
        window = std::make_unique<desktop::MainWindow>(context);
        context.navigator().replace(
            {site.exists() ? QStringLiteral("login") : QStringLiteral("first_start"), {}});
        window->show();
        window->activateWindow();
        if (!QTest::qWaitForWindowActive(window.get()))
            qFatal("the window did not become active");
        if (site.exists())
            context.openSite();
    }
    ~Station() {
        context.background().cancelAndWait();
        window.reset();
    }
    static database::DatabaseOptions cheap() {
        database::DatabaseOptions options;
        options.passwordCost = database::PasswordCost::minimalForTests();
        return options;
    }
    bool isOn(const char* screen) const {
        return window->screen() &&
               window->screen()->objectName() == QStringLiteral("screen.") + QLatin1String(screen);
    }

    desktop::Settings settings;
    desktop::DesktopSite site;
    desktop::AppContext context;
    std::unique_ptr<desktop::MainWindow> window;
};

/// From the home screen, by keys alone, through both spheres of the first level to the debrief.
void trainByKeys(Station& station) {
    QTRY_VERIFY_WITH_TIMEOUT(station.isOn("home"), kPatience_ms);
    QVERIFY(tabTo(QStringLiteral("nav.exercises"))); // action 1
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(station.isOn("exercises"), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(
        station.window->findChild<QPushButton*>(QStringLiteral("exercise.sphere_apex.1")), kPatience_ms);
    QVERIFY(tabTo(QStringLiteral("exercise.sphere_apex.1"))); // action 2
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(station.isOn("exercise_setup"), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(station.window->findChild<QPushButton*>(QStringLiteral("setup.start")),
                             kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(
        station.window->findChild<QPushButton*>(QStringLiteral("setup.start"))->isEnabled(), kPatience_ms);
    QVERIFY(tabTo(QStringLiteral("setup.start"))); // action 3
    press(Qt::Key_Space);
    QTRY_VERIFY_WITH_TIMEOUT(station.isOn("training"), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(QApplication::focusWidget() && QApplication::focusWidget()->objectName() ==
                                                                QStringLiteral("training.ready.go"),
                             kPatience_ms);
    QVERIFY(!station.context.trialRuns());
    press(Qt::Key_Return); // what to do was read
    QTRY_VERIFY_WITH_TIMEOUT(station.context.trialRuns(), kPatience_ms);
    // Enter marks once a trial runs; pressed again and again it does nothing in between.
    for (int i = 0; i < 150 && !station.isOn("debrief"); ++i) {
        QTest::keyClick(station.window.get(), Qt::Key_Return);
        QTest::qWait(200);
    }
    QVERIFY(station.isOn("debrief"));
    QTRY_VERIFY_WITH_TIMEOUT(station.window->screen()->findChild<QLabel*>(QStringLiteral("debrief.verdict")),
                             kPatience_ms);
    QVERIFY(!station.context.trialRuns());
}

void isStoredAsCompleted(Station& station, std::size_t sessions) {
    auto reader = station.site.database().openReader();
    QVERIFY(reader);
    const auto listed = database::SessionReader(**reader, station.context.actor()).listSessions();
    QVERIFY(listed);
    QCOMPARE(listed->size(), sessions);
    QCOMPARE(listed->back().state, database::SessionState::completed);
    QVERIFY(!listed->back().felt);
    QVERIFY(listed->back().passed.has_value()); // scored
}

} // namespace

/// A new station: first start, first login, first set, first debrief, with nothing but the keyboard.
class TestFirstSession : public QObject {
    Q_OBJECT
private slots:
    void firstStartToFirstDebrief() {
        Station station(m_folder);
        QTRY_VERIFY_WITH_TIMEOUT(station.isOn("first_start"), kPatience_ms);
        QVERIFY(tabTo(QStringLiteral("first_start.set_up")));
        press(Qt::Key_Space);
        QVERIFY(tabTo(QStringLiteral("first_start.name")));
        type(QStringLiteral("ada"));
        QVERIFY(tabTo(QStringLiteral("first_start.password")));
        type(QLatin1String(kPassword));
        QVERIFY(tabTo(QStringLiteral("first_start.repeat")));
        type(QLatin1String(kPassword));
        press(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(station.window->findChild<QCheckBox*>(QStringLiteral("recovery.written")),
                                 kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(
            station.window->findChild<QCheckBox*>(QStringLiteral("recovery.written"))->isVisible(),
            kPatience_ms);
        QVERIFY(tabTo(QStringLiteral("recovery.written")));
        press(Qt::Key_Space);
        QVERIFY(tabTo(QStringLiteral("recovery.continue")));
        press(Qt::Key_Space);
        trainByKeys(station);
        isStoredAsCompleted(station, 1);
    }

    /// What a person does from the first start to the first debrief, counted: a name, a password twice, and
    /// the rest is pressing.
    void firstDebriefIsAFewActionsAway() {
        const QByteArray shortened = qgetenv("CHIRON_CONTENT");
        qunsetenv("CHIRON_CONTENT"); // as shipped: ten trials, of which a try has three
        const auto again = qScopeGuard([&shortened] { qputenv("CHIRON_CONTENT", shortened); });
        QTemporaryDir folder;
        Station station(folder);
        int actions = 0;
        const auto doKey = [&actions](Qt::Key key) {
            press(key);
            ++actions;
        };
        const auto doType = [&actions](const QString& words) {
            type(words);
            ++actions;
        };
        QTRY_VERIFY_WITH_TIMEOUT(station.isOn("first_start"), kPatience_ms);
        QVERIFY(tabTo(QStringLiteral("first_start.set_up")));
        doKey(Qt::Key_Return);
        QVERIFY(tabTo(QStringLiteral("first_start.name")));
        doType(QStringLiteral("ada"));
        QVERIFY(tabTo(QStringLiteral("first_start.password")));
        doType(QLatin1String(kPassword));
        QVERIFY(tabTo(QStringLiteral("first_start.repeat")));
        doType(QLatin1String(kPassword));
        doKey(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(station.window->findChild<QCheckBox*>(QStringLiteral("recovery.written")),
                                 kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(
            station.window->findChild<QCheckBox*>(QStringLiteral("recovery.written"))->isVisible(),
            kPatience_ms);
        QVERIFY(tabTo(QStringLiteral("recovery.written")));
        doKey(Qt::Key_Space);
        QVERIFY(tabTo(QStringLiteral("recovery.continue")));
        doKey(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(station.isOn("home"), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("home.try"),
                                  kPatience_ms); // there is nothing else to do yet
        doKey(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(station.isOn("training"), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("training.ready.go"), kPatience_ms);
        doKey(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(station.context.trialRuns(), kPatience_ms);
        QCOMPARE(actions, 9);
        for (int i = 0; i < 150 && !station.isOn("debrief"); ++i) { // a mark each: no more than three
            QTest::keyClick(station.window.get(), Qt::Key_Return);
            QTest::qWait(200);
        }
        QVERIFY(station.isOn("debrief"));
        QTRY_VERIFY_WITH_TIMEOUT(
            station.window->screen()->findChild<QLabel*>(QStringLiteral("debrief.verdict")), kPatience_ms);
        auto reader = station.site.database().openReader();
        QVERIFY(reader);
        const auto listed = database::SessionReader(**reader, station.context.actor()).listSessions();
        QVERIFY(listed && listed->size() == 1);
        QCOMPARE(listed->back().state, database::SessionState::completed);
        QVERIFY(listed->back().familiarisation);
        const auto record =
            database::SessionReader(**reader, station.context.actor()).session(listed->back().id);
        QVERIFY(record);
        QCOMPARE(record->setup.plannedTrials, 3);
    }

    void loginToDebriefByKeysAlone() { // after the one above: the site is there
        Station station(m_folder);
        QTRY_VERIFY_WITH_TIMEOUT(station.isOn("login"), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(station.site.isOpen(), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(focusName(), QStringLiteral("login.name"),
                                  kPatience_ms); // the form comes once the names are read
        QVERIFY(tabTo(QStringLiteral("login.name")));
        type(QStringLiteral("ada"));
        QVERIFY(tabTo(QStringLiteral("login.password")));
        type(QLatin1String(kPassword));
        press(Qt::Key_Return);
        trainByKeys(station);
        isStoredAsCompleted(station, 2);
    }

private:
    ShortContent m_content;
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestFirstSession)
#include "test_first_session.moc"
