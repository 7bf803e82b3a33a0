// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/elastic_tube/operators/elastic_tube_operator.h"
#include "modules/exercises/elastic_tube/operators/tension_control.h"
#include "modules/exercises/object_handling/operators/object_handling_operator.h"
#include "modules/exercises/object_handling/operators/weight_memory.h"
#include "operators/laparoscopy/scripted_hand.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

using namespace chiron;
using namespace chiron::operators;
using core::Vec3;

/// What laparoscopists feel and see, how their hands move, how they keep a tension and remember a weight.
class TestLaparoscopyPerception : public QObject {
    Q_OBJECT
private slots:
    void withoutNoiseItIsWhatIs();
    void noisesHaveTheirSize();
    void hiddenIsNotSeen();
    void handStaysWithinItsReach();
    void oneMindHearsAllItsHands();
    void stiffnessIsNoticed();
    void tensionSettlesInTheBand();
    void unshownBandIsFound();
    void weightsAreCompared();
    void namesAndSettings();
    void allFeelAlike();
};

namespace {

GraspPerceptionSettings quiet() {
    GraspPerceptionSettings s;
    s.hand.positionBiasSd_m = s.hand.positionNoiseSd_m = s.hand.visionNoiseSd_m = 0.0;
    s.hand.forceWeberFraction = s.hand.forceFloorSd_N = s.hand.directionNoiseSd_rad =
        s.hand.directionBiasSd_rad = 0.0;
    s.gaugeWeberFraction = s.gaugeFloorSd_N = s.lengthWeberFraction = 0.0;
    return s;
}

mechanisms::HandPerception pulling() {
    mechanisms::HandPerception real;
    real.p_DT = {0.01, 0.02, 0.03};
    real.f_T_D = {0.3, -0.2, -0.9};
    core::LaparoscopyCues& screen = real.cues.exercise.own<core::LaparoscopyCues>();
    screen.present = screen.objectShown = screen.tube = true;
    screen.restLength_m = 0.045;
    screen.stretch_m = 0.015;
    screen.tensionShown = screen.squeezeShown = true;
    screen.tension_N = 1.2;
    screen.squeeze_N = {0.4, 0.7, 0.0, 0.0};
    screen.bodies = 1;
    screen.body[0].radius_m = 0.011;
    screen.body[0].heldBy = 2;
    screen.body[0].squeeze_m = 0.002;
    return real;
}

const GraspPercept& nextLook(GraspSenses& senses, const mechanisms::HandPerception& real) {
    while (!senses.feel(real))
        ;
    return senses.percept();
}

/// A hand that pulls at a spring, 180 ms late, and what its mind makes of it; the tension of the last second.
std::vector<double> pullAtASpring(const ElasticTubeOperatorSettings& settings, double k, bool shown,
                                  double target, double band) {
    TensionControl control(settings);
    control.begin();
    std::deque<double> line(18, 0.0); // looks
    double length = 0.045, dwell = 0.0, speed = 0.0;
    std::vector<double> last;
    for (int look = 0; look < 3000; ++look) {
        const double tension = k * std::max(0.0, length - 0.045);
        dwell = std::abs(tension - target) <= band ? std::min(0.99, dwell + 0.0005) : 0.0;
        const TensionView view{
            tension, length,     0.045, shown ? target - band : 0.0, shown ? target + band : 0.0,
            dwell,   0.01 * look};
        control.look(view);
        speed = control.speed_m_per_s(view);
        line.push_back(speed);
        length += 0.01 * line.front();
        line.pop_front();
        if (look >= 2900)
            last.push_back(tension);
    }
    return last;
}

} // namespace

void TestLaparoscopyPerception::withoutNoiseItIsWhatIs() {
    const devices::WorkspaceMapping place{{-0.06, 0.0, 0.0}, 1.0, false};
    GraspSenses senses(quiet(), 1, place, 1);
    const GraspPercept& felt = nextLook(senses, pulling());
    QVERIFY((felt.place - Vec3(-0.05, 0.02, 0.03)).norm() < 1e-12);
    QVERIFY((felt.force - Vec3(0.3, -0.2, -0.9)).norm() < 1e-12);
    QVERIFY(std::abs(felt.tension_N - 1.2) < 1e-12 && std::abs(felt.squeeze_N - 0.7) < 1e-12);
    QVERIFY(std::abs(felt.stretch_m - 0.015) < 1e-12 && std::abs(felt.flattening_m - 0.002) < 1e-12);
}

