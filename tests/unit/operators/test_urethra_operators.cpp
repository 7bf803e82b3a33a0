// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sanitized.h"
#include "support/urethra_session.h"

#include <QtTest>

using namespace chiron;
using support::runUrethraSession;
using support::standardInsertion;
using support::UrethraOutcome;

class TestUrethraOperators : public QObject {
    Q_OBJECT
private slots:
    void namesAreKnown();
    void badSettingsAreRefused();
    void allFeelAlike();
    void sameSeedSameSession();
    void allDoTheWholeProcedure();
    void theHesitantTurnsBack();
    void shortLevelsEndAtTheirGoal();
    void strictureIsPassed();
    void withoutPictureNoneGetsFar();
    void upsideDownPictureMisleads();
    void expertBeatsNovice();
    void expertStaysFarBelowTheLimits();
    void unsafeHurts();
    void frictionDoesNotRing();
};

namespace {

std::vector<UrethraOutcome> sessions(const std::string& name, int seeds) {
    std::vector<UrethraOutcome> all;
    for (int seed = 1; seed <= seeds; ++seed)
        all.push_back(runUrethraSession({name, static_cast<std::uint64_t>(seed), standardInsertion(), {}}));
    return all;
}

double mean(const std::vector<UrethraOutcome>& all, double UrethraOutcome::*value) {
    double sum = 0.0;
    for (const UrethraOutcome& one : all)
        sum += one.*value;
    return sum / static_cast<double>(all.size());
}

} // namespace

void TestUrethraOperators::namesAreKnown() {
    QCOMPARE(operators::urethraInsertionOperatorNames().size(), std::size_t(5));
    for (const auto name : operators::urethraInsertionOperatorNames()) {
        const auto settings = operators::urethraInsertionOperatorSettings(name);
        QVERIFY(settings && settings->name == name);
        QVERIFY(operators::makeUrethraInsertionOperator(name, 1));
    }
    const auto unknown = operators::makeUrethraInsertionOperator("wizard", 1);
    QVERIFY(!unknown && unknown.error().code == core::ErrorCode::notFound);
    QVERIFY(unknown.error().message.find("wizard") != std::string::npos);
}

void TestUrethraOperators::badSettingsAreRefused() {
    auto settings = *operators::urethraInsertionOperatorSettings("expert");
    settings.pushLimit_N = -1.0;
    const auto negative = operators::makeUrethraInsertionOperator(settings, 1);
    QVERIFY(!negative && negative.error().message.find("pushLimit_N") != std::string::npos);
    settings = *operators::urethraInsertionOperatorSettings("expert");
    settings.insertSpeed_m_per_s = std::nan("");
    QVERIFY(!operators::makeUrethraInsertionOperator(settings, 1));
}

// They differ in what they do, not in how well they feel and see.
void TestUrethraOperators::allFeelAlike() {
    const auto a = operators::urethraInsertionOperatorSettings("expert")->perception;
    for (const auto name : operators::urethraInsertionOperatorNames()) {
        const auto b = operators::urethraInsertionOperatorSettings(name)->perception;
        QVERIFY(a.angleBiasSd_rad == b.angleBiasSd_rad && a.angleNoiseSd_rad == b.angleNoiseSd_rad);
        QVERIFY(a.pictureNoiseSd_rad == b.pictureNoiseSd_rad && a.unmarkedFactor == b.unmarkedFactor);
        QVERIFY(a.distanceWeberFraction == b.distanceWeberFraction && a.depthNoiseSd_m == b.depthNoiseSd_m);
        QVERIFY(a.forceWeberFraction == b.forceWeberFraction && a.forceFloorSd_N == b.forceFloorSd_N);
        QVERIFY(a.torqueWeberFraction == b.torqueWeberFraction && a.torqueFloorSd_Nm == b.torqueFloorSd_Nm);
        QVERIFY(a.directionNoiseSd_rad == b.directionNoiseSd_rad &&
                a.directionBiasSd_rad == b.directionBiasSd_rad);
    }
}

void TestUrethraOperators::sameSeedSameSession() {
    const auto a = runUrethraSession({"intermediate", 3, standardInsertion(), {}});
    const auto b = runUrethraSession({"intermediate", 3, standardInsertion(), {}});
    const auto c = runUrethraSession({"intermediate", 4, standardInsertion(), {}});
    QVERIFY(a.completed && a.time_s == b.time_s && a.digest == b.digest);
    QVERIFY(a.digest != c.digest);
}

void TestUrethraOperators::allDoTheWholeProcedure() {
    for (const auto name : operators::urethraInsertionOperatorNames()) {
        const auto outcome = runUrethraSession({std::string(name), 2, standardInsertion(), {}});
        QVERIFY2(outcome.began && outcome.completed, std::string(name).c_str());
        QCOMPARE(outcome.landmarks, 5);
        QVERIFY2(outcome.depth_mm > 133.0 && outcome.time_s > 15.0, std::string(name).c_str());
    }
}

