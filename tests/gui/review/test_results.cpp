// SPDX-License-Identifier: GPL-3.0-or-later
// A person's own results: the curve, the attempts, a copy of their data.
#include "desktop/playback/playback_data.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/results/learning_curve.h"
#include "desktop/results/results_screen.h"
#include "report/plot_view.h"
#include "review_sessions.h"
#include "support/patience.h"

#include <QComboBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include <QVector>
#include <qcustomplot.h>

using chiron::tests::kPatience_ms;

using namespace chiron;
using tests::DesktopFixture;
using tests::MadeSession;

class TestResults : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void emptyLeadsToExercises();
    void attemptsAndCurve();
    void bothClassesAreDrawn();
    void countsAndAttemptsHaveWholeNumbers_data();
    void countsAndAttemptsHaveWholeNumbers();
    void onlyMyOwn();
    void aTrainerSeesSomebodysProgress();
    void openLeadsToTheDebrief();
    void opensWhereOneIsAndStaysThere();
    void exportsEverything();
    void progressIsAShare();
    void nothingClippedOrUnnamed();

private:
    void open();
    template <class W> W* find(const char* name) {
        return m_site->window->screen()->findChild<W*>(QLatin1String(name));
    }

    std::unique_ptr<DesktopFixture> m_site;
    std::unique_ptr<tests::ReviewSessions> m_made;
    std::optional<database::Actor> m_tina;
    database::SessionId m_last = 0;
};

void TestResults::initTestCase() {
    m_site = std::make_unique<DesktopFixture>();
    m_made = std::make_unique<tests::ReviewSessions>(m_site->database());
    const tests::ReviewSessions& made = *m_made;
    m_tina = m_site->actor("tina");
    for (const MadeSession* session : {&made.bad, &made.bad, &made.good})
        tests::store(m_site->database(), *m_tina, *session);
    MadeSession stopped = made.good;
    tests::cutFrames(stopped.frames, 4000);
    stopped.ending.stopped = true;
    tests::store(m_site->database(), *m_tina, stopped);
    tests::store(m_site->database(), *m_tina, tests::ReviewSessions::shown(made.bad));
    MadeSession familiarisation = made.good;
    familiarisation.familiarisation = true;
    tests::store(m_site->database(), *m_tina, familiarisation);
    m_last = tests::store(m_site->database(), *m_tina, tests::ReviewSessions::shown(made.good));
}

void TestResults::open() {
    m_site->go(QStringLiteral("results"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
}

void TestResults::emptyLeadsToExercises() {
    m_site->logIn("theo");
    m_site->go(QStringLiteral("results"));
    QTRY_COMPARE_WITH_TIMEOUT(tests::panelOf(*m_site)->state(), desktop::StatePanel::State::empty,
                              kPatience_ms);
    if (const QString folder = qEnvironmentVariable("CHIRON_PICTURES"); !folder.isEmpty())
        m_site->window->grab().save(QDir(folder).filePath(QStringLiteral("results_empty.png")));
    find<QPushButton>("state.action")->click();
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("exercises"));
}

void TestResults::attemptsAndCurve() {
    m_site->context.logIn(*m_tina);
    open();
    QCOMPARE(find<QTableWidget>("results.attempts")->rowCount(), 7);
    QCOMPARE(find<QComboBox>("results.metric")->currentData().toString(), QStringLiteral("apex_error_mean"));
    QVERIFY(find<QWidget>("results.curve"));
    auto connection = m_site->database().openReader();
    const auto attempts =
        desktop::loadAttempts(**connection, *m_tina, m_tina->personId(), [](double) { return true; });
    QVERIFY(attempts && attempts->size() == 7);
    int felt = 0;
    int shown = 0;
    for (const desktop::Attempt& attempt : *attempts)
        if (attempt.onCurve())
            ++(attempt.summary.felt ? felt : shown);
    QCOMPARE(felt, 3); // the stopped and the familiarisation session are no points
    QCOMPARE(shown, 2);
    auto* metric = find<QComboBox>("results.metric");
    const int force = metric->findData(QStringLiteral("force_max"));
    metric->setCurrentIndex(force);
    emit metric->activated(force);
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("metric")).toString(),
             QStringLiteral("force_max"));
    QCOMPARE(find<QTableWidget>("results.attempts")->horizontalHeaderItem(3)->text(),
             QStringLiteral("Largest force"));
    QStringList numbers; // newest first: shown, practice, shown, stopped, good, bad, bad
    for (int row = 0; row < 7; ++row)
        numbers << find<QTableWidget>("results.attempts")->item(row, 1)->text();
    QCOMPARE(numbers,
             QStringList({QStringLiteral("Attempt 6 at level 2"), QStringLiteral("Level 2, familiarisation"),
                          QStringLiteral("Attempt 5 at level 2"), QStringLiteral("Attempt 4 at level 2"),
                          QStringLiteral("Attempt 3 at level 2"), QStringLiteral("Attempt 2 at level 2"),
                          QStringLiteral("Attempt 1 at level 2")}));
    tests::takePictures(*m_site, QStringLiteral("results"), [this] { open(); });
}

