// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "simulation/geometry/urethra/urethra_anatomy.h"
#include "simulation/geometry/urethra/urethra_centreline.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using core::Vec3;
using simulation::CentrelineFoot;
using simulation::CentrelinePoint;
using simulation::UrethraCentreline;

namespace {

constexpr double kC = 13.0;
constexpr double kEnd = 0.0877;
const UrethraCentreline kLine(kC, kEnd);

double speedAt(double c, double z) {
    return std::sqrt(1.0 + 4.0 * c * c * z * z);
}

/// ∫√(1+4c²z²) dz by Simpson's rule.
double quadrature(double c, double zEnd) {
    const int steps = 20000;
    const double h = zEnd / steps;
    double sum = speedAt(c, 0.0) + speedAt(c, zEnd);
    for (int i = 1; i < steps; ++i)
        sum += (i % 2 == 1 ? 4.0 : 2.0) * speedAt(c, h * i);
    return sum * h / 3.0;
}

/// Nearest point of y = cz², z ≥ 0, by search: a fine grid, then golden section about its best.
double nearestZ(double c, const Vec3& p) {
    const auto distance2 = [&](double z) {
        const double dy = c * z * z - p.y();
        const double dz = z - p.z();
        return dy * dy + dz * dz;
    };
    const double reach = 0.4;
    const int steps = 40000;
    double best = 0.0;
    for (int i = 0; i <= steps; ++i)
        if (distance2(reach * i / steps) < distance2(best))
            best = reach * i / steps;
    double low = std::max(0.0, best - reach / steps);
    double high = best + reach / steps;
    for (int i = 0; i < 100; ++i) {
        const double a = low + (high - low) * 0.381966;
        const double b = low + (high - low) * 0.618034;
        (distance2(a) < distance2(b) ? high : low) = distance2(a) < distance2(b) ? b : a;
    }
    return 0.5 * (low + high);
}

Vec3 differences(const UrethraCentreline& line, const Vec3& p, double h = 2e-7) {
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 step = Vec3::Zero();
        step[axis] = h;
        gradient[axis] = (line.foot(p + step).at.s_m - line.foot(p - step).at.s_m) / (2.0 * h);
    }
    return gradient;
}

} // namespace

class TestUrethraCentreline : public QObject {
    Q_OBJECT
private slots:
    void arcLengthIsTheIntegral();
    void arcLengthAndItsInverseAgree();
    void framesAreRightHandedAndTangent();
    void footIsTheNearestPoint();
    void footOfAShiftedPointIsThePoint();
    void footBeforeTheEntrance();
    void gradientIsThatOfTheArcLength();
    void continuousAcrossTheEntrance();
    void farFromTheLineIsFiniteAndBounded();
};

void TestUrethraCentreline::arcLengthIsTheIntegral() {
    for (const double c : {1.0, 13.0, 60.0})
        for (const double z : {1e-4, 0.01, 0.0877, 0.2})
            QVERIFY(std::abs(UrethraCentreline(c, z).length_m() - quadrature(c, z)) < 1e-13);
    QVERIFY(std::abs(kLine.length_m() - 0.13922485126556) <
            1e-13); // models.md: 56 sections of at most 2.5 mm
    QCOMPARE(kLine.arcLengthAt(-0.02), -0.02);
}

void TestUrethraCentreline::arcLengthAndItsInverseAgree() {
    core::Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const UrethraCentreline line(random.uniform(0.1, 100.0), 0.1);
        const double s = random.uniform(-0.05, 0.4);
        QVERIFY(std::abs(line.arcLengthAt(line.zAt(s)) - s) < 1e-15);
        const double z = std::pow(10.0, random.uniform(-12.0, 0.0));
        QVERIFY(std::abs(line.zAt(line.arcLengthAt(z)) - z) < 1e-15);
    }
    QCOMPARE(kLine.zAt(0.0), 0.0);
    QCOMPARE(kLine.zAt(-0.03), -0.03);
}

