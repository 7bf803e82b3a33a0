// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "support/apex_session.h"

#include <QtTest>
#include <map>
#include <numeric>

using namespace chiron;
using support::ApexDeception;
using support::ApexTrialResult;
using support::runApexSession;

/// The three trainees over 20 seeds at level 2 (haptics alone, 500 N/m, no friction), and the tests that they
/// really search by what they feel.
class TestApexOperatorsLong : public QObject {
    Q_OBJECT
private slots:
    void trainedHandsSeparate();
    void withoutForceAllAreAtChance_data() { names(); }
    void withoutForceAllAreAtChance();
    void mirroredFieldIsFollowed_data() { names(); }
    void mirroredFieldIsFollowed();
    void shiftedBallIsFollowed();
    void delaySpoilsScores();

private:
    static void names() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"novice", "intermediate", "expert"})
            QTest::addRow("%s", name) << name;
    }
};

namespace {

constexpr std::uint64_t kSeeds = 20;

struct Statistic {
    double mean = 0.0, standardError = 0.0;
    QString text() const { return QString("%1 ± %2").arg(mean, 0, 'f', 1).arg(standardError, 0, 'f', 1); }
};

Statistic over(const std::vector<double>& values) {
    const double n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0.0;
    for (double value : values)
        squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (n - 1.0) / n)};
}

std::vector<std::vector<ApexTrialResult>> sessions(const std::string& name, std::uint64_t seeds,
                                                   const ApexDeception& deception = {}) {
    std::vector<std::vector<ApexTrialResult>> all;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        all.push_back(runApexSession({name, seed, {}, deception}).trials);
    return all;
}

/// Mean absolute error of each session against the centre times `sign`, % of R.
std::vector<double> errors(const std::vector<std::vector<ApexTrialResult>>& all, double sign = 1.0) {
    std::vector<double> means;
    for (const auto& trials : all) {
        double sum = 0.0;
        for (ApexTrialResult trial : trials) {
            trial.centre *= sign;
            sum += trial.meanAbsoluteError_percent();
        }
        means.push_back(sum / static_cast<double>(trials.size()));
    }
    return means;
}

double distance(const std::vector<ApexTrialResult>& trials, const std::vector<std::size_t>& centreOf) {
    double sum = 0.0;
    for (std::size_t i = 0; i < trials.size(); ++i)
        sum += (trials[i].mark - trials[centreOf[i]].centre).norm();
    return sum;
}

} // namespace

void TestApexOperatorsLong::trainedHandsSeparate() {
    const Statistic novice = over(errors(sessions("novice", kSeeds)));
    const Statistic intermediate = over(errors(sessions("intermediate", kSeeds)));
    const Statistic expert = over(errors(sessions("expert", kSeeds)));
    qInfo("novice %s, intermediate %s, expert %s", qPrintable(novice.text()), qPrintable(intermediate.text()),
          qPrintable(expert.text()));
    const auto below = [](const Statistic& a, const Statistic& b) {
        return b.mean - a.mean > 2.0 * std::hypot(a.standardError, b.standardError);
    };
    QVERIFY(below(expert, intermediate));
    QVERIFY(below(intermediate, novice));
}

// Chance: who knows nothing but the disc does best by always marking its middle, mean |x| = 4a/(3π) = 17.0
// mm, 84.9 % of R for a = 40 mm. And marks fit their own trial's centre no better than another trial's.
void TestApexOperatorsLong::withoutForceAllAreAtChance() {
    QFETCH(QString, name);
    ApexDeception deception;
    deception.mute = true;
    const auto all = sessions(name.toStdString(), 6, deception);
    const Statistic error = over(errors(all));
    const double chance = 100.0 * 4.0 * 0.040 / (3.0 * core::kPi) / 0.020;
    std::vector<ApexTrialResult> pooled;
    for (const auto& trials : all)
        pooled.insert(pooled.end(), trials.begin(), trials.end());
    std::vector<std::size_t> order(pooled.size());
    std::iota(order.begin(), order.end(), 0u);
    const double own = distance(pooled, order);
    core::Random random(1);
    int better = 0;
    constexpr int kShuffles = 1000;
    for (int shuffle = 0; shuffle < kShuffles; ++shuffle) {
        for (std::size_t i = order.size() - 1; i > 0; --i)
            std::swap(order[i], order[random.below(i + 1)]);
        better += distance(pooled, order) <= own;
    }
    qInfo("%s without force: %s, chance at best %.1f; own centre beats %.1f %% of shuffles", qPrintable(name),
          qPrintable(error.text()), chance, 100.0 - 100.0 * better / kShuffles);
    QVERIFY(error.mean > chance - 3.0 * error.standardError);
    QVERIFY(better > kShuffles / 100); // p > 0.01, one-sided
}

void TestApexOperatorsLong::mirroredFieldIsFollowed() {
    QFETCH(QString, name);
    ApexDeception deception;
    deception.mirrored = true;
    const auto all = sessions(name.toStdString(), 4, deception);
    const Statistic toField = over(errors(all, -1.0)), toPlan = over(errors(all, 1.0));
    qInfo("%s mirrored: %s to the field, %s to the plan", qPrintable(name), qPrintable(toField.text()),
          qPrintable(toPlan.text()));
    QVERIFY(toField.mean < 0.5 * toPlan.mean);
}

void TestApexOperatorsLong::shiftedBallIsFollowed() {
    ApexDeception deception;
    deception.shift = core::Vec2(0.012, 0.0);
    deception.shiftAfter_s = 12.0;
    int toNew = 0, count = 0;
    double oldDistance = 0.0, newDistance = 0.0;
    for (const char* name : {"intermediate", "expert"}) {
        for (const auto& trials : sessions(name, 5, deception)) {
            for (const auto& trial : trials) {
                if (trial.time_s < deception.shiftAfter_s + 8.0)
                    continue; // had its mind made up
                const double before = (trial.mark - trial.centre).norm();
                const double after = (trial.mark - trial.centre - deception.shift).norm();
                oldDistance += before;
                newDistance += after;
                toNew += after < before;
                ++count;
            }
        }
    }
    qInfo("shifted by 12 mm: %d of %d marks nearer to the new place; %.1f mm from it, %.1f from the old",
          toNew, count, 1e3 * newDistance / count, 1e3 * oldDistance / count);
    QVERIFY(count > 30);
    QVERIFY(toNew > 0.75 * count && newDistance < oldDistance);
}

void TestApexOperatorsLong::delaySpoilsScores() {
    ApexDeception deception;
    deception.delay_ticks = 200;
    for (const char* name : {"novice", "intermediate", "expert"}) {
        const Statistic late = over(errors(sessions(name, 8, deception))),
                        prompt = over(errors(sessions(name, 8)));
        qInfo("%s with 200 ms of delay: %s, without %s", name, qPrintable(late.text()),
              qPrintable(prompt.text()));
        QVERIFY(late.mean - prompt.mean > 2.0 * std::hypot(late.standardError, prompt.standardError));
    }
}

QTEST_APPLESS_MAIN(TestApexOperatorsLong)
#include "test_apex_operators_long.moc"