void TestLaparoscopyPerception::noisesHaveTheirSize() {
    const GraspPerceptionSettings s;
    const int seeds = 2000; // stationary from the first look: one draw a seed
    double place2 = 0.0, tension2 = 0.0, length2 = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        GraspSenses senses(s, 0, {}, seed);
        const GraspPercept felt = nextLook(senses, pulling());
        place2 += (felt.place - Vec3(0.01, 0.02, 0.03)).squaredNorm() / 3.0;
        tension2 += std::pow(felt.tension_N - 1.2, 2);
        length2 += std::pow(felt.stretch_m - 0.015, 2);
    }
    QVERIFY(std::abs(std::sqrt(place2 / seeds) / s.hand.visionNoiseSd_m - 1.0) < 0.05);
    QVERIFY(std::abs(std::sqrt(tension2 / seeds) / std::hypot(1.2 * s.gaugeWeberFraction, s.gaugeFloorSd_N) -
                     1.0) < 0.05);
    QVERIFY(std::abs(std::sqrt(length2 / seeds) / (0.060 * s.lengthWeberFraction) - 1.0) < 0.05);
}

// Without the picture the hand is placed by feel alone, four times worse; bars that are off read nothing.
void TestLaparoscopyPerception::hiddenIsNotSeen() {
    const GraspPerceptionSettings s;
    auto real = pulling();
    real.cues.exercise.own<core::LaparoscopyCues>().objectShown = false;
    real.cues.exercise.own<core::LaparoscopyCues>().tensionShown =
        real.cues.exercise.own<core::LaparoscopyCues>().squeezeShown = false;
    double place2 = 0.0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        GraspSenses senses(s, 0, {}, seed);
        const GraspPercept felt = nextLook(senses, real);
        place2 += (felt.place - Vec3(0.01, 0.02, 0.03)).squaredNorm() / 3.0;
        QVERIFY(felt.tension_N == 0.0 && felt.squeeze_N == 0.0);
    }
    const double expected = std::hypot(s.hand.positionBiasSd_m, s.hand.positionNoiseSd_m);
    QVERIFY(std::abs(std::sqrt(place2 / 1000) / expected - 1.0) < 0.05);
}

void TestLaparoscopyPerception::handStaysWithinItsReach() {
    GraspReach reach({0.5, 0.1});
    reach.start(Vec3(0.0, 0.0, 0.05));
    reach.wish({Vec3(0.5, 0.0, 0.5), 1.0, 2.0});
    mechanisms::HandIntention before = reach.advance();
    for (int tick = 0; tick < 3000; ++tick) {
        const mechanisms::HandIntention now = reach.advance();
        QVERIFY((now.v_DDesired - before.v_DDesired).norm() <= 0.5e-3 + 1e-12 ||
                now.p_DDesired.x() == GraspReach::kAcross_m || now.p_DDesired.z() == GraspReach::kHighest_m);
        QVERIFY(std::abs(now.jaw_rad - before.jaw_rad) <= 2.0e-3 + 1e-12);
        before = now;
    }
    QVERIFY(reach.place().x() == GraspReach::kAcross_m && reach.place().z() == GraspReach::kHighest_m &&
            reach.jaw_rad() == 1.0);
    reach.wish({Vec3::Zero(), 5.0, 100.0});
    QVERIFY(reach.advance().jaw_rad <= GraspReach::kWidest_rad);
}

void TestLaparoscopyPerception::oneMindHearsAllItsHands() {
    struct Listener final : LaparoscopyMind {
        int* thoughts;
        explicit Listener(int* count) : thoughts(count) {}
        void think(const GraspLook& felt, GraspWishes& wishes) noexcept override {
            ++*thoughts;
            wishes[0].velocity_m_per_s = felt.hand[1].force; // each hand moves by what the other feels
            wishes[1].velocity_m_per_s = felt.hand[0].force;
        }
    };
    int thoughts = 0;
    const auto hands =
        makeHands(std::make_unique<Listener>(&thoughts), quiet(), {100.0, 0.0},
                  {devices::WorkspaceMapping{{0.06, 0.0, 0.0}, 1.0, false}, devices::WorkspaceMapping{}}, 1);
    QCOMPARE(hands.size(), std::size_t(2));
    mechanisms::HandPerception right, left;
    right.f_T_D = {0.02, 0.0, 0.0};
    left.f_T_D = {0.0, 0.03, 0.0};
    mechanisms::HandIntention wantedRight, wantedLeft;
    for (int tick = 0; tick < 30; ++tick) {
        right.time_s = left.time_s = 1e-3 * (tick + 1);
        wantedRight = hands[0]->decide(right);
        wantedLeft = hands[1]->decide(left);
    }
    QCOMPARE(thoughts, 3);
    QVERIFY((wantedRight.v_DDesired - Vec3(0.0, 0.03, 0.0)).norm() < 1e-9);
    QVERIFY((wantedLeft.v_DDesired - Vec3(0.02, 0.0, 0.0)).norm() < 1e-9);
}