/// What was felt and what was only shown are two curves, and the legend names those that have a point.
void TestResults::bothClassesAreDrawn() {
    const auto legend = [this](int felt, int shown) {
        std::vector<desktop::Attempt> made;
        for (int i = 0; i < felt + shown; ++i) {
            desktop::Attempt& attempt = made.emplace_back();
            attempt.summary.state = database::SessionState::completed;
            attempt.summary.attempt = i + 1;
            attempt.summary.felt = i < felt;
            scoring::MetricValue& value = attempt.metrics.emplace_back();
            value.id = "apex_misses";
            value.value = i;
        }
        report::MetricRow row;
        row.id = QStringLiteral("apex_misses");
        return desktop::learningCurve(made, row, desktop::plotThemeOf(m_site->context.theme(), QLocale::c()))
            ->legendTexts();
    };
    const QString felt = QStringLiteral("felt"), shown = QStringLiteral("shown, not felt");
    QCOMPARE(legend(2, 0), QStringList{felt});
    QCOMPARE(legend(0, 1), QStringList{shown});
    QCOMPARE(legend(1, 2), (QStringList{felt, shown}));
}

void TestResults::countsAndAttemptsHaveWholeNumbers_data() {
    QTest::addColumn<int>("attempts");
    QTest::newRow("each attempt named") << 3;
    QTest::newRow("a numbered axis") << 30;
}

/// There are no half misses, nor half attempts; a force has values between two numbers.
void TestResults::countsAndAttemptsHaveWholeNumbers() {
    QFETCH(int, attempts);
    std::vector<desktop::Attempt> made;
    for (int i = 1; i <= attempts; ++i) {
        desktop::Attempt& attempt = made.emplace_back();
        attempt.summary.state = database::SessionState::completed;
        attempt.summary.attempt = i;
        attempt.summary.felt = true;
        scoring::MetricValue& value = attempt.metrics.emplace_back();
        value.id = "apex_misses";
        value.value = i % 3;
    }
    const auto ticksOf = [&](const char* unit, bool across) {
        report::MetricRow row;
        row.id = QStringLiteral("apex_misses");
        row.unit = QLatin1String(unit);
        const auto curve =
            desktop::learningCurve(made, row, desktop::plotThemeOf(m_site->context.theme(), QLocale::c()));
        curve->resize(480, 320);
        curve->show();
        const auto* plot = curve->findChild<QCustomPlot*>();
        if (!plot)
            qFatal("the curve has no plot");
        return (across ? plot->xAxis : plot->yAxis)->tickVector();
    };
    const auto whole = [](const QVector<double>& ticks) {
        return ticks.size() > 1 && std::all_of(ticks.begin(), ticks.end(), [](double at) {
                   return std::abs(at - std::round(at)) < 1e-9;
               });
    };
    QVERIFY(whole(ticksOf("count", false)));
    QVERIFY(whole(ticksOf("count", true)));
    QVERIFY(!whole(ticksOf("N", false)));
}

void TestResults::onlyMyOwn() {
    const auto theo = m_site->actor("theo");
    auto connection = m_site->database().openReader();
    const auto others =
        desktop::loadAttempts(**connection, theo, m_tina->personId(), [](double) { return true; });
    QVERIFY(!others || others->empty()); // the data layer gives nobody else's
}

/// From Home to the curve of one trainee, and on to all their sessions; their data are theirs to export.
void TestResults::aTrainerSeesSomebodysProgress() {
    m_site->logIn("tom");
    const QString tile = QStringLiteral("home.person.%1").arg(m_tina->personId());
    QTRY_VERIFY_WITH_TIMEOUT(m_site->window->screen()->findChild<QPushButton*>(tile), kPatience_ms);
    m_site->window->screen()->findChild<QPushButton*>(tile)->click();
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("results"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
    QVERIFY(m_site->window->screen()->title().startsWith(QStringLiteral("Results of ")));
    QCOMPARE(find<QTableWidget>("results.attempts")->rowCount(), 7);
    QVERIFY(find<QWidget>("results.curve"));
    QVERIFY(!find<QPushButton>("results.export"));
    QVERIFY(m_site->window->screen()->commands().empty());
    find<QPushButton>("results.sessions")->click();
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("sessions"));
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("person")).toLongLong(),
             m_tina->personId());
    m_site->logIn("theo"); // no trainer: nothing of somebody else's is there
    m_site->go(QStringLiteral("results"), {{QStringLiteral("person"), qlonglong(m_tina->personId())}});
    QTRY_VERIFY_WITH_TIMEOUT(tests::panelOf(*m_site)->state() == desktop::StatePanel::State::empty ||
                                 tests::panelOf(*m_site)->state() == desktop::StatePanel::State::error,
                             kPatience_ms);
    m_site->context.logIn(*m_tina);
}

