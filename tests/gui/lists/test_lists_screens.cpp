// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/audit_repository.h"
#include "database/repositories/session_reader.h"
#include "database/repositories/session_repository.h"
#include "desktop/frame/message_bar.h"
#include "desktop/home/exercises_screen.h"
#include "desktop/home/home_screen.h"
#include "desktop/sessions/session_table_model.h"
#include "desktop/sessions/session_words.h"
#include "desktop/sessions/sessions_screen.h"
#include "desktop/station/lateness_chart.h"
#include "desktop/station/station_record.h"
#include "desktop/station/station_screen.h"
#include "desktop/widgets/state_panel.h"
#include "gui/lists/many_sessions.h"
#include "support/desktop_fixture.h"
#include "support/kept_text.h"
#include "support/languages.h"
#include "support/paint_outline.h"
#include "support/patience.h"
#include "support/pdf_text.h"
#include "support/screen_outline.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDateEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>

#include <algorithm>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::desktop;

namespace {

using tests::DesktopFixture;

Place here(DesktopFixture& desktop) {
    return desktop.context.navigator().current();
}

StatePanel* panel(DesktopFixture& desktop) {
    return desktop.window->screen()->findChild<StatePanel*>();
}

bool loaded(DesktopFixture& desktop) {
    return QTest::qWaitFor(
        [&desktop] { return panel(desktop) && panel(desktop)->state() == StatePanel::State::content; },
        kPatience_ms);
}

SessionsScreen* openSessions(DesktopFixture& desktop, const QVariantMap& filter = {}) {
    desktop.go(QStringLiteral("sessions"), filter);
    auto* screen = desktop.screen<SessionsScreen>();
    return QTest::qWaitFor([screen] { return screen->isComplete(); }, kPatience_ms) ? screen : nullptr;
}

core::Result<database::SessionRecord> stored(DesktopFixture& desktop, database::SessionId id) {
    auto reader = desktop.database().openReader();
    return database::SessionReader(**reader, desktop.actor("ada")).session(id);
}

} // namespace

