// SPDX-License-Identifier: GPL-3.0-or-later
// What people watch before they train shows how a level is passed.
#include "ladder/ladder.h"

#include "session/exercise_kind.h"
#include "support/level_rows.h"

#include <QtTest>

using namespace chiron;

class TestDemonstrations : public QObject {
    Q_OBJECT
private slots:
    void everyLevelIsPassed_data();
    void everyLevelIsPassed();

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
};

void TestDemonstrations::everyLevelIsPassed_data() {
    tests::addLevelRows(m_catalogue);
}

void TestDemonstrations::everyLevelIsPassed() {
    QFETCH(QString, exercise);
    QFETCH(int, number);
    const auto kind = session::exerciseKind(exercise.toStdString());
    QVERIFY(kind.has_value());
    tests::LadderSettings settings;
    settings.seeds = 1;
    settings.first = (*kind)->demonstrationSeed();
    settings.checkEvery = 0;
    settings.operators = {"expert"};
    const tests::LadderLevel level =
        tests::climb(*m_catalogue.find(exercise.toStdString(), number), settings);
    const auto& sessions = level.byOperator.at("expert");
    QCOMPARE(sessions.size(), std::size_t{1});
    QVERIFY2(tests::passRate(sessions).of == 1,
             "what is shown does not pass: another ExerciseKind::demonstrationSeed() is needed");
}

QTEST_GUILESS_MAIN(TestDemonstrations)
#include "test_demonstrations.moc"
