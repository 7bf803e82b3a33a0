// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/apex_session.h"
#include "support/sanitized.h"

#include <QtTest>

using namespace chiron;
using support::ApexSession;
using support::runApexSession;

class TestApexOperators : public QObject {
    Q_OBJECT
private slots:
    void namesAreKnown();
    void badSettingsAreRefused();
    void allFeelAlike();
    void sameSeedSameSession();
    void waitsForArmingAndGoesThroughTrials();
    void looksWhereItMayLook();
    void expertBeatsNovice();
    void unsafeGoesOverTheLimit();
    void mirroredFieldIsFollowed();
};

namespace {

simulation::SphereApexParameters shortLevel(int trials) {
    simulation::SphereApexParameters level;
    level.trials = trials;
    return level;
}

double meanError(const std::vector<support::ApexTrialResult>& trials) {
    double sum = 0.0;
    for (const auto& trial : trials)
        sum += trial.meanAbsoluteError_percent();
    return sum / static_cast<double>(trials.size());
}

double meanError(const std::string& name, std::uint64_t seeds, int trials) {
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
        sum += meanError(runApexSession({name, seed, shortLevel(trials), {}}).trials);
    return sum / static_cast<double>(seeds);
}

} // namespace

void TestApexOperators::namesAreKnown() {
    QCOMPARE(operators::sphereApexOperatorNames().size(), std::size_t(4));
    for (const auto name : operators::sphereApexOperatorNames()) {
        const auto settings = operators::sphereApexOperatorSettings(name);
        QVERIFY(settings && settings->name == name);
        QVERIFY(operators::makeSphereApexOperator(name, 1));
    }
    const auto unknown = operators::makeSphereApexOperator("wizard", 1);
    QVERIFY(!unknown && unknown.error().code == core::ErrorCode::notFound);
    QVERIFY(unknown.error().message.find("wizard") != std::string::npos);
}

void TestApexOperators::badSettingsAreRefused() {
    auto settings = *operators::sphereApexOperatorSettings("expert");
    settings.force_N = -1.0;
    const auto negative = operators::makeSphereApexOperator(settings, 1);
    QVERIFY(!negative && negative.error().message.find("force_N") != std::string::npos);
    settings = *operators::sphereApexOperatorSettings("expert");
    settings.sweepSpeed_m_per_s = std::nan("");
    QVERIFY(!operators::makeSphereApexOperator(settings, 1));
}

// They differ in what they do, not in how well they feel.
void TestApexOperators::allFeelAlike() {
    const auto reference = operators::sphereApexOperatorSettings("expert")->perception;
    for (const auto name : operators::sphereApexOperatorNames()) {
        const auto felt = operators::sphereApexOperatorSettings(name)->perception;
        QVERIFY(felt.positionBiasSd_m == reference.positionBiasSd_m &&
                felt.positionNoiseSd_m == reference.positionNoiseSd_m);
        QVERIFY(felt.forceWeberFraction == reference.forceWeberFraction &&
                felt.forceFloorSd_N == reference.forceFloorSd_N);
        QVERIFY(felt.directionNoiseSd_rad == reference.directionNoiseSd_rad &&
                felt.directionBiasSd_rad == reference.directionBiasSd_rad);
        QVERIFY(felt.visionNoiseSd_m == reference.visionNoiseSd_m);
    }
}

void TestApexOperators::sameSeedSameSession() {
    const auto a = runApexSession({"intermediate", 3, shortLevel(2), {}});
    const auto b = runApexSession({"intermediate", 3, shortLevel(2), {}});
    const auto c = runApexSession({"intermediate", 4, shortLevel(2), {}});
    QVERIFY(a.ticks > 0 && a.ticks == b.ticks && a.digest == b.digest);
    QVERIFY(a.digest != c.digest);
}

void TestApexOperators::waitsForArmingAndGoesThroughTrials() {
    for (const auto name : operators::sphereApexOperatorNames()) {
        const auto outcome = runApexSession({std::string(name), 2, shortLevel(3), {}});
        QCOMPARE(outcome.trials.size(), std::size_t(3));
        for (const auto& trial : outcome.trials)
            QVERIFY2(trial.marked && trial.time_s > 1.0, std::string(name).c_str());
    }
}

// With the object on the screen it goes there by sight: near, and much sooner than by touch alone.
void TestApexOperators::looksWhereItMayLook() {
    auto level = shortLevel(5);
    level.cues = {"object", "tool"};
    const auto seen = runApexSession({"intermediate", 1, level, {}});
    const auto felt = runApexSession({"intermediate", 1, shortLevel(5), {}});
    double seenTime = 0.0, feltTime = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
        seenTime += seen.trials[i].time_s;
        feltTime += felt.trials[i].time_s;
    }
    QVERIFY2(meanError(seen.trials) < 25.0, qPrintable(QString::number(meanError(seen.trials))));
    QVERIFY(seenTime < 0.7 * feltTime);
}

// The short form of the table in the module's page; test_apex_operators_long has all 20 seeds.
void TestApexOperators::expertBeatsNovice() {
    CHIRON_SKIP_STATISTICS(); // sessions of both run in waitsForArmingAndGoesThroughTrials()
    const double expert = meanError("expert", 3, 5), novice = meanError("novice", 3, 5);
    QVERIFY2(expert < novice, qPrintable(QString("expert %1, novice %2").arg(expert).arg(novice)));
}

void TestApexOperators::unsafeGoesOverTheLimit() {
    const auto unsafe = runApexSession({"unsafe", 1, shortLevel(3), {}});
    const auto expert = runApexSession({"expert", 1, shortLevel(3), {}});
    double most = 0.0, least = 1e9;
    for (const auto& trial : unsafe.trials)
        most = std::max(most, trial.maximumForce_N);
    for (const auto& trial : expert.trials)
        least = std::min(least, trial.maximumForce_N);
    QVERIFY2(most > 4.0 && least < 4.0, qPrintable(QString("%1 %2").arg(most).arg(least)));
}

void TestApexOperators::mirroredFieldIsFollowed() {
    ApexSession session{"expert", 1, shortLevel(4), {}};
    session.deception.mirrored = true;
    for (const auto& trial : runApexSession(session).trials) {
        if (trial.centre.norm() > 0.020) {
            QVERIFY((trial.mark + trial.centre).norm() < (trial.mark - trial.centre).norm());
        }
    }
}

QTEST_APPLESS_MAIN(TestApexOperators)
#include "test_apex_operators.moc"
