// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace chiron;
using simulation::Endoscope;
using simulation::UrethraAnatomy;
using simulation::UrethraCentreline;
using simulation::UrethraLocalChange;
using simulation::UrethraWall;

namespace {

UrethraAnatomy withStricture() {
    UrethraAnatomy anatomy;
    anatomy.changes[0] = {0.080, 0.012, 0.004, 0.0015, 15.0, 2.0};
    anatomy.changes[1] = {0.110, 0.010, 0.010, 0.0045, 0.5, 0.5};
    anatomy.changeCount = 2;
    return anatomy;
}

bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

} // namespace

class TestUrethraWall : public QObject {
    Q_OBJECT
private slots:
    void localChangesHaveTheirShape();
    void awayFromChangesTheBaseValuesExactly();
    void constrainedRisesOverTheBlend();
    void openingIsTheRaisedCosine();
    void slopesAreThoseOfTheWindows();
    void openedRadius();
    void thinEndoscopeOpensNothing();
};

void TestUrethraWall::localChangesHaveTheirShape() {
    const UrethraWall wall(withStricture(), Endoscope{});
    QCOMPARE(wall.radius_m(0.080), 0.0015);
    QCOMPARE(wall.stiffness_N_per_m3(0.080), 45.0e6);
    QCOMPARE(wall.friction(0.080), 0.2);
    QVERIFY(near(wall.radius_m(0.110), 0.0045, 1e-17));
    for (const double side : {-1.0, 1.0}) { // half-height, foot and shoulder of the edge
        QVERIFY(near(wall.radius_m(0.080 + side * 0.006), 0.0020, 1e-15));
        QVERIFY(near(wall.stiffness_N_per_m3(0.080 + side * 0.006), 3.0e6 * 8.0, 1e-3));
        QVERIFY(near(wall.radius_m(0.080 + side * 0.00801), 0.0025, 1e-18));
        QVERIFY(near(wall.radius_m(0.080 + side * 0.00399), 0.0015, 1e-18));
        QVERIFY(near(wall.radius_m(0.080 + side * 0.007), 0.0025 - 0.001 * 0.15625, 1e-15)); // S(¼)
    }
    for (double s = 0.05; s < 0.13; s += 1e-5) // no jumps: at most the smoothstep's slope, 1.5 rise/edge
        QVERIFY(std::abs(wall.radius_m(s + 1e-5) - wall.radius_m(s)) < 1.5 * 0.001 / 0.004 * 1.01e-5);
}

void TestUrethraWall::awayFromChangesTheBaseValuesExactly() {
    const UrethraWall wall(withStricture(), Endoscope{});
    for (const double s : {-0.01, 0.0, 0.02, 0.0719, 0.0881, 0.0999, 0.1201, 0.2}) {
        QCOMPARE(wall.radius_m(s), 0.0025);
        QCOMPARE(wall.stiffness_N_per_m3(s), 3.0e6);
        QCOMPARE(wall.friction(s), 0.1);
    }
}

void TestUrethraWall::constrainedRisesOverTheBlend() {
    const UrethraWall wall(UrethraAnatomy{}, Endoscope{});
    QCOMPARE(wall.constrained(0.030), 0.0);
    QVERIFY(near(wall.constrained(0.040), 0.5, 1e-15));
    QVERIFY(near(wall.constrained(0.035), 0.15625, 1e-14));
    QCOMPARE(wall.constrained(0.0501), 1.0);
    QCOMPARE(wall.constrained(-1.0), 0.0);
}

void TestUrethraWall::openingIsTheRaisedCosine() {
    const UrethraWall wall(UrethraAnatomy{}, Endoscope{});
    const double tip = 0.0612;
    QCOMPARE(wall.opening(tip, tip), 1.0);
    QCOMPARE(wall.opening(tip - 0.05, tip), 1.0);
    QVERIFY(near(wall.opening(tip + 0.005, tip), 0.5, 1e-15));
    QVERIFY(near(wall.opening(tip + 0.0025, tip), 0.5 + std::sqrt(0.125), 1e-14));
    QVERIFY(near(wall.following(tip - 0.010, tip), 0.5 + std::sqrt(0.125), 1e-14));
    QVERIFY(near(wall.following(tip + 0.0025, tip), 0.5 + std::sqrt(0.125), 1e-14));
    QCOMPARE(wall.following(tip - 0.040, tip), 0.0);
    QCOMPARE(wall.following(tip - 0.1, tip), 0.0);
    core::Random random(1);
    for (int i = 0; i < 100000; ++i) { // exactly nothing from the very end on, whatever the rounding
        const double t = random.uniform(-0.02, 0.2);
        const double end = t + 0.010;
        QCOMPARE(wall.opening(end, t), 0.0);
        QCOMPARE(wall.following(end, t), 0.0);
        QCOMPARE(wall.openedRadius_m(end, t), 0.0025);
        QVERIFY(wall.opening(std::nextafter(end, -1.0), t) < 1e-12);
    }
}

void TestUrethraWall::slopesAreThoseOfTheWindows() {
    const UrethraWall wall(UrethraAnatomy{}, Endoscope{});
    const double h = 1e-7;
    for (double s = 0.0; s < 0.12; s += 0.00037) {
        const double tip = 0.0601;
        const double opening = (wall.opening(s, tip + h) - wall.opening(s, tip - h)) / (2 * h);
        const double following = (wall.following(s, tip + h) - wall.following(s, tip - h)) / (2 * h);
        QVERIFY(near(wall.openingSlope(s, tip), opening, 6e-3)); // of 157 per metre at most
        QVERIFY(near(wall.followingSlope(s, tip), following, 6e-3));
    }
    QVERIFY(near(wall.openingSlope(0.065, 0.060), 0.5 * 3.14159265358979 / 0.010, 1e-9));
    QVERIFY(near(wall.followingSlope(0.040, 0.060), -0.5 * 3.14159265358979 / 0.040, 1e-9));
    QCOMPARE(wall.openingSlope(0.050, 0.060), 0.0);
    QCOMPARE(wall.openingSlope(0.0701, 0.060), 0.0);
}

void TestUrethraWall::openedRadius() {
    const Endoscope scope;
    const UrethraWall wall(withStricture(), scope);
    const double tip = 0.076; // ahead lies the stricture's rest
    for (double s = -0.01; s <= tip; s += 0.001)
        QCOMPARE(wall.openedRadius_m(s, tip), scope.radius_m);
    for (double s = tip; s < tip + 0.012; s += 0.0001) {
        const double expected = wall.radius_m(s) + (scope.radius_m - wall.radius_m(s)) * wall.opening(s, tip);
        QVERIFY(near(wall.openedRadius_m(s, tip), std::max(wall.radius_m(s), expected), 1e-18));
    }
    for (double s = tip + scope.beak_m; s < 0.14; s += 0.0007) // where the canal is wide, too
        QCOMPARE(wall.openedRadius_m(s, tip), wall.radius_m(s));
    QCOMPARE(wall.openedRadius_m(0.110, 0.130), wall.radius_m(0.110)); // wider than the endoscope: as it is
}

void TestUrethraWall::thinEndoscopeOpensNothing() {
    Endoscope thin;
    thin.radius_m = 0.001;
    const UrethraWall wall(withStricture(), thin);
    for (double s = 0.0; s < 0.14; s += 0.0003)
        QCOMPARE(wall.openedRadius_m(s, 0.09), wall.radius_m(s));
}

QTEST_APPLESS_MAIN(TestUrethraWall)
#include "test_urethra_wall.moc"
