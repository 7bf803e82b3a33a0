// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing shakes, whoever holds what: one session of a scripted operator on every level, in every hand, on
// every mechanism on which the exercise can be done. The seed is drawn and printed (CHIRON_LADDER_SEED
// repeats it).
#include "ladder/ladder.h"
#include "session/exercise_kind.h"
#include "support/named_hands.h"

#include <QtTest>
#include <cstdio>
#include <random>

using namespace chiron;

namespace {

constexpr double kQuiet_N =
    0.1; ///< above 20 Hz, root mean square of half a second without a change of contact
/// Presses more than the trained ones and, unlike the unsafe hand, to the end of each level.
const std::string kOperator = "novice";

std::uint64_t seedOfRun() {
    bool given = false;
    const std::uint64_t seed = qEnvironmentVariable("CHIRON_LADDER_SEED").toULongLong(&given);
    return given ? seed : 1 + std::random_device{}() % 1000000;
}

} // namespace

class TestDampingHands : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void nothingShakes_data();
    void nothingShakes();

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    std::uint64_t m_seed = seedOfRun();
};

void TestDampingHands::initTestCase() {
    std::printf(
        "seed %llu, operator %s\n| level | mechanism | hand | above 20 Hz, N rms | windows | felt max., "
        "N |\n|---|---|---|---|---|---|\n",
        static_cast<unsigned long long>(m_seed), kOperator.c_str());
}

void TestDampingHands::nothingShakes_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("number");
    QTest::addColumn<QString>("mechanism");
    QTest::addColumn<QString>("hand");
    for (const catalogue::Exercise& exercise : m_catalogue.exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            for (const std::string_view mechanism : (*session::exerciseKind(exercise.id))->mechanisms())
                for (const std::string& hand : tests::namedHands())
                    QTest::newRow((exercise.id + "/" + std::to_string(level.number) + " " +
                                   std::string(mechanism) + " " + hand)
                                      .c_str())
                        << QString::fromStdString(exercise.id) << level.number
                        << QString::fromStdString(std::string(mechanism)) << QString::fromStdString(hand);
}

void TestDampingHands::nothingShakes() {
    QFETCH(QString, exercise);
    QFETCH(int, number);
    QFETCH(QString, mechanism);
    QFETCH(QString, hand);
    tests::LadderSettings settings;
    settings.seeds = std::max(1, qEnvironmentVariableIntValue("CHIRON_SOAK"));
    settings.first = m_seed;
    settings.checkEvery = 0;
    settings.mechanism = mechanism.toStdString();
    settings.hand = hand.toStdString();
    settings.operators = {kOperator};
    const tests::LadderLevel level =
        tests::climb(*m_catalogue.find(exercise.toStdString(), number), settings);
    QVERIFY2(level.byOperator.contains(kOperator), "the exercise has no such operator");
    std::uint64_t windows = 0;
    for (const tests::LadderSession& session : level.byOperator.at(kOperator)) {
        std::printf("| %s | %s | %s | %.3f | %llu | %.2f |\n", level.level.c_str(),
                    settings.mechanism.c_str(), settings.hand.c_str(), session.fast_N,
                    static_cast<unsigned long long>(session.windows), session.commanded_N);
        std::fflush(stdout);
        windows += session.windows;
        QVERIFY2(session.fast_N <= kQuiet_N, qPrintable(QStringLiteral("seed %1: %2 N before %3 s")
                                                            .arg(session.seed)
                                                            .arg(session.fast_N)
                                                            .arg(session.fastEnds_s)));
    }
    QVERIFY2(windows > 0, "no half second without a change of contact: nothing was measured in this hand");
}

QTEST_GUILESS_MAIN(TestDampingHands)
#include "test_damping_hands.moc"