void TestLaparoscopyPerception::stiffnessIsNoticed() {
    StiffnessSense sense(40.0);
    for (int look = 0; look < 200; ++look)
        sense.notice(0.05 + 1e-4 * look, 95.0 * 1e-4 * look);
    QVERIFY(std::abs(sense.stiffness_N_per_m() - 95.0) < 1e-6);
    for (int look = 0; look < 500; ++look) // at rest it remembers
        sense.notice(0.07, 1.9);
    QVERIFY(sense.stiffness_N_per_m() > 80.0);
    sense.begin();
    QVERIFY(sense.stiffness_N_per_m() == 40.0);
}

void TestLaparoscopyPerception::tensionSettlesInTheBand() {
    for (const char* name : {"expert", "intermediate"})
        for (const double k : {40.0, 80.0})
            for (const double tension : pullAtASpring(*elasticTubeOperatorSettings(name), k, true, 1.2, 0.15))
                QVERIFY2(std::abs(tension - 1.2) <= 0.15,
                         qPrintable(QString("%1 k %2: %3").arg(name).arg(k).arg(tension)));
}

// Nobody says how much: it is found by what the screen counts, and then kept by feel.
void TestLaparoscopyPerception::unshownBandIsFound() {
    for (const double tension : pullAtASpring(*elasticTubeOperatorSettings("expert"), 80.0, false, 1.1, 0.15))
        QVERIFY2(std::abs(tension - 1.1) <= 0.15, qPrintable(QString::number(tension)));
}

void TestLaparoscopyPerception::weightsAreCompared() {
    WeightMemory memory;
    memory.begin(3);
    QCOMPARE(memory.next(1), std::size_t(0));
    const std::array<double, 3> weights{0.20, 0.31, 0.29};
    for (std::size_t i = 0; i < 3; ++i) {
        memory.feel(i, weights[i] - 0.05);
        memory.feel(i, weights[i] + 0.05);
        memory.weighed(i);
    }
    QCOMPARE(memory.next(1), std::size_t(3));
    QCOMPARE(memory.heaviest(), std::size_t(1));
    QCOMPARE(memory.second(), std::size_t(2));
    QVERIFY(memory.close(0.1) && !memory.close(0.05));
}

void TestLaparoscopyPerception::namesAndSettings() {
    QCOMPARE(elasticTubeOperatorNames().size(), std::size_t(4));
    QCOMPARE(objectHandlingOperatorNames().size(), std::size_t(4));
    ElasticTubeBriefing two;
    two.places.resize(2);
    for (const auto name : elasticTubeOperatorNames()) {
        const auto settings = elasticTubeOperatorSettings(name);
        QVERIFY(settings && settings->name == name);
        const auto hands = makeElasticTubeOperator(*settings, two, 1);
        QVERIFY(hands && hands->size() == 2);
        const auto handling = objectHandlingOperatorSettings(name);
        QVERIFY(handling && handling->name == name);
        QVERIFY(makeObjectHandlingOperator(*handling, {}, 1)->size() == 1);
    }
    QVERIFY(elasticTubeOperatorSettings("wizard").error().code == core::ErrorCode::notFound);
    QVERIFY(objectHandlingOperatorSettings("wizard").error().code == core::ErrorCode::notFound);
    auto bad = *elasticTubeOperatorSettings("expert");
    bad.pullSpeed_m_per_s = std::nan("");
    QVERIFY(makeElasticTubeOperator(bad, {}, 1).error().message.find("pullSpeed_m_per_s") !=
            std::string::npos);
    two.places.resize(3);
    QVERIFY(!makeElasticTubeOperator(*elasticTubeOperatorSettings("expert"), two, 1));
    auto crude = *objectHandlingOperatorSettings("expert");
    crude.squeezeShare = -1.0;
    QVERIFY(makeObjectHandlingOperator(crude, {}, 1).error().message.find("squeezeShare") !=
            std::string::npos);
}

// They differ in what they do, not in how well they feel and see; and all feel as the sphere-apex trainees
// do.
void TestLaparoscopyPerception::allFeelAlike() {
    const auto same = [](const GraspPerceptionSettings& a) {
        const GraspPerceptionSettings b;
        return a.hand.positionBiasSd_m == b.hand.positionBiasSd_m &&
               a.hand.visionNoiseSd_m == b.hand.visionNoiseSd_m &&
               a.hand.forceWeberFraction == b.hand.forceWeberFraction &&
               a.hand.forceFloorSd_N == b.hand.forceFloorSd_N &&
               a.hand.directionNoiseSd_rad == b.hand.directionNoiseSd_rad &&
               a.gaugeWeberFraction == b.gaugeWeberFraction && a.gaugeFloorSd_N == b.gaugeFloorSd_N &&
               a.lengthWeberFraction == b.lengthWeberFraction;
    };
    for (const auto name : elasticTubeOperatorNames())
        QVERIFY(same(elasticTubeOperatorSettings(name)->perception) &&
                same(objectHandlingOperatorSettings(name)->perception));
}

QTEST_APPLESS_MAIN(TestLaparoscopyPerception)
#include "test_laparoscopy_perception.moc"
