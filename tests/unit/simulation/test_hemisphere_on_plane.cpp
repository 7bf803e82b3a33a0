// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/geometry/hemisphere_on_plane.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace chiron;
using core::Vec3;
using simulation::HemisphereOnPlane;
using simulation::SurfaceDistance;

namespace {

const HemisphereOnPlane kShape{0.020, 0.003, core::Vec2(0.011, -0.007)};

Vec3 local(double x, double y, double z) {
    return {kShape.centre_m.x() + x, kShape.centre_m.y() + y, kShape.planeHeight_m + z};
}

bool insideUnion(const Vec3& p) {
    const Vec3 c(kShape.centre_m.x(), kShape.centre_m.y(), kShape.planeHeight_m);
    return p.z() < kShape.planeHeight_m || (p - c).norm() < kShape.radius_m;
}

Vec3 randomPoint(core::Random& random, double reach) {
    return local(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach));
}

} // namespace

class TestHemisphereOnPlane : public QObject {
    Q_OBJECT
private slots:
    void agreesWithPointsSampledOnTheBoundary();
    void signTellsInsideFromOutside();
    void nearestPointLiesOnTheSurface();
    void distanceIsOneLipschitz();
    void normalIsTheGradient();
    void closedForms();
    void worksInOddPlaces();
};

// The definition itself: the nearest of many points of the boundary (cap above the plane, plane outside the
// rim).
void TestHemisphereOnPlane::agreesWithPointsSampledOnTheBoundary() {
    core::Random random(1);
    std::vector<Vec3> boundary;
    const double R = kShape.radius_m;
    const double step = 0.0005;
    for (double theta = 0.0; theta <= core::kPi / 2 + 1e-9; theta += core::kPi / 2 / 64)
        for (int i = 0; i < 256; ++i) {
            const double phi = 2.0 * core::kPi * i / 256;
            boundary.push_back(local(R * std::sin(theta) * std::cos(phi), R * std::sin(theta) * std::sin(phi),
                                     R * std::cos(theta)));
        }
    for (double x = -0.05; x <= 0.05; x += step)
        for (double y = -0.05; y <= 0.05; y += step)
            if (std::hypot(x, y) >= R)
                boundary.push_back(local(x, y, 0.0));
    for (int n = 0; n < 300; ++n) {
        const Vec3 p = randomPoint(random, 0.028);
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& q : boundary)
            nearest = std::min(nearest, (q - p).norm());
        const double exact = std::abs(kShape.distance(p).signedDistance_m);
        QVERIFY(exact <= nearest + 1e-12);
        // a point of the boundary is at most 0.36 mm from a sample (half a diagonal of the 0.5 mm grids)
        QVERIFY2(nearest <= exact + 0.00036, qPrintable(QString("%1 %2").arg(exact).arg(nearest)));
    }
}

void TestHemisphereOnPlane::signTellsInsideFromOutside() {
    core::Random random(2);
    for (int n = 0; n < 200000; ++n) {
        const Vec3 p = randomPoint(random, 0.04);
        QCOMPARE(kShape.distance(p).signedDistance_m < 0.0, insideUnion(p));
    }
}

void TestHemisphereOnPlane::nearestPointLiesOnTheSurface() {
    core::Random random(3);
    for (int n = 0; n < 200000; ++n) {
        const Vec3 p = randomPoint(random, 0.04);
        const SurfaceDistance s = kShape.distance(p);
        QVERIFY(std::abs(s.normal.norm() - 1.0) < 1e-12);
        const Vec3 q = p - s.signedDistance_m * s.normal - local(0, 0, 0);
        const bool onCap = std::abs(q.norm() - kShape.radius_m) < 1e-12 && q.z() > -1e-12;
        const bool onPlane = std::abs(q.z()) < 1e-12 && q.head<2>().norm() > kShape.radius_m - 1e-12;
        QVERIFY(onCap || onPlane);
    }
}

void TestHemisphereOnPlane::distanceIsOneLipschitz() {
    core::Random random(4);
    for (int n = 0; n < 300000; ++n) {
        const Vec3 p = randomPoint(random, 0.04);
        const double reach = n % 2 == 0 ? 1e-5 : 0.01;
        const Vec3 q = p + Vec3(random.uniform(-reach, reach), random.uniform(-reach, reach),
                                random.uniform(-reach, reach));
        const double change =
            std::abs(kShape.distance(p).signedDistance_m - kShape.distance(q).signedDistance_m);
        QVERIFY(change <= (p - q).norm() + 1e-15);
    }
}

