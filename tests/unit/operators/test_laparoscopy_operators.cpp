// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/laparoscopy_session.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using support::contentLevel;
using support::LaparoscopyOutcome;
using support::runLaparoscopy;

/// The scripted laparoscopists at every level of both exercises, one trial each: they finish, they differ,
/// and they know nothing that they do not feel or see. test_laparoscopy_operators_long has twenty seeds.
class TestLaparoscopyOperators : public QObject {
    Q_OBJECT
private slots:
    void everyLevelIsDone_data();
    void everyLevelIsDone();
    void sameSeedSameSession();
    void unsafeHurts();
    void hiddenObjectsAreNotFound_data();
    void hiddenObjectsAreNotFound();
};

namespace {

std::vector<const char*> exercises() {
    return {"elastic_tube", "object_handling"};
}

int levelsOf(const char* exercise) {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    int count = 0;
    while (catalogue->find(exercise, count + 1) != nullptr)
        ++count;
    return count;
}

void levelRows(int most) {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    for (const char* exercise : exercises())
        for (int level = 1; level <= std::min(most, levelsOf(exercise)); ++level)
            QTest::newRow(qPrintable(QString("%1 %2").arg(exercise).arg(level)))
                << QString(exercise) << level;
}

} // namespace

void TestLaparoscopyOperators::everyLevelIsDone_data() {
    levelRows(99);
}

void TestLaparoscopyOperators::everyLevelIsDone() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    for (const char* name : {"expert", "intermediate"}) {
        const LaparoscopyOutcome outcome =
            runLaparoscopy({contentLevel(exercise.toStdString(), level, 1), name, 1, {}});
        QVERIFY2(outcome.ran && outcome.trials() == 1, name);
        QVERIFY2(outcome.completed() == 1, name);
    }
}

void TestLaparoscopyOperators::sameSeedSameSession() {
    const auto level = contentLevel("elastic_tube", 4, 1); // two hands of one mind
    const auto a = runLaparoscopy({level, "novice", 3, {}});
    const auto b = runLaparoscopy({level, "novice", 3, {}});
    const auto c = runLaparoscopy({level, "novice", 4, {}});
    QVERIFY(a.ran && a.digest == b.digest && a.digest != c.digest);
}

void TestLaparoscopyOperators::unsafeHurts() {
    const auto tube = contentLevel("elastic_tube", 1, 2);
    QVERIFY(runLaparoscopy({tube, "unsafe", 1, {}}).metric("force_max") >
            runLaparoscopy({tube, "expert", 1, {}}).metric("force_max"));
    const auto ovary = contentLevel("object_handling", 2, 1);
    const double unsafe = runLaparoscopy({ovary, "unsafe", 1, {}}).metric("squeeze_max");
    const double expert = runLaparoscopy({ovary, "expert", 1, {}}).metric("squeeze_max");
    QVERIFY2(unsafe > expert, qPrintable(QString("%1, %2").arg(unsafe).arg(expert)));
}

void TestLaparoscopyOperators::hiddenObjectsAreNotFound_data() {
    levelRows(1);
} // it is the same mind at every level

// What the screen does not show they do not know of: nobody moves towards it, and nothing is done.
void TestLaparoscopyOperators::hiddenObjectsAreNotFound() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    const auto outcome =
        runLaparoscopy({contentLevel(exercise.toStdString(), level, 1), "expert", 1, {.hidden = true}});
    QCOMPARE(outcome.completed(), 0);
}

QTEST_APPLESS_MAIN(TestLaparoscopyOperators)
#include "test_laparoscopy_operators.moc"
