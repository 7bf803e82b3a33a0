// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/spherical_joint.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "modules/exercises/urethra_insertion/operators/endoscope_reach.h"
#include "modules/exercises/urethra_insertion/operators/endoscope_senses.h"
#include "modules/exercises/urethra_insertion/operators/way_memory.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::operators;
using core::Vec3;

/// What endoscopists feel and see, what they remember, and how their hand moves.
class TestUrethraPerception : public QObject {
    Q_OBJECT
private slots:
    void withoutNoiseItIsWhatIs();
    void noisesHaveTheirSize();
    void hiddenIsNotSeen();
    void handGoesWhereTheEyeLooks();
    void wayIsRemembered();
};

namespace {

mechanisms::HandPerception still(double pitch, double yaw) {
    mechanisms::HandPerception real;
    real.q_DT = mechanisms::SphericalJoint({pitch, yaw, 0.0}).orientation_DT();
    real.cues.exercise.own<simulation::EndoscopeCues>().pictureShown = true;
    real.cues.exercise.own<simulation::EndoscopeCues>().guided = true;
    real.cues.exercise.own<simulation::EndoscopeCues>().depth_m = 0.05;
    real.cues.exercise.own<simulation::EndoscopeCues>().toLumen_T = {-0.1, 0.2,
                                                                     -std::sqrt(1.0 - 0.05)}; // left and up
    real.cues.exercise.own<simulation::EndoscopeCues>().lumenDistance_m = 0.03;
    return real;
}

EndoscopePerceptionSettings quiet() {
    EndoscopePerceptionSettings s;
    s.angleBiasSd_rad = s.angleNoiseSd_rad = s.pictureNoiseSd_rad = s.distanceWeberFraction =
        s.depthNoiseSd_m = 0.0;
    s.forceWeberFraction = s.forceFloorSd_N = s.torqueWeberFraction = s.torqueFloorSd_Nm = 0.0;
    s.directionNoiseSd_rad = s.directionBiasSd_rad = 0.0;
    return s;
}

const EndoscopePercept& nextLook(EndoscopeSenses& senses, const mechanisms::HandPerception& real) {
    while (!senses.feel(real))
        ;
    return senses.percept();
}

} // namespace

void TestUrethraPerception::withoutNoiseItIsWhatIs() {
    EndoscopeSenses senses(quiet(), 1);
    auto real = still(0.4, 0.1);
    const mechanisms::SphericalJoint joint({0.4, 0.1, 0.0});
    real.f_T_D = -1.5 * joint.view_D() + 0.7 * joint.yawAxis_D();
    real.t_T_D = 0.02 * Vec3::UnitX();
    const EndoscopePercept& felt = nextLook(senses, real);
    QVERIFY(std::abs(felt.pitch_rad - 0.4) < 1e-12 && std::abs(felt.yaw_rad - 0.1) < 1e-12);
    QVERIFY(std::abs(felt.along_N + 1.5) < 1e-12 && std::abs(felt.across_N - 0.7) < 1e-12);
    QVERIFY(std::abs(felt.pitchTorque_Nm - 0.02) < 1e-12);
    QVERIFY(felt.lumen.seen && std::abs(felt.lumen.distance_m - 0.03) < 1e-12 && felt.depth_m == 0.05);
    QVERIFY(felt.lumen.up_rad > 0.19 && felt.lumen.up_rad < 0.21 && felt.lumen.left_rad > 0.09 &&
            felt.lumen.left_rad < 0.11);
}

