// SPDX-License-Identifier: GPL-3.0-or-later
// A trainer's overview of a group: who stands where, and the way to a person's sessions.
#include "desktop/progress/progress_screen.h"
#include "desktop/progress/progress_table.h"
#include "desktop/sessions/sessions_screen.h"
#include "desktop/widgets/state_panel.h"
#include "gui/lists/many_sessions.h"
#include "support/desktop_fixture.h"
#include "support/languages.h"
#include "support/patience.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::desktop;

namespace {

using tests::DesktopFixture;

/// The overview as it is once everybody has been read.
class Overview {
public:
    explicit Overview(DesktopFixture& desktop, const QVariantMap& place = {}) : m_desktop(desktop) {
        desktop.go(QStringLiteral("progress"), place);
        if (!QTest::qWaitFor([this] { return panel()->state() != StatePanel::State::loading; }, kPatience_ms))
            qFatal("the overview is not read");
    }
    StatePanel* panel() const { return m_desktop.window->screen()->findChild<StatePanel*>(); }
    ProgressTable* table() const { return m_desktop.find<ProgressTable>(QStringLiteral("progress.table")); }
    QStringList people() const {
        QStringList names;
        for (int row = 0; row < table()->rowCount(); ++row)
            names << table()->item(row, ProgressTable::name)->text();
        return names;
    }
    QString cell(const QString& person, int column) const {
        return table()->item(rowOf(person), column)->text();
    }
    int rowOf(const QString& person) const { return static_cast<int>(people().indexOf(person)); }
    int columnOf(const char* exercise) const {
        const auto& exercises = m_desktop.context.site().catalogue().exercises();
        for (std::size_t i = 0; i < exercises.size(); ++i)
            if (exercises[i].id == exercise)
                return ProgressTable::firstExercise + static_cast<int>(i);
        return -1;
    }

private:
    DesktopFixture& m_desktop;
};

Place here(DesktopFixture& desktop) {
    return desktop.context.navigator().current();
}

} // namespace

