// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn fits together: the wall is round the endoscope's tip wherever the tip is drawn, in the
// canal's free part too.
#include "core/units.h"
#include "modules/exercises/urethra_insertion/simulation/drawn_tip.h"
#include "simulation/geometry/urethra/urethra_curve_net.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using core::Vec3;

namespace {

/// The drawn ring at the tip as the tip sees it.
struct Ring {
    double nearest_m = 1.0;  ///< distance of its nearest point
    double turned_rad = 0.0; ///< how far a look along it turns: 2π round the tip, 0 beside it
};

Ring ringRound(const UrethraCurveNet& net, const CentrelineFoot& foot, double s_m) {
    constexpr int kPoints = 64;
    Ring ring;
    double last_rad = 0.0;
    for (int i = 0; i <= kPoints; ++i) {
        const double turn = 2.0 * core::kPi * (i % kPoints) / kPoints;
        const Vec3 from = net.at(s_m, turn).p_A - foot.at.p_A;
        const double x = from.x() - foot.ex_m;
        const double n = from.dot(foot.at.n_A) - foot.en_m;
        ring.nearest_m = std::min(ring.nearest_m, std::hypot(x, n));
        const double angle_rad = std::atan2(n, x);
        if (i > 0)
            ring.turned_rad += std::remainder(angle_rad - last_rad, 2.0 * core::kPi);
        last_rad = angle_rad;
    }
    return ring;
}

} // namespace

class TestUrethraWallEnclosesTip : public QObject {
    Q_OBJECT
private slots:
    void atEveryDepthAndOffset_data();
    void atEveryDepthAndOffset();
};

void TestUrethraWallEnclosesTip::atEveryDepthAndOffset_data() {
    QTest::addColumn<bool>("wide");
    QTest::newRow("the default canal") << false;
    QTest::newRow("wider than the endoscope in one place, narrow in another") << true;
}

void TestUrethraWallEnclosesTip::atEveryDepthAndOffset() {
    QFETCH(bool, wide);
    UrethraInsertionParameters p;
    if (wide) {
        p.anatomy.changes[0] = {0.030, 0.020, 0.005, 0.0050, 1.0, 1.0};
        p.anatomy.changes[1] = {0.080, 0.012, 0.004, 0.0015, 15.0, 1.0};
        p.anatomy.changeCount = 2;
    }
    const UrethraCentreline line(p.anatomy);
    const DrawnTip drawn(p);
    UrethraCurveNet net(p.anatomy, p.endoscope, {});
    double farthest_m = 0.0;
    for (double s = 0.0; s <= line.length_m(); s += 0.0007)
        for (const double offset : {0.0, 0.001, 0.003, 0.006, 0.008, 0.020, 0.030})
            for (int way = 0; way < 8; ++way) {
                const CentrelinePoint at = line.at(s);
                const Vec3 out = std::cos(way * core::kPi / 4.0) * Vec3::UnitX() +
                                 std::sin(way * core::kPi / 4.0) * at.n_A;
                const Vec3 p_A = at.p_A + offset * out;
                const CentrelineFoot foot = line.foot(drawn.at(p_A, line.foot(p_A)));
                net.deform({true, foot.at.s_m, foot.ex_m, foot.en_m});
                const Ring ring = ringRound(net, foot, std::clamp(foot.at.s_m, 0.0, line.length_m()));
                const QString where =
                    QStringLiteral("s %1 mm, offset %2 mm, way %3").arg(1e3 * s).arg(1e3 * offset).arg(way);
                // What the curves may lose to a circle of 17 points, and along a change of radius.
                QVERIFY2(ring.nearest_m > p.endoscope.radius_m - 25e-6, qPrintable(where));
                QVERIFY2(std::abs(std::abs(ring.turned_rad) - 2.0 * core::kPi) < 1e-6, qPrintable(where));
                farthest_m = std::max(farthest_m, std::hypot(foot.ex_m, foot.en_m));
            }
    QVERIFY(farthest_m > 0.00799);
}

QTEST_APPLESS_MAIN(TestUrethraWallEnclosesTip)
#include "test_urethra_wall_encloses_tip.moc"