// Nobody else turns back, so that nothing else would show that reversals are counted.
void TestUrethraOperators::theHesitantTurnsBack() {
    const auto hesitant = runUrethraSession({"hesitant", 2, standardInsertion(), {}});
    QVERIFY2(hesitant.completed && hesitant.reversals >= 1, qPrintable(QString::number(hesitant.reversals)));
}

void TestUrethraOperators::shortLevelsEndAtTheirGoal() {
    for (const double goal : {0.035, 0.080}) {
        auto level = standardInsertion();
        level.goalDepth_m = goal;
        level.landmarks.clear();
        level.withdraws = false;
        const auto there = runUrethraSession({"expert", 1, level, {}});
        QVERIFY(there.completed && there.depth_mm >= 1e3 * goal && there.depth_mm < 1e3 * goal + 5.0);
        level.withdraws = true;
        const auto back = runUrethraSession({"intermediate", 1, level, {}});
        QVERIFY(back.completed && back.time_s > there.time_s);
    }
}

void TestUrethraOperators::strictureIsPassed() {
    auto level = standardInsertion();
    level.anatomy.changeCount = 1;
    level.anatomy.changes[0].centre_m = 0.075;
    level.anatomy.changes[0].stiffnessFactor = 15.0;
    for (const char* name : {"expert", "intermediate", "novice"})
        QVERIFY2(runUrethraSession({name, 1, level, {}}).completed, name);
}

// They go by what they see: whoever stops when there is nothing to see stays out, who does not gets stuck or
// leaves the canal.
void TestUrethraOperators::withoutPictureNoneGetsFar() {
    auto level = standardInsertion();
    level.trialLimit_s = 40.0;
    for (const char* name : {"expert", "intermediate"}) {
        const auto blind = runUrethraSession({name, 1, level, {.hidden = true}});
        QVERIFY2(blind.began && !blind.completed && blind.depth_mm < 10.0, name);
    }
    const auto novice = runUrethraSession({"novice", 1, level, {.hidden = true}});
    QVERIFY(!novice.completed && novice.landmarks == 0 && novice.offsetRms_mm > 8.0);
}

void TestUrethraOperators::upsideDownPictureMisleads() {
    auto level = standardInsertion();
    level.trialLimit_s = 60.0;
    for (const char* name : {"expert", "intermediate", "novice"}) {
        const auto misled = runUrethraSession({name, 1, level, {.upsideDown = true}});
        QVERIFY2(!misled.completed, name);
    }
}

// The short form of the table in the module's page; test_urethra_operators_long has all 20 seeds.
void TestUrethraOperators::expertBeatsNovice() {
    CHIRON_SKIP_STATISTICS(); // sessions of both run in allDoTheWholeProcedure()
    const auto expert = sessions("expert", 3), novice = sessions("novice", 3);
    for (const auto value : {&UrethraOutcome::offsetRms_mm, &UrethraOutcome::bendAlignment_deg,
                             &UrethraOutcome::forceP95_N, &UrethraOutcome::torqueP95_mNm})
        QVERIFY2(mean(expert, value) < mean(novice, value),
                 qPrintable(QString("%1, %2").arg(mean(expert, value)).arg(mean(novice, value))));
}

void TestUrethraOperators::expertStaysFarBelowTheLimits() {
    for (const UrethraOutcome& outcome : sessions("expert", support::repeated(3))) {
        QVERIFY2(outcome.overForce_percent < 5.0, qPrintable(QString::number(outcome.overForce_percent)));
        QVERIFY2(outcome.overTorque_percent < 5.0, qPrintable(QString::number(outcome.overTorque_percent)));
    }
}

void TestUrethraOperators::unsafeHurts() {
    const auto unsafe = runUrethraSession({"unsafe", 1, standardInsertion(), {}});
    QVERIFY(unsafe.trauma > 0 && unsafe.forceMax_N > 4.0 && unsafe.overTorque_percent > 5.0);
}

// Friction's slope, the mechanism's tendons and an old velocity may ring; with a budget far above the
// mechanism's they do.
void TestUrethraOperators::frictionDoesNotRing() {
    const auto good = runUrethraSession({"expert", 1, standardInsertion(), {}});
    QVERIFY2(good.chatter_N < 0.05, qPrintable(QString::number(good.chatter_N)));
    auto level = standardInsertion();
    level.forces.maximumDamping_Ns_per_m = 150.0;
    const auto ringing = runUrethraSession({"expert", 1, level, {}, 150.0});
    QVERIFY2(ringing.chatter_N > 0.15, qPrintable(QString::number(ringing.chatter_N)));
}

QTEST_APPLESS_MAIN(TestUrethraOperators)
#include "test_urethra_operators.moc"
