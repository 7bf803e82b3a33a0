// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/laparoscopy_session.h"

#include <QtTest>
#include <map>

using namespace chiron;
using support::contentLevel;
using support::LaparoscopyDeception;
using support::LaparoscopyOutcome;
using support::runLaparoscopy;

/// Novice to expert over twenty seeds that nothing was tuned on (101 to 120; README.md of both operators),
/// one trial a session: scores separate at every level, and what is not felt or seen is missed.
class TestLaparoscopyOperatorsLong : public QObject {
    Q_OBJECT
private slots:
    void skillsSeparate_data();
    void skillsSeparate();
    void withoutForceWeighingIsChance();
    void feelingKeepsATensionWithoutTheBar();
};

namespace {

constexpr std::uint64_t kFirst = 101, kSeeds = 20;

struct Statistic {
    double mean = 0.0, standardError = 0.0;
};

Statistic of(const std::vector<double>& values) {
    const double n = static_cast<double>(values.size());
    double sum = 0.0, squares = 0.0;
    for (const double value : values)
        sum += value;
    for (const double value : values)
        squares += (value - sum / n) * (value - sum / n);
    return n > 1.0 ? Statistic{sum / n, std::sqrt(squares / (n - 1.0) / n)} : Statistic{};
}

/// Less by more than twice the standard error of the difference.
bool clearlyLess(const Statistic& a, const Statistic& b) {
    return b.mean - a.mean > 2.0 * std::hypot(a.standardError, b.standardError);
}

Statistic metricOver(const catalogue::ExerciseLevel& level, const char* name, const QString& metric,
                     const LaparoscopyDeception& deception = {}) {
    std::vector<double> values;
    for (std::uint64_t seed = kFirst; seed < kFirst + kSeeds; ++seed) {
        const double value = runLaparoscopy({level, name, seed, deception}).metric(metric.toStdString());
        if (std::isfinite(value))
            values.push_back(value);
    }
    return of(values);
}

} // namespace

void TestLaparoscopyOperatorsLong::skillsSeparate_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    QTest::addColumn<QString>("metric");
    for (const int level : {1, 3, 4})
        QTest::newRow(qPrintable(QString("tube %1").arg(level)))
            << "elastic_tube" << level << "tension_error_rms";
    for (const int level : {2, 5})
        QTest::newRow(qPrintable(QString("tube %1").arg(level))) << "elastic_tube" << level << "path_length";
    for (const int level : {1, 2, 3})
        QTest::newRow(qPrintable(QString("handling %1").arg(level)))
            << "object_handling" << level << "squeeze_max";
}

void TestLaparoscopyOperatorsLong::skillsSeparate() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    QFETCH(QString, metric);
    const auto asked = contentLevel(exercise.toStdString(), level, 1);
    const Statistic expert = metricOver(asked, "expert", metric),
                    novice = metricOver(asked, "novice", metric);
    QVERIFY2(clearlyLess(expert, novice), qPrintable(QString("%1, %2").arg(expert.mean).arg(novice.mean)));
}

// Three objects look alike: who does not feel them is right once in three.
void TestLaparoscopyOperatorsLong::withoutForceWeighingIsChance() {
    const auto level = contentLevel("object_handling", 3, 4);
    double felt = 0.0, mute = 0.0;
    constexpr int kSessions = 8;
    for (std::uint64_t seed = kFirst; seed < kFirst + kSessions; ++seed) {
        felt += runLaparoscopy({level, "expert", seed, {}}).metric("weighing_correct") / kSessions;
        mute +=
            runLaparoscopy({level, "expert", seed, {.mute = true}}).metric("weighing_correct") / kSessions;
    }
    QVERIFY2(felt > 80.0, qPrintable(QString::number(felt)));
    QVERIFY2(std::abs(mute - 33.3) <
                 3.0 * 100.0 *
                     std::sqrt(1.0 / 3.0 * 2.0 / 3.0 / (4.0 * kSessions)), // three standard errors of chance
             qPrintable(QString::number(mute)));
}

void TestLaparoscopyOperatorsLong::feelingKeepsATensionWithoutTheBar() {
    const auto level = contentLevel("elastic_tube", 1, 1);
    const auto felt = metricOver(level, "expert", "tension_error_rms", {.noBars = true});
    const auto mute = metricOver(level, "expert", "tension_error_rms", {.mute = true, .noBars = true});
    const auto bar = metricOver(level, "expert", "tension_error_rms");
    QVERIFY2(clearlyLess(felt, mute), qPrintable(QString("%1, %2").arg(felt.mean).arg(mute.mean)));
    QVERIFY2(bar.mean < felt.mean, qPrintable(QString("%1, %2").arg(bar.mean).arg(felt.mean)));
}

QTEST_APPLESS_MAIN(TestLaparoscopyOperatorsLong)
#include "test_laparoscopy_operators_long.moc"