void TestHemisphereOnPlane::normalIsTheGradient() {
    core::Random random(5);
    const double h = 1e-6;
    int compared = 0;
    for (int n = 0; n < 100000; ++n) {
        const Vec3 p = randomPoint(random, 0.03);
        const SurfaceDistance here = kShape.distance(p);
        if (here.signedDistance_m > 0.0 || here.signedDistance_m < -0.01)
            continue; // outside, gradient jumps on the bisector of ball and plane; far below, on the axis
        Vec3 gradient;
        for (int axis = 0; axis < 3; ++axis)
            gradient[axis] = (kShape.distance(p + h * Vec3::Unit(axis)).signedDistance_m -
                              kShape.distance(p - h * Vec3::Unit(axis)).signedDistance_m) /
                             (2 * h);
        // the rim circle is the one place with curvature 1/d: leave out the last 0.1 mm round it
        const Vec3 q = p - local(0, 0, 0);
        if (std::hypot(q.head<2>().norm() - kShape.radius_m, q.z()) < 1e-4 || here.signedDistance_m > -2 * h)
            continue;
        QVERIFY((gradient - here.normal).norm() < 1e-3);
        ++compared;
    }
    QVERIFY(compared > 10000);
}

void TestHemisphereOnPlane::closedForms() {
    const auto expect = [](const Vec3& p, double distance, const Vec3& normal) {
        const SurfaceDistance s = kShape.distance(p);
        return std::abs(s.signedDistance_m - distance) < 1e-15 && (s.normal - normal).norm() < 1e-12;
    };
    QVERIFY(expect(local(0, 0, 0.019), -0.001, Vec3::UnitZ()));        // under the apex
    QVERIFY(expect(local(0, 0, 0.025), 0.005, Vec3::UnitZ()));         // over it
    QVERIFY(expect(local(0.04, 0.01, -0.002), -0.002, Vec3::UnitZ())); // under the plane
    QVERIFY(expect(local(0.04, 0.01, 0.002), 0.002, Vec3::UnitZ()));
    QVERIFY(expect(local(-0.019, 0, 0), -0.001, -Vec3::UnitX())); // at the rim's height
    QVERIFY(expect(local(0, 0.012, 0.012), 0.012 * std::sqrt(2.0) - 0.020,
                   Vec3(0, std::sqrt(0.5), std::sqrt(0.5))));
    // 3-4-5 triangle under the rim: 3 mm inwards, 4 mm down; the rim circle is nearest
    QVERIFY(expect(local(0.017, 0, -0.004), -0.005, Vec3(0.6, 0, 0.8)));
}

void TestHemisphereOnPlane::worksInOddPlaces() {
    const SurfaceDistance centre = kShape.distance(local(0, 0, 0));
    QCOMPARE(centre.signedDistance_m, -0.020);
    QVERIFY(std::abs(centre.normal.norm() - 1.0) < 1e-15);
    const SurfaceDistance axis = kShape.distance(local(0, 0, -0.015));
    QVERIFY(std::abs(axis.signedDistance_m + 0.025) < 1e-15);
    QVERIFY(std::abs(axis.normal.norm() - 1.0) < 1e-15);
    const SurfaceDistance rim = kShape.distance(local(0.020, 0, 0));
    QVERIFY(std::abs(rim.signedDistance_m) < 1e-15 && rim.normal.allFinite());
    for (const double far : {10.0, 1e6, 1e100}) {
        for (const Vec3& p : {Vec3(far, 0, 0), Vec3(0, -far, far), Vec3(far, far, -far), Vec3(0, 0, -far)}) {
            const SurfaceDistance s = kShape.distance(p);
            QVERIFY(std::isfinite(s.signedDistance_m));
            QVERIFY(std::abs(s.normal.norm() - 1.0) < 1e-12);
        }
    }
    // within rounding of the rim circle, from every side
    for (int i = 0; i < 1000; ++i) {
        const double angle = 2.0 * core::kPi * i / 1000;
        const Vec3 p = local(0.020 * std::cos(angle), 0.020 * std::sin(angle),
                             i % 3 == 0 ? -1e-200 : (i % 3 == 1 ? 0.0 : -1e-18));
        const SurfaceDistance s = kShape.distance(p);
        QVERIFY(std::abs(s.signedDistance_m) < 1e-15);
        QVERIFY(std::abs(s.normal.norm() - 1.0) < 1e-9);
    }
}

QTEST_APPLESS_MAIN(TestHemisphereOnPlane)
#include "test_hemisphere_on_plane.moc"
