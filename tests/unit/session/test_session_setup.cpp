// SPDX-License-Identifier: GPL-3.0-or-later
#include "cues/laparoscopy_cues.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "modules/exercises/palpation/simulation/palpation_quantities.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "session/session_setup.h"
#include "session/session_view.h"
#include "simulation/palpation/tissue_surface.h"
#include "support/session_fixture.h"

#include <QtTest>
#include <cmath>

using namespace chiron;

namespace {

session::SessionSetup usualSetup() {
    session::SessionSetup setup;
    setup.level = tests::shortLevel(3, 2, 5.0);
    setup.seed = 0xfedcba9876543210ULL;
    auto station = session::scriptedStation(**session::exerciseKind("sphere_apex"), setup.level, "expert", 1);
    setup.devices = {station->tools.front().device->descriptor()};
    setup.mappings = station->mappings();
    setup.safety = session::headlessSafety(setup.level);
    return setup;
}

} // namespace

class TestSessionSetup : public QObject {
    Q_OBJECT
private slots:
    void comesBackFromItsColumns();
    void columnsFollowTheSetup();
    void scoringRuleIsKept();
    void badColumns_data();
    void badColumns();
    void toolCounts();
    void whatCannotBeFeltIsShown_data();
    void whatCannotBeFeltIsShown();
    void safetyFollowsTheExercise();
    void anyDifferenceOfScoresIsFound();
};

void TestSessionSetup::comesBackFromItsColumns() {
    const session::SessionSetup before = usualSetup();
    const database::NewSession columns = session::toNewSession(before);
    const auto after = session::setupFromStored(columns);
    QVERIFY2(after, after ? "" : after.error().message.c_str());
    QCOMPARE(after->seed, before.seed);
    QCOMPARE(after->level.resolvedSha256, before.level.resolvedSha256);
    const database::NewSession again = session::toNewSession(*after);
    QCOMPARE(again.deviceJson, columns.deviceJson);
    QCOMPARE(again.mappingJson, columns.mappingJson);
    QCOMPARE(again.supervisorJson, columns.supervisorJson);
    QCOMPARE(again.contentJson, columns.contentJson);
    QCOMPARE(again.versionsJson, columns.versionsJson);
}

void TestSessionSetup::columnsFollowTheSetup() {
    session::SessionSetup setup = usualSetup();
    const database::NewSession columns = session::toNewSession(setup);
    QCOMPARE(columns.exercise, std::string("sphere_apex"));
    QCOMPARE(columns.level, 3);
    QCOMPARE(columns.plannedTrials, 2);
    QCOMPARE(columns.forceLimit_N, setup.safety.exerciseForce_N);
    QVERIFY(columns.felt);
    for (const auto& metric : setup.level.metrics)
        QVERIFY(columns.versionsJson.find("\"" + metric.id + "\"") != std::string::npos);
    setup.devices.front().rendersForce = false;
    QVERIFY(!session::toNewSession(setup).felt);
}

// Sessions that say nothing of it score as they did: with the trial that was cut off.
void TestSessionSetup::scoringRuleIsKept() {
    session::SessionSetup setup = usualSetup();
    database::NewSession stored = session::toNewSession(setup);
    QCOMPARE(session::setupFromStored(stored)->scoring, session::ScoringRule::finishedTrials);
    setup.scoring = session::ScoringRule::begunTrials;
    QCOMPARE(session::setupFromStored(session::toNewSession(setup))->scoring,
             session::ScoringRule::begunTrials);
    for (const char* before : {R"({"models":"1"})", "{}", ""}) {
        stored.versionsJson = before;
        const auto again = session::setupFromStored(stored);
        QVERIFY2(again, again ? "" : again.error().message.c_str());
        QCOMPARE(again->scoring, session::ScoringRule::begunTrials);
    }
    for (const char* bad : {"{", R"({"scoring":3})", R"({"scoring":"2"})"}) {
        stored.versionsJson = bad;
        const auto refused = session::setupFromStored(stored);
        QVERIFY(!refused);
        QVERIFY(refused.error().message.find("versions") != std::string::npos);
    }
}

void TestSessionSetup::badColumns_data() {
    QTest::addColumn<QByteArray>("column");
    QTest::addColumn<QByteArray>("text");
    for (const char* column : {"content", "device", "mapping", "supervisor"}) {
        for (const char* text :
             {"", "{", "[]", "null", "{}", "{\"tools\":7}", "{\"tools\":[{}]}", "\xff\xfe"})
            QTest::addRow("%s %s", column, text) << QByteArray(column) << QByteArray(text);
    }
}

void TestSessionSetup::badColumns() {
    QFETCH(QByteArray, column);
    QFETCH(QByteArray, text);
    database::NewSession stored = session::toNewSession(usualSetup());
    std::string& target = column == "content"   ? stored.contentJson
                          : column == "device"  ? stored.deviceJson
                          : column == "mapping" ? stored.mappingJson
                                                : stored.supervisorJson;
    target = text.toStdString();
    const auto setup = session::setupFromStored(stored);
    QVERIFY(!setup);
    QCOMPARE(setup.error().code, core::ErrorCode::badInput);
    if (column != "content") // the catalogue names its own places
        QVERIFY2(setup.error().message.find(column.toStdString()) != std::string::npos,
                 setup.error().message.c_str());
}

void TestSessionSetup::toolCounts() {
    session::SessionSetup setup = usualSetup();
    setup.devices.push_back(setup.devices.front());
    QVERIFY(!session::setupFromStored(session::toNewSession(setup))); // two devices, one mapping
    setup.mappings.push_back({});
    const auto two = session::setupFromStored(session::toNewSession(setup));
    QVERIFY2(two, two ? "" : two.error().message.c_str());
    QCOMPARE(two->devices.size(), std::size_t{2});
    setup.devices.resize(core::kMaxTools + 1, setup.devices.front());
    setup.mappings.resize(core::kMaxTools + 1);
    QVERIFY(!session::setupFromStored(session::toNewSession(setup)));
}

