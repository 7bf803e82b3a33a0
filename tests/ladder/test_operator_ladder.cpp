// SPDX-License-Identifier: GPL-3.0-or-later
// The careful pass, the careless do not, and a novice finds each level harder than the one before: by
// interval, so that a few seeds refute what is plainly wrong and many refute the rest.
#include "ladder/ladder.h"

#include <QtTest>
#include <cstdio>
#include <random>

using namespace chiron;
using tests::LadderLevel;
using tests::Rate;

namespace {

std::uint64_t seedOfRun() {
    bool given = false;
    const std::uint64_t seed = qEnvironmentVariable("CHIRON_LADDER_SEED").toULongLong(&given);
    return given ? seed : 1 + std::random_device{}() % 1000000;
}

} // namespace

class TestOperatorLadder : public QObject {
    Q_OBJECT
private slots:
    void everyExercise_data();
    void everyExercise();

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
};

void TestOperatorLadder::everyExercise_data() {
    QTest::addColumn<QString>("exercise");
    for (const catalogue::Exercise& exercise : m_catalogue.exercises())
        QTest::newRow(exercise.id.c_str()) << QString::fromStdString(exercise.id);
}

void TestOperatorLadder::everyExercise() {
    QFETCH(QString, exercise);
    tests::LadderSettings settings;
    settings.seeds = 4 * std::max(1, qEnvironmentVariableIntValue("CHIRON_SOAK"));
    settings.first = seedOfRun();
    settings.checkEvery = 2;
    std::printf("seeds from %llu\n%s", static_cast<unsigned long long>(settings.first),
                tests::heading().c_str());
    QStringList wrong;
    std::optional<Rate> before;
    for (const catalogue::ExerciseLevel& level : m_catalogue.find(exercise.toStdString())->levels) {
        const LadderLevel climbed = tests::climb(level, settings);
        std::printf("%s", tests::lines(climbed).c_str());
        std::fflush(stdout);
        const QString where = QString::fromStdString(climbed.level);
        for (const std::string& line : tests::inverted(climbed))
            wrong << where + ": inverted " + QString::fromStdString(line);
        const auto rateOf = [&](const char* name) {
            return climbed.byOperator.contains(name)
                       ? std::optional(tests::passRate(climbed.byOperator.at(name)))
                       : std::nullopt;
        };
        if (const auto expert = rateOf("expert"); expert && expert->high() < 0.8)
            wrong << where + ": the expert passes too seldom";
        if (const auto unsafe = rateOf("unsafe"); unsafe && unsafe->low() > 0.05)
            wrong << where + ": the unsafe hand passes";
        if (const auto novice = rateOf("novice")) {
            if (!before && (novice->high() < 0.2 || novice->low() > 0.8))
                wrong << where + ": the first level does not suit a novice";
            if (before && tests::riseAtLeast(*before, *novice) > 0.0)
                wrong << where + ": easier than the level before";
            before = novice;
        }
        for (const auto& [name, sessions] : climbed.byOperator)
            for (const tests::LadderSession& session : sessions) {
                const QString who = QStringLiteral("%1, %2, seed %3: ")
                                        .arg(where, QString::fromStdString(name))
                                        .arg(session.seed);
                if (session.checked && !session.replaysIdentically)
                    wrong << who + "the replay differs";
                if (session.checked && !session.scoresIdentically)
                    wrong << who + "the recording scores differently";
                if (session.fast_N > 0.1)
                    wrong << who + QStringLiteral("%1 N rms above 20 Hz").arg(session.fast_N);
                if (!climbed.recordsEnergy && session.damped > 0)
                    wrong << who + QStringLiteral("damped in %1 ticks though its laws are conservative")
                                       .arg(session.damped);
            }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

QTEST_GUILESS_MAIN(TestOperatorLadder)
#include "test_operator_ladder.moc"