void TestResults::openLeadsToTheDebrief() {
    open();
    auto* table = find<QTableWidget>("results.attempts");
    table->setFocus();
    table->setCurrentCell(0, 0);
    QTest::keyClick(table, Qt::Key_Return);
    const desktop::Place place = m_site->context.navigator().current();
    QCOMPARE(place.screen, QStringLiteral("debrief"));
    QCOMPARE(place.parameters.value(QStringLiteral("session")).toLongLong(), m_last); // the newest is on top
}

/// From a debrief to the curve of that person at that exercise and level, and back; what was chosen stays
/// chosen, and whose it is, too.
void TestResults::opensWhereOneIsAndStaysThere() {
    const tests::ReviewSessions& made = *m_made;
    const auto theo = m_site->actor("theo");
    MadeSession lower = made.good, practice = made.good;
    lower.setup.level.number = practice.setup.level.number = 1;
    practice.familiarisation = true;
    const auto first = tests::store(m_site->database(), theo, lower);
    const auto second = tests::store(m_site->database(), theo, made.bad);
    tests::store(m_site->database(), theo, practice);
    const auto level = [this] { return find<QComboBox>("results.level")->currentData().toInt(); };
    m_site->logIn("theo");
    open();
    QCOMPARE(level(), 2); // the last scored attempt, not the practice after it
    m_site->logIn("tom");
    m_site->go(QStringLiteral("debrief"), {{QStringLiteral("session"), qlonglong(first)}});
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
    find<QPushButton>("debrief.results")->click();
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("results"));
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
    QCOMPARE(level(), 1); // that of the attempt in hand
    auto* box = find<QComboBox>("results.level");
    const int two = box->findData(2);
    box->setCurrentIndex(two);
    emit box->activated(two);
    QTest::keyClick(find<QTableWidget>("results.attempts"), Qt::Key_Return);
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("session")).toLongLong(),
             second);
    m_site->context.navigator().back();
    QTRY_VERIFY_WITH_TIMEOUT(tests::isLoaded(*m_site), kPatience_ms);
    QVERIFY(m_site->window->screen()->title().contains(QStringLiteral("Theo Trainee")));
    QCOMPARE(find<QTableWidget>("results.attempts")->rowCount(), 1); // theo's, and at level 2
    QCOMPARE(level(), 2);
    m_site->context.navigator().back();
    QCOMPARE(m_site->context.navigator().current().screen, QStringLiteral("debrief"));
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("session")).toLongLong(),
             first);
    m_site->context.logIn(*m_tina);
}

void TestResults::exportsEverything() {
    open();
    QTemporaryDir target;
    m_site->screen<desktop::ResultsScreen>()->exportTo(target.path());
    QTRY_VERIFY_WITH_TIMEOUT(m_site->context.background().idle(),
                             kPatience_ms); // seconds of samples are written
    QCOMPARE(QDir(target.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
    QDir folder(target.path());
    QVERIFY(folder.cd(folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot).first()));
    QCOMPARE(folder.entryList({QStringLiteral("session_*.csv")}).size(), 7);
    QFile json(folder.filePath(QStringLiteral("person.json")));
    QVERIFY(json.open(QIODevice::ReadOnly));
    const QJsonObject everything = QJsonDocument::fromJson(json.readAll()).object();
    QCOMPARE(everything["sessions"].toArray().size(), 7);
}

/// What is told of long work: from 0 on, never back and never beyond 1; and it ends where that is asked.
void TestResults::progressIsAShare() {
    auto connection = m_site->database().openReader();
    QVERIFY(connection);
    using Progress = std::function<bool(double)>;
    const std::vector<std::pair<const char*, std::function<bool(const Progress&)>>> works{
        {"results",
         [&](const Progress& progress) {
             return desktop::loadAttempts(**connection, *m_tina, m_tina->personId(), progress).has_value();
         }},
        {"one's own data",
         [&](const Progress& progress) {
             const QTemporaryDir folder;
             return desktop::exportOwnData(**connection, *m_tina, folder.path().toStdString(), progress)
                 .has_value();
         }},
        {"playback", [&](const Progress& progress) {
             return desktop::loadPlayback(**connection, *m_tina, m_last, progress).has_value();
         }}};
    for (const auto& [name, work] : works) {
        std::vector<double> shares;
        QVERIFY2(work([&shares](double share) {
                     shares.push_back(share);
                     return true;
                 }),
                 name);
        QVERIFY2(shares.size() > 1 && std::is_sorted(shares.begin(), shares.end()), name);
        QVERIFY2(shares.front() >= 0.0 && shares.front() < shares.back() && shares.back() <= 1.0, name);
        QVERIFY2(!work([](double) { return false; }), name);
    }
}

void TestResults::nothingClippedOrUnnamed() {
    const QStringList findings = tests::findingsOn(*m_site, [this] { open(); });
    QVERIFY2(findings.isEmpty(), qPrintable(findings.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestResults)
#include "test_results.moc"