void TestUrethraCentreline::framesAreRightHandedAndTangent() {
    for (double s = -0.03; s < 0.2; s += 0.0013) {
        const CentrelinePoint at = kLine.at(s);
        QCOMPARE(at.s_m, s);
        QVERIFY((Vec3::UnitX().cross(at.n_A) - at.t_A).norm() < 1e-15);
        QVERIFY(std::abs(at.t_A.norm() - 1.0) < 1e-15 && at.p_A.x() == 0.0);
        QVERIFY(std::abs(at.p_A.y() - (at.z_m > 0.0 ? kC * at.z_m * at.z_m : 0.0)) < 1e-17);
        QVERIFY((at.t_A - Vec3(0.0, std::sin(at.psi_rad), std::cos(at.psi_rad))).norm() < 1e-15);
        const double h = 1e-6;
        if (std::abs(s) < h)
            continue;
        QVERIFY(((kLine.at(s + h).p_A - kLine.at(s - h).p_A) / (2 * h) - at.t_A).norm() < 1e-9);
        // dt/ds = κ n, and n points to the centre of curvature
        QVERIFY(((kLine.at(s + h).t_A - kLine.at(s - h).t_A) / (2 * h) - at.curvature_per_m * at.n_A).norm() <
                1e-6);
    }
    QVERIFY(std::abs(kLine.at(kLine.length_m()).psi_rad * 57.29578 - 66.3) < 0.1); // models.md: "turns 66°"
}

void TestUrethraCentreline::footIsTheNearestPoint() {
    core::Random random(2);
    for (int i = 0; i < 120; ++i) {
        const Vec3 p(random.uniform(-0.02, 0.02), random.uniform(-0.05, 0.15), random.uniform(1e-6, 0.12));
        const CentrelineFoot foot = kLine.foot(p);
        QVERIFY2(std::abs(foot.at.z_m - nearestZ(kC, p)) < 2e-8, qPrintable(QString::number(i)));
        // the offset is in the section's plane, and both coordinates give the point back
        const Vec3 back = foot.at.p_A + foot.ex_m * Vec3::UnitX() + foot.en_m * foot.at.n_A;
        QVERIFY((back - p).norm() < 1e-15);
    }
}

void TestUrethraCentreline::footOfAShiftedPointIsThePoint() {
    core::Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const CentrelinePoint at = kLine.at(random.uniform(0.0, 0.2));
        const double ex = random.uniform(-0.02, 0.02);
        const double en = random.uniform(-0.02, 0.02);
        const Vec3 p = at.p_A + ex * Vec3::UnitX() + en * at.n_A;
        if (p.z() <= 0.0)
            continue;
        const CentrelineFoot foot = kLine.foot(p);
        QVERIFY(std::abs(foot.at.s_m - at.s_m) < 1e-12 && foot.ex_m == ex &&
                std::abs(foot.en_m - en) < 1e-12);
    }
}

void TestUrethraCentreline::footBeforeTheEntrance() {
    const Vec3 p(0.001, 0.004, -0.015); // before the lead-in: the plane of the straight line
    QCOMPARE(kLine.foot(p).at.s_m, -0.015);
    QCOMPARE(kLine.foot(p).gradientOfS_A, Vec3(0, 0, 1));
    QCOMPARE(kLine.foot(p).en_m, 0.004);
    const Vec3 half(0.0, 0.004, -0.005); // g = ½: s = −5 mm / (1 − 26·0.004·½)
    QVERIFY(std::abs(kLine.foot(half).at.s_m + 0.005 / 0.948) < 1e-15);
    QCOMPARE(kLine.foot(p).bendOfS_per_m, 0.0); // s is linear there, and its bound says so
    QVERIFY(kLine.foot(half).bendOfS_per_m > 0.0);
    QCOMPARE(kLine.foot(Vec3(0.0, 0.0, -0.003)).at.s_m, -0.003);
}