void TestSessionSetup::whatCannotBeFeltIsShown_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    for (int level = 2; level <= 5; ++level)
        QTest::addRow("palpation %d", level) << "palpation" << level;
    QTest::newRow("weigh") << "object_handling" << 3;
}

// The scene fills the bars of a level's shown-force variant where no device of the setup renders force, and
// only there.
void TestSessionSetup::whatCannotBeFeltIsShown() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    session::SessionSetup setup = usualSetup();
    setup.level = *catalogue->find(exercise.toStdString(), level);
    const auto kind = session::exerciseKind(exercise.toStdString());
    core::Vec3 at(0.0, 0.0, 0.004);
    if (const auto* p = setup.level.parameters.find<simulation::PalpationParameters>()) // 2 mm in the tissue
        at = simulation::TissueSurface(p->tissue.shape).pointAt({0.0, 0.0}) - core::Vec3(0.0, 0.0, 0.002);
    for (const bool felt : {true, false}) {
        setup.devices.front().rendersForce = felt;
        const auto scene = (*kind)->makeScene(setup);
        simulation::SceneInput in;
        in.started = in.forceReady = true;
        in.tools.count = (*kind)->toolCount(setup.level);
        for (core::ToolState& tool : in.tools.tools)
            tool.p_WT = at;
        simulation::SceneOutput out;
        realtime::TickSource ticks;
        for (int n = 0; n < 3; ++n)
            scene->respond(ticks.next(0), in, out);
        const simulation::PalpationCues& cues = out.cues.exercise.of<simulation::PalpationCues>();
        const bool bars = exercise == "palpation"
                              ? cues.bandShown
                              : out.cues.exercise.of<core::LaparoscopyCues>().squeezeShown;
        QCOMPARE(bars, !felt);
        QCOMPARE(cues.lumps, 0); // hidden either way
        if (exercise == "palpation")
            QCOMPARE(cues.depth_m[0] > 0.0,
                     !felt && out.quantities[simulation::palpation_quantity::kDepth] > 0.0);
        if (exercise == "palpation")
            QVERIFY(out.quantities[simulation::palpation_quantity::kDepth] > 0.0);
    }
}

// Without a window: its limits are the exercise's, and nobody's heartbeat is waited for.
void TestSessionSetup::safetyFollowsTheExercise() {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    int knees = 0;
    for (const catalogue::Exercise& exercise : catalogue->exercises()) {
        const auto kind = session::exerciseKind(exercise.id);
        for (const catalogue::ExerciseLevel& level : exercise.levels) {
            const haptics::SafetySettings safety = session::headlessSafety(level);
            QCOMPARE(safety.exerciseForce_N, (*kind)->forceLimit_N(level));
            QCOMPARE(safety.exerciseTorque_Nm, (*kind)->caps(level).torque_Nm);
            QCOMPARE(safety.capKnee, (*kind)->caps(level).knee);
            QVERIFY(!safety.heartbeatWatched);
            knees += safety.capKnee != haptics::SafetySettings().capKnee ? 1 : 0;
        }
    }
    QVERIFY(knees > 0); // else there would be nothing to follow
    catalogue::ExerciseLevel strong = *catalogue->find("urethra_insertion", 1);
    strong.parameters.as<simulation::UrethraInsertionParameters>().maximumTorque_Nm = 0.123;
    QCOMPARE(session::headlessSafety(strong).exerciseTorque_Nm, 0.123);
}

// To the last bit, of every metric and every trial; only the sign of nothing is none.
void TestSessionSetup::anyDifferenceOfScoresIsFound() {
    scoring::ScoreCard card;
    card.passed = true;
    card.metrics = {
        {"time", 1, "s", 12.5, "", true}, {"drops", 2, "count", 0.0, "", {}}, {"sparc", 1, "1", {}, "", {}}};
    card.trials = {card.metrics, card.metrics};
    QVERIFY(session::sameScores(card, card));
    const auto differs = [&card](auto change) {
        scoring::ScoreCard other = card;
        change(other);
        return !session::sameScores(card, other) && !session::sameScores(other, card);
    };
    QVERIFY(differs([](auto& other) { other.passed = false; }));
    QVERIFY(differs([](auto& other) { other.trials.pop_back(); }));
    QVERIFY(differs([](auto& other) { other.metrics.pop_back(); }));
    QVERIFY(differs([](auto& other) { other.trials[1].pop_back(); }));
    for (const int where : {-1, 0, 1})
        for (std::size_t i = 0; i < card.metrics.size(); ++i) {
            const auto ofOne = [&](auto change) {
                return differs([&](auto& other) {
                    change(where < 0 ? other.metrics[i] : other.trials[static_cast<std::size_t>(where)][i]);
                });
            };
            QVERIFY(ofOne([](auto& metric) { metric.id += "_"; }));
            QVERIFY(ofOne([](auto& metric) { ++metric.version; }));
            QVERIFY(ofOne([](auto& metric) { metric.unit += "_"; }));
            QVERIFY(ofOne([](auto& metric) { metric.passed = !metric.passed.value_or(true); }));
            QVERIFY(ofOne([](auto& metric) {
                metric.value = metric.value ? std::nextafter(*metric.value, 100.0) : 0.0;
            }));
        }
    scoring::ScoreCard other = card;
    other.metrics[1].value = -0.0;
    QVERIFY(session::sameScores(card, other));
}

QTEST_APPLESS_MAIN(TestSessionSetup)
#include "test_session_setup.moc"
