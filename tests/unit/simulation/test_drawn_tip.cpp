// SPDX-License-Identifier: GPL-3.0-or-later
// Where the tip is drawn: follows small steps everywhere, and is the tip itself wherever it may be.
#include "core/fp_environment.h"
#include "core/random.h"
#include "modules/exercises/urethra_insertion/simulation/drawn_tip.h"
#include "support/urethra_bench.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using chiron::tests::wholeProcedure;
using core::Vec3;

class TestDrawnTip : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void followsSmallSteps_data();
    void followsSmallSteps();
    void isTheTipItselfWhereItMayBe();
};

void TestDrawnTip::followsSmallSteps_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("n");
    for (const double offset : {0.0, 0.004, 0.0079, 0.0081, 0.009, 0.012, 0.020, 0.030})
        for (const Vec3& way : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                                Vec3(0.6, 0.8, 0), Vec3(-0.6, -0.8, 0)})
            QTest::addRow("%g mm, x %g n %g", 1e3 * offset, way.x(), way.y())
                << offset * way.x() << offset * way.y();
}

// Steps of 0.01 mm along the canal, from outside to the bladder's far wall: the drawn tip moves at most 4.2
// times as far, also where the canal's limit goes over into the sphere.
void TestDrawnTip::followsSmallSteps() {
    QFETCH(double, x);
    QFETCH(double, n);
    const UrethraInsertionParameters p = wholeProcedure();
    const DrawnTip tip(p);
    const UrethraCentreline line(p.anatomy);
    const auto drawnAt = [&](double s) {
        const CentrelinePoint at = line.at(s);
        const Vec3 p_A = at.p_A + x * Vec3::UnitX() + n * at.n_A;
        return tip.at(p_A, line.foot(p_A));
    };
    Vec3 last_A = drawnAt(-0.040);
    double largest = 0.0;
    double where_m = 0.0;
    for (int i = 1; i < 27000; ++i) {
        const double s = -0.040 + 1e-5 * i;
        const Vec3 drawn_A = drawnAt(s);
        if ((drawn_A - last_A).norm() > 1e-5 * largest) {
            largest = (drawn_A - last_A).norm() / 1e-5;
            where_m = s;
        }
        last_A = drawn_A;
    }
    QVERIFY2(largest < 4.2, qPrintable(QStringLiteral("%1 at s = %2 mm").arg(largest).arg(1e3 * where_m)));
}

void TestDrawnTip::isTheTipItselfWhereItMayBe() {
    UrethraInsertionParameters p = wholeProcedure();
    p.pose.p_WA = Vec3(0.0123, -0.0456, 0.0789);
    p.pose.q_WA = core::Quat(Eigen::AngleAxisd(0.7, Vec3(0.3, -0.5, 0.8).normalized())) * p.pose.q_WA;
    const DrawnTip tip(p);
    const UrethraCentreline line(p.anatomy);
    const Vec3 centre = bladderCentre_A(p.anatomy, line);
    const double room_m = p.anatomy.bladderRadius_m - p.endoscope.radius_m;
    core::Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const CentrelinePoint at = line.at(random.uniform(0.0, line.length_m() + 0.02));
        const double turn = random.uniform(0.0, 6.28);
        const double offset_m = random.uniform(0.0, 0.00799);
        const Vec3 inCanal_W =
            p.pose.pointToW(at.p_A + offset_m * (std::cos(turn) * Vec3::UnitX() + std::sin(turn) * at.n_A));
        QVERIFY(tip.inW(inCanal_W) == inCanal_W);
        Vec3 out(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        out *= random.uniform(0.0, 0.99999) * room_m / std::max(1e-9, out.norm());
        const Vec3 inBladder_W = p.pose.pointToW(centre + out);
        QVERIFY(tip.inW(inBladder_W) == inBladder_W);
    }
}

QTEST_APPLESS_MAIN(TestDrawnTip)
#include "test_drawn_tip.moc"