void TestUrethraPerception::noisesHaveTheirSize() {
    const EndoscopePerceptionSettings s;
    double pitch2 = 0.0, marked2 = 0.0, unmarked2 = 0.0, along = 0.0;
    const int seeds = 2000; // the stationary state begins at once: one look a seed is one draw
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto real = still(0.3, 0.0);
        real.f_T_D = -2.0 * mechanisms::SphericalJoint({0.3, 0.0, 0.0}).view_D();
        EndoscopeSenses senses(s, seed);
        const EndoscopePercept felt = nextLook(senses, real);
        real.cues.exercise.own<simulation::EndoscopeCues>().guided = false;
        EndoscopeSenses unguided(s, seed);
        const double truth = std::atan2(0.2, std::sqrt(1.0 - 0.05));
        pitch2 += std::pow(felt.pitch_rad - 0.3, 2);
        marked2 += std::pow(felt.lumen.up_rad - truth, 2);
        unmarked2 += std::pow(nextLook(unguided, real).lumen.up_rad - truth, 2);
        along += felt.along_N / seeds;
    }
    QVERIFY(std::abs(std::sqrt(pitch2 / seeds) / std::hypot(s.angleBiasSd_rad, s.angleNoiseSd_rad) - 1.0) <
            0.05);
    QVERIFY(std::abs(std::sqrt(marked2 / seeds) / s.pictureNoiseSd_rad - 1.0) < 0.05);
    QVERIFY(std::abs(std::sqrt(unmarked2 / marked2) - s.unmarkedFactor) < 1e-9);
    QVERIFY(along < -1.8 && along > -2.0); // what points elsewhere is missing along
}

void TestUrethraPerception::hiddenIsNotSeen() {
    EndoscopeSenses senses({}, 1);
    auto real = still(0.0, 0.0);
    real.cues.exercise.own<simulation::EndoscopeCues>().landmarkShown = true;
    real.cues.exercise.own<simulation::EndoscopeCues>().toLandmark_T = {0.0, 0.01, -0.05};
    QVERIFY(nextLook(senses, real).landmark.seen);
    real.cues.exercise.own<simulation::EndoscopeCues>().toLumen_T = {}; // wall alone
    QVERIFY(!nextLook(senses, real).lumen.seen);
    real.cues.exercise.own<simulation::EndoscopeCues>().toLumen_T = {0.0, 0.0, -1.0};
    real.cues.exercise.own<simulation::EndoscopeCues>().pictureShown = false;
    const EndoscopePercept& dark = nextLook(senses, real);
    QVERIFY(!dark.lumen.seen && !dark.landmark.seen);
}

void TestUrethraPerception::handGoesWhereTheEyeLooks() {
    const mechanisms::SphericalJoint joint({0.6, 0.0, 0.0});
    EndoscopeReach reach;
    reach.start(Vec3(0.0, 0.01, 0.02), joint.orientation_DT());
    reach.wish({0.010, 0.0, 0.1, 0.0}, 0.6);
    mechanisms::HandIntention wanted;
    for (int tick = 0; tick < 1000; ++tick)
        wanted = reach.advance();
    const Vec3 moved = reach.place_D() - Vec3(0.0, 0.01, 0.02);
    QVERIFY((moved.normalized() - joint.view_D()).norm() < 1e-9 && std::abs(moved.norm() - 0.010) < 0.001);
    QVERIFY(std::abs(reach.pitch_rad() - 0.7) < 0.01);
    reach.wish({0.0, 0.0, 5.0, -5.0}, 0.6);
    for (int tick = 0; tick < 2000; ++tick)
        wanted = reach.advance();
    QVERIFY(reach.pitch_rad() == EndoscopeReach::kHighestPitch_rad &&
            reach.yaw_rad() == -EndoscopeReach::kWidestYaw_rad);
    QVERIFY(wanted.p_DDesired.allFinite() && std::abs(wanted.q_DDesired.norm() - 1.0) < 1e-12);
}

void TestUrethraPerception::wayIsRemembered() {
    WayMemory way;
    QVERIFY(!way.at(0.05).kept);
    for (int mm = -10; mm <= 150; ++mm)
        for (int look = 0; look < 5; ++look)
            way.keep(0.001 * mm, 0.008 * mm, 0.009 * mm);
    for (int mm = 0; mm <= 140; mm += 7) {
        QVERIFY(way.at(0.001 * mm).kept);
        QVERIFY(std::abs(way.at(0.001 * mm).pitch_rad - 0.008 * mm) < 0.008 * 4);
        QVERIFY(std::abs(way.at(0.001 * mm).lumen_rad - 0.009 * mm) < 0.009 * 4);
    }
    QVERIFY(way.at(-1.0).pitch_rad <= way.at(0.0).pitch_rad && way.at(1.0).kept == way.at(0.9).kept);
}

QTEST_APPLESS_MAIN(TestUrethraPerception)
#include "test_urethra_perception.moc"