/// Home, sessions and station as people use them.
class TestListsScreens : public QObject {
    Q_OBJECT
private slots:
    void traineeContinuesByOneKey() {
        DesktopFixture desktop;
        desktop.logIn("tina");
        QVERIFY(loaded(desktop));
        QTRY_VERIFY_WITH_TIMEOUT(QApplication::focusWidget() && QApplication::focusWidget()->objectName() ==
                                                                    QLatin1String("home.continue"),
                                 kPatience_ms);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QCOMPARE(here(desktop).screen, QStringLiteral("exercise_setup"));
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("level")).toInt(), 1);
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("exercise")).toString(),
                 QStringLiteral("sphere_apex"));
    }

    void homeSaysWhereSomebodyStands() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 8);
        desktop.logIn("tina");
        QVERIFY(loaded(desktop));
        QVERIFY(desktop.find<QPushButton>(QStringLiteral("home.session.8")));
        const auto* last = desktop.find<QLabel>(QStringLiteral("home.last"));
        QVERIFY(last && last->text().startsWith(QStringLiteral("Last time: level ")));
        QVERIFY(!desktop.find<QPushButton>(
            QStringLiteral("exercise.sphere_apex.1"))); // the list of exercises is a screen of its own
        QVERIFY(desktop.find<QPushButton>(QStringLiteral("home.exercises")));
        QTest::mouseClick(desktop.find<QPushButton>(QStringLiteral("home.session.8")), Qt::LeftButton);
        QCOMPARE(here(desktop).screen, QStringLiteral("debrief"));
        desktop.go(QStringLiteral("exercises"));
        QVERIFY(desktop.screen<ExercisesScreen>() && loaded(desktop));
        QVERIFY(desktop.find<QPushButton>(QStringLiteral("exercise.sphere_apex.4")));
        auto* first = desktop.find<QPushButton>(QStringLiteral("exercise.sphere_apex.1"));
        QVERIFY(first && first->accessibleName().contains(QStringLiteral("Passed with felt force")));
    }

    void trainerSeesTroubleFirst() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina"), desktop.actor("theo")}, 60);
        desktop.logIn("tom");
        QVERIFY(loaded(desktop));
        QStringList names;
        for (const auto* button : desktop.window->findChildren<QPushButton*>())
            if (button->objectName().startsWith(QLatin1String("home.session.")))
                names << button->accessibleName();
        QVERIFY(names.size() >= 4);
        QVERIFY(!names.first().contains(QStringLiteral("Passed")) ||
                names.first().contains(QStringLiteral("Not passed")));
        QVERIFY(names.first().contains(QStringLiteral("Tina Trainee")) ||
                names.first().contains(QStringLiteral("Theo Trainee")));
        QVERIFY(!desktop.find<QPushButton>(QStringLiteral("home.continue"))); // not a trainee
        QVERIFY(!desktop.find<QPushButton>(QStringLiteral("home.storage")));
    }

    void administratorSeesTheStateOfTheSite() {
        DesktopFixture desktop;
        desktop.logIn("ada");
        QVERIFY(loaded(desktop));
        for (const char* name : {"home.people", "home.storage", "home.station"})
            QVERIFY2(desktop.find<QPushButton>(QLatin1String(name)), name);
    }

    /// What asks for something comes first, then one's own next step, and what is in order last.
    void administratorsHomeBeginsWithWhatIsToBeDone() {
        DesktopFixture desktop; // without any backup
        desktop.logIn("ada");
        QVERIFY(loaded(desktop));
        const auto top = [&](const char* name) {
            auto* button = desktop.find<QPushButton>(QLatin1String(name));
            return button ? button->mapTo(desktop.window->screen(), QPoint()).y() : -1;
        };
        QVERIFY(top("home.storage") >= 0 && top("home.storage") < top("home.try"));
        QVERIFY(top("home.try") < top("home.people") && top("home.people") < top("home.station"));
    }

    void whoeverMayTrainFindsAnExercise_data() {
        QTest::addColumn<QString>("person");
        for (const char* person : {"ada", "tom", "rhea", "tina"})
            QTest::addRow("%s", person) << QString(QLatin1String(person));
    }

    void whoeverMayTrainFindsAnExercise() {
        QFETCH(QString, person);
        DesktopFixture desktop;
        desktop.logIn(person.toStdString());
        QVERIFY(loaded(desktop));
        auto* now = desktop.find<QPushButton>(QStringLiteral("home.try"));
        QVERIFY(now);
        now->click();
        QCOMPARE(here(desktop).screen, QStringLiteral("training"));
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("exercise")).toString(),
                 QStringLiteral("sphere_apex"));
        QVERIFY(here(desktop).parameters.value(QStringLiteral("familiarisation")).toBool()); // a try does not
                                                                                             // count
        QVERIFY(here(desktop).parameters.value(QStringLiteral("trials")).toInt() > 0);
    }

    void whoIsNoTraineeGoesOnAfterTheirOwnPart() {
        DesktopFixture desktop;
        desktop.addSession("tom");
        desktop.logIn("tom");
        QVERIFY(loaded(desktop));
        QVERIFY(!desktop.find<QPushButton>(QStringLiteral("home.try")));
        auto* go = desktop.find<QPushButton>(QStringLiteral("home.continue"));
        auto* sessions = desktop.find<QPushButton>(QStringLiteral("home.sessions"));
        QVERIFY(go && sessions);
        QTRY_VERIFY_WITH_TIMEOUT(go->mapTo(desktop.window.get(), QPoint()).y() >
                                     sessions->mapTo(desktop.window.get(), QPoint()).y(),
                                 kPatience_ms);
    }

    void whatACrashLeftIsTold() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina"), desktop.actor("theo")}, 2);
        auto file = desktop.database().file();
        desktop.context.background().cancelAndWait();
        desktop.site.close();
        auto opened = database::Database::openForWriting(file, desktop.options());
        QVERIFY(opened);
        desktop.site.setOpened(std::move(*opened), {{1, 500, 40, ""}, {2, 0, 0, "the ring is damaged"}});
        desktop.logIn("ada");
        QVERIFY(loaded(desktop));
        QVERIFY(desktop.find<QWidget>(QStringLiteral("home.recovered.1")));
        QVERIFY(desktop.find<QWidget>(QStringLiteral("home.recovered.2")));
        desktop.logIn("tina"); // her own, and nobody else's
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(loaded(desktop));
        QVERIFY(desktop.find<QWidget>(QStringLiteral("home.recovered.1")));
        QVERIFY(!desktop.find<QWidget>(QStringLiteral("home.recovered.2")));
    }

    void anySessionOpensInThreeActions() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina"), desktop.actor("theo")}, 300);
        desktop.logIn("tom");
        QVERIFY(loaded(desktop));
        QTest::mouseClick(desktop.find<QPushButton>(QStringLiteral("nav.sessions")), Qt::LeftButton); // 1
        auto* screen = desktop.screen<SessionsScreen>();
        QTRY_VERIFY_WITH_TIMEOUT(screen && screen->isComplete(), kPatience_ms);
        auto* table = desktop.find<QTableView>(QStringLiteral("sessions.table"));
        QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), table, kPatience_ms);
        QTest::keyClick(desktop.window.get(), Qt::Key_F, Qt::ControlModifier);
        auto* search = desktop.find<QLineEdit>(QStringLiteral("sessions.search"));
        QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), search, kPatience_ms);
        QTest::keyClicks(search, QStringLiteral("123")); // 2
        QCOMPARE(screen->model().rowCount(), 1);
        QTest::keyClick(search, Qt::Key_Return);
        QTest::keyClick(table, Qt::Key_Return); // 3
        QCOMPARE(here(desktop).screen, QStringLiteral("debrief"));
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("session")).toInt(), 123);
    }

    /// What a small window has no room for goes whole, and what matters stays.
    void nothingIsCutInASmallWindow() {
        for (const char* language : tests::languageIds()) {
            DesktopFixture desktop;
            desktop.context.settings().setLanguage(QLatin1String(language));
            desktop.context.applyAppearance();
            tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 30);
            desktop.window->resize(1280, 720);
            desktop.logIn("tom");
            QVERIFY(openSessions(desktop));
            auto* table = desktop.find<QTableView>(QStringLiteral("sessions.table"));
            QTRY_COMPARE_WITH_TIMEOUT(table->horizontalScrollBar()->maximum(), 0, kPatience_ms);
            using Model = SessionTableModel;
            const QFontMetrics metrics(desktop.context.theme().font(TextStyle::body));
            for (const int hour : {8, 11, 20, 23}) { // on a clock of twelve hours, too
                const QString when = desktop.context.locale().toString(
                    QDateTime(QDate(2026, 11, 30), QTime(hour, 34)), QLocale::ShortFormat);
                QVERIFY2(metrics.horizontalAdvance(when) < table->columnWidth(Model::started),
                         qPrintable(when));
            }
            for (const int column :
                 {int(Model::person), int(Model::exercise), int(Model::started), int(Model::result),
                  int(Model::score), int(Model::comments), int(Model::review)})
                QVERIFY(!table->isColumnHidden(column));
            QVERIFY(table->isColumnHidden(Model::length));
            const int inOrder[]{Model::length, Model::device, Model::operatorName, Model::attempt,
                                Model::number}; // none goes before those left of it
            QVERIFY(std::is_sorted(std::begin(inOrder), std::end(inOrder), [&](int before, int after) {
                return table->isColumnHidden(before) && !table->isColumnHidden(after);
            }));
            database::SessionSummary
                scripted; // whoever moved it can be read: in a column, or with the person
            scripted.id = 1;
            scripted.personName = "Nikos Newcomer";
            scripted.exercise = "sphere_apex";
            scripted.operatorName = "expert";
            desktop.screen<SessionsScreen>()->model().setRows(
                {makeSessionRow(scripted, exerciseTitles(desktop.context.site().catalogue(), language))});
            const QString painted = tests::OutlineDevice::of(*table).join(QLatin1Char('\n'));
            QVERIFY2(painted.contains(QLatin1Char('"') + SessionWords::moved(scripted) + QLatin1Char('"')) &&
                         painted.contains(QStringLiteral("\"Nikos Newcomer\"")),
                     qPrintable(painted));
            desktop.window->resize(2400, 900);
            QTRY_VERIFY_WITH_TIMEOUT(!table->isColumnHidden(Model::number) &&
                                         !table->isColumnHidden(Model::length) &&
                                         !table->isColumnHidden(Model::operatorName),
                                     kPatience_ms);
        }
    }

    void commentsAndReviewAreCounted() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 2);
        const auto say = [&](const char* who, database::SessionId session) {
            const auto actor = desktop.actor(who);
            QVERIFY(desktop.database().write([&](database::WriteContext& write) {
                return database::SessionRepository(write.connection(), actor)
                    .addComment(session, "Slower here.", {});
            }));
        };
        say("tina", 1);
        say("tina", 2);
        say("tom", 2);
        desktop.logIn("tom");
        auto* screen = openSessions(desktop);
        QVERIFY(screen);
        const auto row = [&](database::SessionId id) {
            return screen->model().at(screen->model().rowOf(id)).summary;
        };
        QCOMPARE(row(1).comments, 1);
        QVERIFY(!row(1).reviewed); // one's own remark is no review
        QCOMPARE(row(2).comments, 2);
        QVERIFY(row(2).reviewed);
        QCOMPARE(row(1).gates, 1);
        QCOMPARE(row(1).gatesMet, 1);
        QCOMPARE(row(2).gatesMet, 0);
    }

    void backReturnsToTheFilter() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina"), desktop.actor("theo")}, 200);
        desktop.logIn("tom");
        auto* screen = openSessions(desktop);
        QVERIFY(screen);
        auto* state = desktop.find<QComboBox>(QStringLiteral("sessions.state"));
        state->setCurrentIndex(state->findData(static_cast<int>(database::SessionState::interrupted)));
        const int rows = screen->model().rowCount();
        QVERIFY(rows > 2 && rows < 50);
        auto* table = desktop.find<QTableView>(QStringLiteral("sessions.table"));
        table->setCurrentIndex(screen->model().index(2, 0));
        const auto id = screen->model().at(2).summary.id;
        QTest::keyClick(desktop.window.get(), Qt::Key_P, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(here(desktop).screen, QStringLiteral("playback"), kPatience_ms);
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("session")).toLongLong(), qlonglong(id));
        desktop.context.navigator().back();
        auto* again = desktop.screen<SessionsScreen>();
        QTRY_VERIFY_WITH_TIMEOUT(again && again->isComplete(), kPatience_ms);
        QCOMPARE(again->model().rowCount(), rows);
        auto* tableAgain = again->findChild<QTableView*>();
        QCOMPARE(again->model().at(tableAgain->currentIndex().row()).summary.id, id);
    }

    /// The list that a choice opens shows its last line whole.
    void openedChoicesCutNoLine() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(),
                                 {desktop.actor("tina"), desktop.actor("theo"), desktop.actor("rhea")}, 30);
        desktop.logIn("tom");
        auto* screen = openSessions(desktop);
        QVERIFY(screen);
        const auto choices = screen->findChildren<QComboBox*>();
        QVERIFY(choices.size() >= 7);
        for (QComboBox* choice : choices) {
            choice->setFocus();
            choice->showPopup();
            QTRY_VERIFY_WITH_TIMEOUT(choice->view()->isVisible(), kPatience_ms);
            QTest::qWait(50); // a list that does not fit shows arrows then, which take more of its room
            const QRect last = choice->view()->visualRect(choice->model()->index(choice->count() - 1, 0));
            QVERIFY2(last.height() > 0 && last.bottom() <= choice->view()->viewport()->rect().bottom(),
                     qPrintable(choice->objectName()));
            choice->hidePopup();
        }
    }

    /// What somebody chose stays; a link shows its own list and leaves that as it was.
    void aLinkLeavesOnesOwnFilter() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina"), desktop.actor("theo")}, 40);
        desktop.logIn("tom");
        auto* screen = openSessions(desktop);
        QVERIFY(screen);
        desktop.find<QComboBox>(QStringLiteral("sessions.level"))->setCurrentIndex(3);
        const int own = screen->model().rowCount();
        QVERIFY(own > 0 && own < 40);
        desktop.go(QStringLiteral("home"));
        QVERIFY(loaded(desktop));
        desktop.find<QPushButton>(QStringLiteral("home.to_review"))->click();
        screen = desktop.screen<SessionsScreen>();
        QTRY_VERIFY_WITH_TIMEOUT(screen && screen->isComplete(), kPatience_ms);
        QCOMPARE(screen->model().filter().level, 0);
        QVERIFY(screen->model().filter().review == ReviewState::toReview);
        desktop.find<QPushButton>(QStringLiteral("nav.home"))->click();
        desktop.find<QPushButton>(QStringLiteral("nav.sessions"))->click();
        screen = desktop.screen<SessionsScreen>();
        QTRY_VERIFY_WITH_TIMEOUT(screen && screen->isComplete(), kPatience_ms);
        QCOMPARE(screen->model().filter().level, 3);
        QVERIFY(!screen->model().filter().review);
        QCOMPARE(screen->model().rowCount(), own);
        desktop.go(QStringLiteral("home"));
        QVERIFY(loaded(desktop));
        desktop.find<QPushButton>(QStringLiteral("home.sessions"))->click(); // all of them, as it says
        screen = desktop.screen<SessionsScreen>();
        QTRY_VERIFY_WITH_TIMEOUT(screen && screen->isComplete(), kPatience_ms);
        QVERIFY(screen->model().filter().isEmpty());
        desktop.logIn("ada"); // somebody else's choice is nobody else's
        QVERIFY(openSessions(desktop) && desktop.screen<SessionsScreen>()->model().filter().isEmpty());
        desktop.logIn("tom");
        QVERIFY(openSessions(desktop));
        QCOMPARE(desktop.screen<SessionsScreen>()->model().filter().level, 3);
        desktop.find<QPushButton>(QStringLiteral("sessions.clear"))->click();
        desktop.go(QStringLiteral("home"));
        QVERIFY(openSessions(desktop));
        QVERIFY(desktop.screen<SessionsScreen>()->model().filter().isEmpty());
    }

    /// Everywhere the full name; who may not see names sees codes; the login name still finds.
    void peopleAreCalledByTheirFullNames() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 4);
        desktop.logIn("tom");
        QVERIFY(loaded(desktop));
        QVERIFY(desktop.find<QPushButton>(QStringLiteral("home.session.4"))
                    ->accessibleName()
                    .startsWith(QStringLiteral("Tina Trainee: ")));
        auto* screen = openSessions(desktop);
        QVERIFY(screen);
        QCOMPARE(screen->model().index(0, SessionTableModel::person).data().toString(),
                 QStringLiteral("Tina Trainee"));
        desktop.find<QLineEdit>(QStringLiteral("sessions.search"))->setText(QStringLiteral("tina"));
        QCOMPARE(screen->model().rowCount(), 4);
        desktop.find<QPushButton>(QStringLiteral("sessions.results"))->click();
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("name")).toString(),
                 QStringLiteral("Tina Trainee"));
        desktop.logIn("rhea");
        screen = openSessions(desktop);
        QVERIFY(screen && screen->model().rowCount() == 4);
        const QString code = screen->model().index(0, SessionTableModel::person).data().toString();
        QVERIFY2(code.startsWith(QStringLiteral("P-")), qPrintable(code));
    }

    void nothingMatchesAndClears() {
        DesktopFixture desktop;
        desktop.logIn("tom");
        QVERIFY(openSessions(desktop));
        QCOMPARE(panel(desktop)->state(), StatePanel::State::empty); // nothing recorded yet
        QVERIFY(!desktop.find<QPushButton>(QStringLiteral("sessions.export"))->isEnabled());
        QSignalSpy told(&desktop.context.messages(), &Messages::told);
        for (const ScreenCommand& command : desktop.window->screen()->commands())
            if (command.keys == QKeySequence(QKeySequence::Save))
                command.act();
        QCOMPARE(told.size(), 1); // its key says why nothing comes
        QVERIFY(told.front().front().value<Message>().text.contains(QStringLiteral("list is empty")));
        QVERIFY(desktop.find<QPushButton>(QStringLiteral("state.action"))->isHidden());
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 20);
        auto* screen = openSessions(desktop, {{QStringLiteral("text"), QStringLiteral("nobody")}});
        QVERIFY(screen);
        QCOMPARE(panel(desktop)->state(), StatePanel::State::empty);
        auto* clear = screen->findChild<QPushButton*>(QStringLiteral("state.action"));
        QVERIFY(clear && !clear->isHidden());
        QTest::mouseClick(clear, Qt::LeftButton);
        QCOMPARE(panel(desktop)->state(), StatePanel::State::content);
        QCOMPARE(screen->model().rowCount(), 20);
        QVERIFY(here(desktop).parameters.value(QStringLiteral("text")).toString().isEmpty());
    }

    void anErrorIsToldAndTriedAgain() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 3);
        desktop.logIn("tom");
        QVERIFY(loaded(desktop));
        const auto ada = desktop.actor("ada");
        database::AccountService accounts(desktop.database());
        QVERIFY(accounts.setEnabled(ada, desktop.context.actor().personId(), false)); // disabled meanwhile
        desktop.go(QStringLiteral("sessions"));
        QTRY_COMPARE_WITH_TIMEOUT(panel(desktop)->state(), StatePanel::State::error, kPatience_ms);
        QVERIFY(accounts.setEnabled(ada, desktop.context.actor().personId(), true));
        QTest::mouseClick(desktop.window->screen()->findChild<QPushButton*>(QStringLiteral("state.action")),
                          Qt::LeftButton);
        QVERIFY(loaded(desktop));
    }

    void voidingNeedsAReason() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 5);
        desktop.logIn("tom");
        auto* screen = openSessions(desktop);
        QVERIFY(screen);
        QTest::mouseClick(desktop.find<QPushButton>(QStringLiteral("sessions.void")), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QPlainTextEdit>(QStringLiteral("void.reason")), kPatience_ms);
        auto* confirm = desktop.find<QPushButton>(QStringLiteral("void.confirm"));
        QVERIFY(!confirm->isEnabled());
        QTest::keyClicks(desktop.find<QPlainTextEdit>(QStringLiteral("void.reason")), QStringLiteral("  "));
        QVERIFY(!confirm->isEnabled());
        QTest::keyClicks(desktop.find<QPlainTextEdit>(QStringLiteral("void.reason")),
                         QStringLiteral("device slipped"));
        QTest::mouseClick(confirm, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(screen->model().at(0).summary.state, database::SessionState::voided,
                                  kPatience_ms);
        QCOMPARE(stored(desktop, 5)->voidReason, std::string("device slipped"));
        QVERIFY(!desktop.find<QPushButton>(QStringLiteral("sessions.void"))->isEnabled());
        auto* again = desktop.find<QPushButton>(QStringLiteral("sessions.reinstate"));
        QVERIFY(again->isVisible());
        QTest::mouseClick(again, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(desktop.find<QPlainTextEdit>(QStringLiteral("reinstate.reason")),
                                 kPatience_ms);
        confirm = desktop.find<QPushButton>(QStringLiteral("reinstate.confirm"));
        QVERIFY(!confirm->isEnabled());
        QTest::keyClicks(desktop.find<QPlainTextEdit>(QStringLiteral("reinstate.reason")),
                         QStringLiteral("another one slipped"));
        QTest::mouseClick(confirm, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(screen->model().at(0).summary.state != database::SessionState::voided,
                                 kPatience_ms);
        QCOMPARE(stored(desktop, 5)->decisions.size(), std::size_t{2});
        QVERIFY(!again->isVisible() &&
                desktop.find<QPushButton>(QStringLiteral("sessions.void"))->isEnabled());
    }

    void whatIsToReviewIsCounted() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")},
                                 8); // two at each of four levels; one of them practice
        const auto comment = [&desktop, tom = desktop.actor("tom")](database::SessionId session) {
            return desktop.database().write([&](database::WriteContext& writing) {
                return database::SessionRepository(writing.connection(), tom).addComment(session, "seen");
            });
        };
        const auto count = [&desktop] {
            return desktop.window->screen()
                ->findChild<QLabel*>(QStringLiteral("home.to_review_count"))
                ->text();
        };
        desktop.logIn("tom");
        QVERIFY(loaded(desktop));
        QVERIFY2(count().startsWith(QStringLiteral("4 ")), qPrintable(count()));
        QVERIFY(comment(8)); // the latest at level 4
        desktop.logIn("tom");
        QVERIFY(loaded(desktop));
        QVERIFY2(count().startsWith(QStringLiteral("3 ")), qPrintable(count()));
        QTest::mouseClick(desktop.find<QPushButton>(QStringLiteral("home.to_review")), Qt::LeftButton);
        auto* screen = desktop.screen<SessionsScreen>();
        QVERIFY(screen);
        QTRY_VERIFY_WITH_TIMEOUT(screen->isComplete(), kPatience_ms);
        QCOMPARE(screen->model().rowCount(), 3);
        QCOMPARE(screen->model().total(), 8);
        QVERIFY(
            desktop.find<QLabel>(QStringLiteral("sessions.count"))->text().startsWith(QStringLiteral("3 ")));
        auto* review = desktop.find<QComboBox>(QStringLiteral("sessions.review"));
        review->setCurrentIndex(2);
        QCOMPARE(screen->model().rowCount(), 1); // the one that was reviewed
        QCOMPARE(screen->model().at(0).summary.id, database::SessionId{8});
    }

    void resultsAreReachedFromTheList() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 5);
        desktop.logIn("tom");
        auto* screen = openSessions(desktop);
        QVERIFY(screen);
        const int row = screen->model().rowOf(3);
        desktop.find<QTableView>(QStringLiteral("sessions.table"))->selectRow(row);
        QTest::mouseClick(desktop.find<QPushButton>(QStringLiteral("sessions.results")), Qt::LeftButton);
        QCOMPARE(here(desktop).screen, QStringLiteral("results"));
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("person")).toLongLong(),
                 desktop.actor("tina").personId());
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("level")).toInt(), 3);
        desktop.context.navigator().back();
        QCOMPARE(here(desktop).screen, QStringLiteral("sessions"));
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("selected")).toLongLong(), 3);
    }

    void commentsAreFoundAgain() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 3);
        const auto tom = desktop.actor("tom"), tina = desktop.actor("tina");
        const auto written =
            desktop.database().write([&](database::WriteContext& writing) -> core::Result<void> {
                database::SessionRepository byTom(writing.connection(), tom),
                    byTina(writing.connection(), tina);
                auto first = byTom.addComment(2, "here you pressed too hard", 5000);
                auto second = first ? byTom.addComment(1, "well done") : first;
                auto third = second ? byTina.addComment(3, "my hand slipped") : second;
                return third ? core::Result<void>() : core::Result<void>(tl::unexpected(third.error()));
            });
        QVERIFY(written);
        desktop.logIn("tina");
        QVERIFY(loaded(desktop));
        QCOMPARE(desktop.context.unread(), 2);
        desktop.find<QPushButton>(QStringLiteral("home.comments"))->click();
        QCOMPARE(here(desktop).screen, QStringLiteral("comments"));
        QVERIFY(loaded(desktop));
        QCOMPARE(desktop.window->screen()->findChildren<QLabel*>(QStringLiteral("comments.unread")).size(),
                 2);
        QCOMPARE(desktop.context.unread(), 0); // they stand here to be read
        // How they look was read and kept: CHIRON_STORE_OUTLINES=1 QT_QPA_PLATFORM=offscreen
        // build/release/tests/gui/lists/test_lists_screens
        tests::KeptText kept(QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/lists/kept_comments.txt"));
        const auto differs = [&](const char* name) {
            return kept.differs(QLatin1String(name), tests::ScreenOutline::of(*desktop.window->screen()));
        };
        QStringList different{differs("unread")};
        desktop.find<QPushButton>(QStringLiteral("comments.open.1"))->click();
        QCOMPARE(here(desktop).screen, QStringLiteral("playback"));
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("at_tick")).toULongLong(), 5000ULL);
        desktop.context.navigator().back();
        QVERIFY(loaded(desktop)); // found again once read
        QVERIFY(desktop.window->screen()->findChildren<QLabel*>(QStringLiteral("comments.unread")).isEmpty());
        different << differs("read");
        desktop.find<QPushButton>(QStringLiteral("comments.open.2"))->click();
        QCOMPARE(here(desktop).screen, QStringLiteral("debrief")); // about the whole session
        desktop.logIn("tom");
        desktop.go(QStringLiteral("comments"), {{QStringLiteral("which"), QStringLiteral("received")}});
        QVERIFY(loaded(desktop));
        const auto leads = [&desktop](int comment) {
            return desktop.window->screen()->findChild<QPushButton*>(
                       QStringLiteral("comments.open.%1").arg(comment)) != nullptr;
        };
        QVERIFY(!leads(1));
        desktop.find<QComboBox>(QStringLiteral("comments.which"))->setCurrentIndex(2); // written
        QVERIFY(leads(1) && leads(2) && !leads(3)); // tina's own is not his
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        different << differs("by somebody else");
        different.removeAll(QString());
        QVERIFY2(different.isEmpty(), qPrintable(different.join(QLatin1Char('\n'))));
        QCOMPARE(kept.unseen(), QStringList());
        auto* screen = openSessions(desktop, {{QStringLiteral("commented"), true}});
        QVERIFY(screen);
        QCOMPARE(screen->model().rowCount(), 3);
    }

    void traineesMayNotVoidNorArchive() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 1);
        const auto tina = desktop.actor("tina");
        const auto refused =
            desktop.database().write([&](database::WriteContext& writing) -> core::Result<void> {
                database::SessionRepository sessions(writing.connection(), tina);
                if (auto done = sessions.setArchived(1, true);
                    done || done.error().code != core::ErrorCode::notAllowed)
                    return {};
                return sessions.voidSession(1, "mine");
            });
        QVERIFY(!refused && refused.error().code == core::ErrorCode::notAllowed);
        desktop.logIn("rhea"); // a researcher reads
        QVERIFY(openSessions(desktop));
        QVERIFY(desktop.find<QPushButton>(QStringLiteral("sessions.void"))->isHidden());
        QVERIFY(desktop.find<QPushButton>(QStringLiteral("sessions.archive"))->isHidden());
        QVERIFY(desktop.find<QPushButton>(QStringLiteral("sessions.open"))->isEnabled());
        // The only one is chosen, and a list of one can be saved.
        QCOMPARE(desktop.find<QTableView>(QStringLiteral("sessions.table"))->currentIndex().row(), 0);
        QVERIFY(desktop.find<QPushButton>(QStringLiteral("sessions.export"))->isEnabled());
    }

    void forceFeltOrOnlyShownIsChosen() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 30);
        desktop.logIn("tom");
        auto* screen = openSessions(desktop);
        QVERIFY(screen);
        auto* device = desktop.find<QComboBox>(QStringLiteral("sessions.device"));
        for (const auto& [choice, felt] : {std::pair{1, true}, {2, false}}) {
            device->setCurrentIndex(choice);
            QCOMPARE(screen->model().rowCount(), 15);
            for (int row = 0; row < screen->model().rowCount(); ++row)
                QCOMPARE(screen->model().at(row).summary.felt, felt);
        }
        device->setCurrentIndex(0);
        QCOMPARE(screen->model().rowCount(), 30);
    }

    void chosenDaysNarrowTheList() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 90, true);
        desktop.logIn("tom");
        auto* screen = openSessions(desktop, {{QStringLiteral("from"), QStringLiteral("2026-01-03")},
                                              {QStringLiteral("to"), QStringLiteral("2026-01-05")}});
        QVERIFY(screen);
        QCOMPARE(screen->model().rowCount(), 9); // three a day
        auto* to = desktop.find<QDateEdit>(QStringLiteral("sessions.to"));
        QVERIFY(to && to->isVisible());
        to->setDate(QDate(2026, 1, 3));
        QCOMPARE(screen->model().rowCount(), 3);
        auto* period = desktop.find<QComboBox>(QStringLiteral("sessions.period"));
        period->setCurrentIndex(0);
        QCOMPARE(screen->model().rowCount(), 90);
        QVERIFY(!to->isVisible());
    }

    void archivingIsUndone() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 5);
        desktop.logIn("tom");
        auto* screen = openSessions(desktop);
        QVERIFY(screen);
        QTest::mouseClick(desktop.find<QPushButton>(QStringLiteral("sessions.archive")), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(screen->model().rowCount(), 4, kPatience_ms);
        QVERIFY(stored(desktop, 5)->summary.archived);
        const auto bar = [&desktop] {
            return desktop.find<QPushButton>(QStringLiteral("messages.action"));
        }; // made when it is first needed
        QTRY_VERIFY_WITH_TIMEOUT(bar() && bar()->isVisible(), kPatience_ms);
        auto* undo = bar();
        QTest::mouseClick(undo, Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(screen->model().rowCount(), 5, kPatience_ms);
        QVERIFY(!stored(desktop, 5)->summary.archived);
    }

    void undoWorksFromAnotherScreen() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 2);
        desktop.logIn("tom");
        QVERIFY(openSessions(desktop));
        QTest::mouseClick(desktop.find<QPushButton>(QStringLiteral("sessions.archive")), Qt::LeftButton);
        const auto bar = [&desktop] {
            return desktop.find<QPushButton>(QStringLiteral("messages.action"));
        }; // made when it is first needed
        QTRY_VERIFY_WITH_TIMEOUT(bar() && bar()->isVisible(), kPatience_ms);
        auto* undo = bar();
        desktop.go(QStringLiteral("settings"));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QTest::mouseClick(undo, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!stored(desktop, 2)->summary.archived, kPatience_ms);
    }

    void fiveThousandComeWhole() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina"), desktop.actor("theo")}, 5000);
        desktop.logIn("tom");
        desktop.go(QStringLiteral("sessions"));
        auto* screen = desktop.screen<SessionsScreen>();
        int first = 0;
        connect(screen, &SessionsScreen::firstRowsShown, this,
                [&first, screen] { first = screen->model().rowCount(); });
        QTRY_VERIFY_WITH_TIMEOUT(screen->isComplete(), kPatience_ms);
        QCOMPARE(first, SessionsScreen::kFirstPage); // shown before the rest was read
        QCOMPARE(screen->model().total(), 5000);
        QCOMPARE(screen->model().at(0).summary.id, database::SessionId{5000});
        QCOMPARE(screen->model().at(4999).summary.id, database::SessionId{1});
    }

    void selfTestRunsAndIsStopped() {
        DesktopFixture desktop;
        desktop.logIn("ada");
        desktop.go(QStringLiteral("station"), {{QStringLiteral("self_test_ms"), 50}});
        QVERIFY(loaded(desktop));
        auto* screen = desktop.screen<StationScreen>();
        QSignalSpy ended(screen, &StationScreen::selfTestEnded);
        QTest::mouseClick(desktop.find<QPushButton>(QStringLiteral("station.self_test")), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kPatience_ms);
        auto* chart = screen->findChild<LatenessChart*>();
        QVERIFY(chart && chart->accessibleDescription().contains(QStringLiteral("µs")));
        desktop.go(QStringLiteral("station"), {{QStringLiteral("self_test_ms"), 600'000}});
        QVERIFY(loaded(desktop));
        auto* longer = desktop.screen<StationScreen>();
        QSignalSpy stopped(longer, &StationScreen::selfTestEnded);
        QTest::mouseClick(longer->findChild<QPushButton*>(QStringLiteral("station.self_test")),
                          Qt::LeftButton);
        QTest::mouseClick(longer->findChild<QPushButton*>(QStringLiteral("task.cancel")), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(stopped.count(), 1, kPatience_ms);
        QVERIFY(!longer->findChild<LatenessChart*>());
    }

    /// Whom the data layer lets check stations: a researcher as well. The check stands in the audit trail,
    /// and its record can be filed.
    void aCheckIsKeptAndFiled() {
        DesktopFixture desktop;
        desktop.logIn("rhea");
        desktop.go(QStringLiteral("station"), {{QStringLiteral("self_test_ms"), 50}});
        QVERIFY(loaded(desktop));
        auto* screen = desktop.screen<StationScreen>();
        auto* record = desktop.find<QPushButton>(QStringLiteral("station.test_record"));
        QVERIFY(record && !record->isEnabled());
        QVERIFY(!screen->writeLoopRecord(QStringLiteral("/tmp/nothing.pdf"))); // nothing was measured
        QSignalSpy noted(screen, &StationScreen::checkNoted);
        QTest::mouseClick(desktop.find<QPushButton>(QStringLiteral("station.self_test")), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(noted.count(), 1, kPatience_ms);
        QVERIFY(record->isEnabled());
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("record.pdf"));
        QVERIFY(screen->writeLoopRecord(path));
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly) && file.read(5) == "%PDF-");
        const QString filed = tests::pdfText(path); // by whom: by their full name
        QVERIFY2(filed.contains(QStringLiteral("Rhea Research")), qPrintable(filed));
        QVERIFY(!screen->writeLoopRecord(QStringLiteral("/no/such/folder/x.pdf")));
        auto connection = desktop.database().openReader();
        const auto audit = database::AuditRepository(**connection, desktop.actor("ada")).listAudit();
        QVERIFY(audit);
        const auto entry = std::find_if(audit->begin(), audit->end(), [](const database::AuditEntry& each) {
            return each.action == "recordStationCheck";
        });
        QVERIFY(entry != audit->end());
        QCOMPARE(entry->actor, desktop.actor("rhea").personId());
        QVERIFY(entry->detailJson.find("\"loop\"") != std::string::npos);
    }

    void whatIsFiledSaysEverything() {
        session::SelfTestResult result;
        result.loop.ticks = 10000;
        result.loop.late = 31;
        const CheckCircumstances of{QStringLiteral("rhea"),
                                    QDateTime(QDate(2026, 11, 28), QTime(9, 30)),
                                    QStringLiteral("bench-2"),
                                    QStringLiteral("A device"),
                                    QStringLiteral("SN-7"),
                                    QStringLiteral("1.2 build"),
                                    41,
                                    QStringLiteral("Nordklinik")};
        const report::CheckRecord failed = loopRecord(result, of, QLocale::c());
        QVERIFY(failed.verdict.startsWith(QStringLiteral("Failed.")));
        QStringList head;
        for (const auto& [name, value] : failed.head)
            head << value;
        for (const char* told : {"Nordklinik", "rhea", "bench-2", "A device", "SN-7", "1.2 build", "41"})
            QVERIFY2(head.contains(QLatin1String(told)), told);
        QVERIFY(head.join(QString()).contains(QStringLiteral("2026")));
        QCOMPARE(serialWords(QString()), QStringLiteral("not reported by the device"));
        QCOMPARE(serialWords(std::nullopt), QStringLiteral("none")); // there is no device
        QCOMPARE(failed.tables.front().lines[1].mid(1), QStringList({"0.310 %", "at most 0.300 %", "FAIL"}));
        result.loop.late = 30;
        const report::CheckRecord good = loopRecord(result, of, QLocale::c());
        QVERIFY(good.verdict.startsWith(QStringLiteral("Passed.")));
        QCOMPARE(good.tables.front().lines[1].last(), QStringLiteral("pass"));
        result.loop.skipped = 1;
        QVERIFY(!loopHolds(result));
    }

    void selfTestNeverRunsBesideASession() {
        DesktopFixture desktop;
        desktop.logIn("ada");
        desktop.go(QStringLiteral("station"));
        QVERIFY(loaded(desktop));
        auto* button = desktop.find<QPushButton>(QStringLiteral("station.self_test"));
        desktop.context.setTrialRuns(true);
        QVERIFY(!button->isEnabled());
        desktop.context.setTrialRuns(false);
        QVERIFY(button->isEnabled());
        desktop.logIn("tina"); // may look
        desktop.go(QStringLiteral("station"));
        QVERIFY(loaded(desktop));
        QVERIFY(!desktop.window->screen()->findChild<QPushButton*>(QStringLiteral("station.self_test")));
    }
};

QTEST_MAIN(TestListsScreens)
#include "test_lists_screens.moc"