void TestUrethraCentreline::gradientIsThatOfTheArcLength() {
    core::Random random(4);
    for (int i = 0; i < 20000; ++i) {
        // tools within 20 mm of the line, before A, in the lead-in, about A, along the canal and past C
        const CentrelinePoint at = kLine.at(random.uniform(-0.03, 0.17));
        const Vec3 p =
            at.p_A + random.uniform(-0.02, 0.02) * Vec3::UnitX() + random.uniform(-0.02, 0.02) * at.n_A;
        if (std::abs(p.z()) < 1e-5) // differences across A or the lead-in's start mix two curvatures
            continue;
        QVERIFY2((kLine.foot(p).gradientOfS_A - differences(kLine, p)).norm() < 1e-6,
                 qPrintable(QString::number(i)));
    }
    // across A itself the gradient has a kink but no jump: differences tend to it with the step
    for (const double y : {-0.02, -0.004, 0.0, 0.003, 0.02}) {
        const Vec3 p(0.001, y, 0.0);
        QVERIFY((kLine.foot(p).gradientOfS_A - differences(kLine, p, 1e-6)).norm() < 3e-3);
        QVERIFY((kLine.foot(p).gradientOfS_A - differences(kLine, p, 1e-8)).norm() < 3e-5);
    }
}

void TestUrethraCentreline::continuousAcrossTheEntrance() {
    for (double y = -0.028; y <= 0.0281; y += 0.004)
        for (const double h : {1e-5, 1e-8}) {
            const CentrelineFoot before = kLine.foot(Vec3(0.002, y, -h));
            const CentrelineFoot after = kLine.foot(Vec3(0.002, y, h));
            QVERIFY(std::abs(after.at.s_m - before.at.s_m) < 10.0 * h);
            QVERIFY(std::abs(after.en_m - before.en_m) < 3.0 * h && after.ex_m == before.ex_m);
            QVERIFY((after.gradientOfS_A - before.gradientOfS_A).norm() < 1e4 * h);
        }
    // and where the lead-in begins
    for (const double y : {-0.02, 0.004, 0.02}) {
        const CentrelineFoot out = kLine.foot(Vec3(0.0, y, -UrethraCentreline::kLeadIn_m - 1e-9));
        const CentrelineFoot in = kLine.foot(Vec3(0.0, y, -UrethraCentreline::kLeadIn_m + 1e-9));
        QVERIFY(std::abs(in.at.s_m - out.at.s_m) < 3e-9);
        QVERIFY((in.gradientOfS_A - out.gradientOfS_A).norm() < 1e-5);
    }
}

void TestUrethraCentreline::farFromTheLineIsFiniteAndBounded() {
    core::Random random(5);
    for (int i = 0; i < 50000; ++i) {
        const double reach = std::pow(10.0, random.uniform(-9.0, 3.0));
        const Vec3 p(random.uniform(-reach, reach), random.uniform(-reach, reach),
                     random.uniform(-reach, reach));
        const CentrelineFoot foot = kLine.foot(p);
        QVERIFY(foot.at.p_A.allFinite() && std::isfinite(foot.at.s_m) && foot.gradientOfS_A.allFinite());
        if (p.z() > 0.0) {
            QVERIFY(foot.at.z_m > 0.0 && foot.gradientOfS_A.norm() <= 4.0 + 1e-12);
            const double y = 1.0 - 2.0 * kC * p.y();
            const double z = foot.at.z_m;
            const double terms = 2.0 * kC * kC * z * z * z + std::abs(y) * z + p.z();
            QVERIFY(std::abs((2.0 * kC * kC * z * z + y) * z - p.z()) < 1e-14 * terms);
        }
    }
    for (const Vec3& p :
         {Vec3(0, 0, 0), Vec3(0, 1.0 / 26.0, 1e-300), Vec3(0, 0.05, 1e-12), Vec3(0, 1.0 / 26.0, 0)}) {
        const CentrelineFoot foot = kLine.foot(p);
        QVERIFY(std::isfinite(foot.at.s_m) && foot.gradientOfS_A.allFinite());
    }
}

QTEST_APPLESS_MAIN(TestUrethraCentreline)
#include "test_urethra_centreline.moc"
