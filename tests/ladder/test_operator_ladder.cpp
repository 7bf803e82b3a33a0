// SPDX-License-Identifier: GPL-3.0-or-later
// The careful pass, the careless do not, and a novice finds each level harder than the one before: by
// interval, so that a few seeds refute what is plainly wrong and many refute the rest. A row for each level,
// whose sessions are kept as they end: a run that was interrupted goes on where it stopped, and
// `operator_ladder table` prints the page's table from what is kept.
#include "ladder/ladder.h"
#include "ladder/ladder_store.h"
#include "support/level_rows.h"

#include <QtTest>
#include <algorithm>
#include <cstdio>
#include <optional>
#include <random>

using namespace chiron;
using tests::LadderLevel;
using tests::LadderSession;
using tests::Rate;

namespace {

constexpr int kSeeds = 20;
constexpr double kShakes_N = 0.1; ///< above 20 Hz, root mean square of half a second

std::uint64_t seedOfRun() {
    bool given = false;
    const std::uint64_t seed = qEnvironmentVariable("CHIRON_LADDER_SEED").toULongLong(&given);
    return given ? seed : 1 + std::random_device{}() % 1000000;
}

int seedsOfRun() {
    const int wanted = qEnvironmentVariableIntValue("CHIRON_LADDER_SEEDS");
    return wanted > 0 ? wanted : kSeeds * std::max(1, qEnvironmentVariableIntValue("CHIRON_SOAK"));
}

std::string folderOfRun() {
    return qEnvironmentVariable("CHIRON_LADDER_STORE", QStringLiteral(CHIRON_BINARY_DIR "/ladder"))
        .toStdString();
}

std::optional<Rate> rateOf(const LadderLevel& level, const char* name) {
    return level.byOperator.contains(name) ? std::optional(tests::passRate(level.byOperator.at(name)))
                                           : std::nullopt;
}

QString intervalOf(const Rate& rate) {
    return QStringLiteral("%1 of %2, 95 % interval %3 to %4 %")
        .arg(rate.of)
        .arg(rate.n)
        .arg(100.0 * rate.low(), 0, 'f', 0)
        .arg(100.0 * rate.high(), 0, 'f', 0);
}

} // namespace

class TestOperatorLadder : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyLevel_data();
    void everyLevel();
    void everyLevelIsHarderThanTheOneBefore_data();
    void everyLevelIsHarderThanTheOneBefore();

private:
    tests::LadderSettings settings();

    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    tests::LadderStore m_store{folderOfRun()};
    std::uint64_t m_first = seedOfRun();
};

void TestOperatorLadder::initTestCase() {
    std::printf(
        "%d seeds a level and operator, new ones from %llu (CHIRON_LADDER_SEED, CHIRON_LADDER_SEEDS); "
        "sessions of commit %s, models %s are kept in %s\n",
        seedsOfRun(), static_cast<unsigned long long>(m_first), m_store.sources().commit.c_str(),
        m_store.sources().models.c_str(), folderOfRun().c_str());
}

tests::LadderSettings TestOperatorLadder::settings() {
    tests::LadderSettings settings;
    settings.seeds = seedsOfRun();
    settings.first = m_first;
    settings.checkEvery = 1;
    settings.store = &m_store;
    return settings;
}

void TestOperatorLadder::everyLevel_data() {
    tests::addLevelRows(m_catalogue);
}

void TestOperatorLadder::everyLevel() {
    QFETCH(QString, exercise);
    QFETCH(int, number);
    const LadderLevel climbed = tests::climb(*m_catalogue.find(exercise.toStdString(), number), settings());
    std::printf("%s%s", tests::heading().c_str(), tests::lines(climbed).c_str());
    std::fflush(stdout);
    QStringList wrong;
    for (const std::string& line : tests::inverted(climbed))
        wrong << "inverted " + QString::fromStdString(line);
    for (const std::string& line : tests::unfounded(climbed))
        wrong << QString::fromStdString(line);
    if (const auto expert = rateOf(climbed, "expert"); expert && expert->high() < 0.8)
        wrong << "the expert passes too seldom: " + intervalOf(*expert);
    if (const auto unsafe = rateOf(climbed, "unsafe"); unsafe && unsafe->low() > 0.05)
        wrong << "the unsafe hand passes: " + intervalOf(*unsafe);
    if (const auto novice = rateOf(climbed, "novice");
        novice && number == 1 && (novice->high() < 0.2 || novice->low() > 0.8))
        wrong << "the first level does not suit a novice: " + intervalOf(*novice);
    for (const auto& [name, sessions] : climbed.byOperator)
        for (const LadderSession& session : sessions) {
            const QString who =
                QStringLiteral("%1, seed %2: ").arg(QString::fromStdString(name)).arg(session.seed);
            if (!session.checked || !session.replaysIdentically)
                wrong << who + "the replay differs";
            if (!session.checked || !session.scoresIdentically)
                wrong << who + "the recording scores differently";
            if (session.fast_N > kShakes_N)
                wrong << who + QStringLiteral("%1 N rms above 20 Hz").arg(session.fast_N);
        }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

void TestOperatorLadder::everyLevelIsHarderThanTheOneBefore_data() {
    QTest::addColumn<QString>("exercise");
    for (const catalogue::Exercise& exercise : m_catalogue.exercises())
        QTest::newRow(exercise.id.c_str()) << QString::fromStdString(exercise.id);
}

/// From what is kept of the levels: a level that was not run yet is compared with none.
void TestOperatorLadder::everyLevelIsHarderThanTheOneBefore() {
    QFETCH(QString, exercise);
    QStringList wrong;
    std::optional<Rate> before;
    int compared = 0;
    for (const catalogue::ExerciseLevel& level : m_catalogue.find(exercise.toStdString())->levels) {
        const auto novice = rateOf(tests::recalled(level, settings()), "novice");
        compared += before && novice ? 1 : 0;
        if (before && novice && tests::riseAtLeast(*before, *novice) > 0.0)
            wrong << QStringLiteral("level %1 is easier than the one before: %2; before: %3")
                         .arg(level.number)
                         .arg(intervalOf(*novice), intervalOf(*before));
        before = novice;
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    const auto levels = m_catalogue.find(exercise.toStdString())->levels.size();
    if (compared + 1 < static_cast<int>(levels))
        QSKIP("not every level has been run");
}

QTEST_GUILESS_MAIN(TestOperatorLadder)
#include "test_operator_ladder.moc"