class TestProgressScreen : public QObject {
    Q_OBJECT
private slots:
    void whoStandsWhereIsSeen() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")},
                                 8); // level 1 is passed, level 2 was tried once
        desktop.logIn("tom");
        auto* way = desktop.find<QPushButton>(QStringLiteral("nav.progress"));
        QVERIFY(way);
        way->click();
        QVERIFY(desktop.screen<ProgressScreen>());
        Overview overview(desktop);
        QCOMPARE(overview.people(),
                 (QStringList{QStringLiteral("Theo Trainee"),
                              QStringLiteral("Tina Trainee")})); // full names, trainees alone
        QCOMPARE(desktop.find<QLabel>(QStringLiteral("progress.count"))->text(), QStringLiteral("2 people"));
        const int apex = overview.columnOf("sphere_apex");
        QCOMPARE(overview.cell(QStringLiteral("Tina Trainee"), apex), QStringLiteral("Level 2"));
        QCOMPARE(overview.table()->item(overview.rowOf(QStringLiteral("Tina Trainee")), apex)->toolTip(),
                 QStringLiteral("Level 2, 1 attempt"));
        QCOMPARE(overview.cell(QStringLiteral("Tina Trainee"), overview.columnOf("palpation")),
                 QStringLiteral("Not begun"));
        QVERIFY(overview.cell(QStringLiteral("Tina Trainee"), ProgressTable::toReview).toInt() > 0);
        QVERIFY(overview.cell(QStringLiteral("Tina Trainee"), ProgressTable::latest) !=
                overview.cell(QStringLiteral("Theo Trainee"), ProgressTable::latest));
        QCOMPARE(overview.cell(QStringLiteral("Theo Trainee"), ProgressTable::latest),
                 QStringLiteral("None yet"));
        QCOMPARE(overview.cell(QStringLiteral("Theo Trainee"), apex), QStringLiteral("Not begun"));
        const auto* words = desktop.find<QLabel>(QStringLiteral("progress.chosen"));
        overview.table()->setCurrentCell(overview.rowOf(QStringLiteral("Tina Trainee")), ProgressTable::name);
        QVERIFY2(words->text().startsWith(QStringLiteral("Tina Trainee – next step: ")) &&
                     words->text().endsWith(QStringLiteral(", level 2")),
                 qPrintable(words->text()));
        overview.table()->setCurrentCell(overview.rowOf(QStringLiteral("Tina Trainee")), apex);
        const QString chosen = words->text();
        QVERIFY2(chosen.startsWith(QStringLiteral("Tina Trainee, ")) &&
                     chosen.contains(QStringLiteral("level 1: Passed")),
                 qPrintable(chosen));
    }

    /// In the smallest window that the program is made for, no exercise is out of sight.
    void everyExerciseIsSeenAtOnce_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : tests::languageIds())
            QTest::newRow(language) << QString::fromLatin1(language);
    }

    void everyExerciseIsSeenAtOnce() {
        QFETCH(QString, language);
        DesktopFixture desktop;
        desktop.context.settings().setLanguage(language);
        desktop.context.applyAppearance();
        tests::storeManySessions(desktop.database(), {desktop.actor("tina"), desktop.actor("theo")}, 12);
        desktop.logIn("tom");
        desktop.window->resize(1280, 720);
        Overview overview(desktop);
        QTRY_COMPARE_WITH_TIMEOUT(overview.table()->horizontalScrollBar()->maximum(), 0, kPatience_ms);
        QVERIFY(overview.table()->columnViewportPosition(overview.table()->columnCount() - 1) > 0);
        QCOMPARE(overview.table()->viewport()->y(),
                 overview.table()->horizontalHeader()->geometry().bottom() + 1); // no row begins behind it
        const QHeaderView* head = overview.table()->horizontalHeader();
        for (int column = 0; column < overview.table()->columnCount(); ++column) {
            const QSize words = QFontMetrics(desktop.context.theme().font(TextStyle::strong))
                                    .size(0, overview.table()->horizontalHeaderItem(column)->text());
            QVERIFY2(words.height() < head->height() && words.width() < head->sectionSize(column),
                     qPrintable(overview.table()->horizontalHeaderItem(column)->text()));
        }
    }

    void enterOpensThatPersonsSessions() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina"), desktop.actor("theo")}, 12);
        desktop.logIn("tom");
        Overview overview(desktop);
        QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), overview.table(), kPatience_ms);
        overview.table()->setCurrentCell(overview.rowOf(QStringLiteral("Tina Trainee")),
                                         overview.columnOf("sphere_apex"));
        QTest::keyClick(overview.table(), Qt::Key_Return);
        QCOMPARE(here(desktop).screen, QStringLiteral("sessions"));
        auto* sessions = desktop.screen<SessionsScreen>();
        QTRY_VERIFY_WITH_TIMEOUT(sessions && sessions->isComplete(), kPatience_ms);
        QCOMPARE(sessions->model().filter().person, desktop.actor("tina").personId());
        QCOMPARE(sessions->model().filter().exercise, QStringLiteral("sphere_apex"));
        QCOMPARE(sessions->model().rowCount(), 6);
        desktop.context.navigator().back(); // to the cell that was left
        QTRY_VERIFY_WITH_TIMEOUT(
            overview.table()->chosen() && overview.table()->chosen()->name == "Tina Trainee", kPatience_ms);
        QCOMPARE(overview.table()->chosenExercise(), std::string("sphere_apex"));
        auto* results = desktop.find<QPushButton>(QStringLiteral("progress.results"));
        QTRY_VERIFY_WITH_TIMEOUT(results->isEnabled(), kPatience_ms);
        results->click();
        QCOMPARE(here(desktop).screen, QStringLiteral("results"));
        QCOMPARE(here(desktop).parameters.value(QStringLiteral("name")).toString(),
                 QStringLiteral("Tina Trainee"));
    }

    void theGroupIsNarrowed() {
        DesktopFixture desktop;
        tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 8);
        desktop.logIn("tom");
        Overview overview(desktop);
        auto* names = desktop.find<QLineEdit>(QStringLiteral("progress.names"));
        names->setText(QStringLiteral("théo"));
        QCOMPARE(overview.people(), QStringList{QStringLiteral("Theo Trainee")});
        QVERIFY(!desktop.find<QPushButton>(QStringLiteral("progress.open"))->isEnabled()); // has no sessions
        names->setText(QStringLiteral("theo, trainee tina"));
        QCOMPARE(overview.people().size(), 2);
        names->clear();
        auto* part = desktop.find<QComboBox>(QStringLiteral("progress.part"));
        part->setCurrentIndex(static_cast<int>(GroupPart::toReview));
        QCOMPARE(overview.people(), QStringList{QStringLiteral("Tina Trainee")});
        part->setCurrentIndex(static_cast<int>(GroupPart::notLately));
        QCOMPARE(overview.people(), QStringList{QStringLiteral("Theo Trainee")});
        part->setCurrentIndex(static_cast<int>(GroupPart::notAllPassed));
        QCOMPARE(overview.people().size(), 2);
        QVERIFY(ProgressFilter::fromMap(here(desktop).parameters).part ==
                GroupPart::notAllPassed); // a way back leads to it
        names->setText(QStringLiteral("nobody"));
        QVERIFY(overview.panel()->state() == StatePanel::State::empty);
        desktop.find<QPushButton>(QStringLiteral("progress.clear"))->click();
        QCOMPARE(overview.people().size(), 2);
        QVERIFY(overview.panel()->state() == StatePanel::State::content);
    }

    void aSiteWithoutTraineesSaysSo() {
        DesktopFixture desktop;
        database::AccountService accounts(desktop.database());
        const auto ada = desktop.actor("ada");
        for (const char* name : {"tina", "theo"})
            QVERIFY(accounts.setEnabled(ada, desktop.actor(name).personId(), false));
        desktop.logIn("tom");
        Overview overview(desktop);
        QVERIFY(overview.panel()->state() == StatePanel::State::empty);
        QCOMPARE(overview.table()->rowCount(), 0);
    }

    /// What the repositories refuse is refused here, whoever finds the way.
    void itIsTheTrainersAlone() {
        for (const char* person : {"theo", "rhea"}) {
            DesktopFixture desktop;
            tests::storeManySessions(desktop.database(), {desktop.actor("tina")}, 8);
            desktop.logIn(person);
            QVERIFY(!desktop.find<QPushButton>(QStringLiteral("nav.progress")));
            Overview overview(desktop);
            QVERIFY2(overview.panel()->state() == StatePanel::State::error, person);
            QCOMPARE(overview.table()->rowCount(), 0);
        }
    }
};

QTEST_MAIN(TestProgressScreen)
#include "test_progress_screen.moc"
