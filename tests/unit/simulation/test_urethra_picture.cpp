// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "core/units.h"
#include "urethra_driver.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using chiron::tests::endoscopeAt;
using chiron::tests::wholeProcedure;
using core::Vec3;
using Driver = UrethraDriver;

/// What a person is shown: where the tip is drawn, how far the lumen is seen, where a landmark lies.
class TestUrethraPicture : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void tipIsDrawnInside_data();
    void tipIsDrawnInside();
    void drawnTipMovesWithoutJumps();
    void lumenIsSeenAhead();
    void lumenIsNotSeenThroughTheWall();
    void cuesFollowTheLevel();
    void landmarkCueIsWhereTheLandmarkIs();
};

void TestUrethraPicture::tipIsDrawnInside_data() {
    QTest::addColumn<double>("s");
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("drawn"); // from the centre-line; −1: where it is
    QTest::newRow("on the line") << 0.060 << 0.0 << -1.0;
    QTest::newRow("the wall yields") << 0.060 << 0.0079 << -1.0;
    QTest::newRow("no farther") << 0.060 << 0.030 << 0.008;
    QTest::newRow("just inside") << 0.0001 << 0.030 << 0.008;
    QTest::newRow("outside it is free") << -0.020 << 0.030 << -1.0;
}

void TestUrethraPicture::tipIsDrawnInside() {
    QFETCH(double, s);
    QFETCH(double, offset);
    QFETCH(double, drawn);
    Driver d(wholeProcedure());
    d.startRunning();
    const UrethraCentreline line(d.p.anatomy);
    const CentrelinePoint at = line.at(s);
    d.tool() = endoscopeAt(d.p.pose, at.p_A - offset * at.n_A, at.t_A);
    d.tick();
    if (drawn < 0.0)
        QVERIFY((d.out.p_WProxy[0] - d.tool().p_WT).norm() == 0.0);
    else
        QVERIFY(std::abs((d.p.pose.pointToA(d.out.p_WProxy[0]) - at.p_A).norm() - drawn) < 1e-4);
}

// Over the whole neighbourhood the drawn tip lies in the canal or in the bladder, and moves no faster than a
// hand would.
void TestUrethraPicture::drawnTipMovesWithoutJumps() {
    const UrethraInsertionParameters p = wholeProcedure();
    const DrawnTip tip(p);
    const UrethraCentreline line(p.anatomy);
    const Vec3 centre = bladderCentre_A(p.anatomy, line);
    double farthest_m = 0.0;
    for (const double x : {0.0, 0.005, 0.012, 0.040}) {
        for (double s = 0.0; s < 0.25; s += 1e-4) {
            const CentrelinePoint at = line.at(s);
            const Vec3 p_A = at.p_A + x * Vec3::UnitX();
            const Vec3 drawn_A = p.pose.pointToA(tip.inW(p.pose.pointToW(p_A)));
            const CentrelineFoot foot = line.foot(drawn_A);
            const bool inCanal =
                foot.at.s_m <= line.length_m() + 0.0282 && std::hypot(foot.ex_m, foot.en_m) <= 0.0081;
            const bool inBladder =
                (drawn_A - centre).norm() <= p.anatomy.bladderRadius_m - p.endoscope.radius_m + 1e-9;
            QVERIFY2(inCanal || inBladder, qPrintable(QStringLiteral("x %1, s %2").arg(x).arg(s)));
            farthest_m = std::max(farthest_m, (drawn_A - p_A).norm());
        }
    }
    QVERIFY(farthest_m > 0.020);
    Vec3 last_A = line.at(0.0).p_A;
    for (double s = 0.0; s < 0.25; s += 1e-4) { // along the line, out through the bladder's far wall
        const Vec3 p_A = line.at(s).p_A;
        const Vec3 drawn_A = p.pose.pointToA(tip.inW(p.pose.pointToW(p_A)));
        QVERIFY((drawn_A - last_A).norm() < 2e-4);
        last_A = drawn_A;
    }
    QVERIFY((last_A - centre).norm() < p.anatomy.bladderRadius_m);
}

void TestUrethraPicture::lumenIsSeenAhead() {
    Driver d(wholeProcedure());
    d.startRunning();
    for (double s = -0.030; s < 0.150; s += 0.0013) {
        d.at(s, 9); // long enough for a new look
        const simulation::EndoscopeCues& cues = d.out.cues.exercise.of<simulation::EndoscopeCues>();
        const Vec3 to = vectorOf(cues.toLumen_T);
        QVERIFY2(std::abs(to.norm() - 1.0) < 1e-9, qPrintable(QString::number(s)));
        QVERIFY(to.z() < -0.8);             // ahead: the camera looks along −z
        QVERIFY(std::abs(to.x()) < 1e-9);   // in the plane of symmetry
        QVERIFY(to.y() > -1e-9 || s < 0.0); // the canal bends to the front, which is up in the picture
        QVERIFY(cues.lumenDistance_m > 0.0024 && cues.lumenDistance_m <= 0.0626);
        const Vec3 seen_W = d.tool().p_WT + d.tool().q_WT * (cues.lumenDistance_m * to);
        const UrethraCentreline line(d.p.anatomy);
        const CentrelineFoot foot = line.foot(d.p.pose.pointToA(seen_W));
        QVERIFY(std::hypot(foot.ex_m, foot.en_m) < 1e-6);
    }
    // A canal of constant curvature κ and radius r is seen as far as a chord stays in it: √(8 r/κ), here 28
    // mm and a step.
    d.at(0.0101, 9);
    QVERIFY2(
        d.out.cues.exercise.of<simulation::EndoscopeCues>().lumenDistance_m > 0.020 &&
            d.out.cues.exercise.of<simulation::EndoscopeCues>().lumenDistance_m < 0.040,
        qPrintable(QString::number(d.out.cues.exercise.of<simulation::EndoscopeCues>().lumenDistance_m)));
}

void TestUrethraPicture::lumenIsNotSeenThroughTheWall() {
    Driver d(wholeProcedure());
    d.startRunning();
    const UrethraCentreline line(d.p.anatomy);
    const CentrelinePoint at = line.at(0.060);
    d.tool() =
        endoscopeAt(d.p.pose, at.p_A, at.t_A + 1.2 * Vec3::UnitX()); // 50° aside, the picture is 35° wide
    d.ticks(9);
    QVERIFY(d.out.cues.exercise.of<simulation::EndoscopeCues>().pictureShown);
    QCOMPARE(vectorOf(d.out.cues.exercise.of<simulation::EndoscopeCues>().toLumen_T).norm(), 0.0);
    QCOMPARE(d.out.cues.exercise.of<simulation::EndoscopeCues>().lumenDistance_m, 0.0);
    d.tool() = endoscopeAt(d.p.pose, at.p_A,
                           at.t_A + 0.5 * Vec3::UnitX()); // 27° aside: at the picture's edge, to the left
    d.ticks(9);
    QVERIFY(vectorOf(d.out.cues.exercise.of<simulation::EndoscopeCues>().toLumen_T).norm() > 0.99);
    QVERIFY(d.out.cues.exercise.of<simulation::EndoscopeCues>().toLumen_T[0] >
            0.3); // x̂ is to the patient's right, the picture's left
}

void TestUrethraPicture::cuesFollowTheLevel() {
    UrethraInsertionParameters p = wholeProcedure();
    p.cues = {"tool", "guidance"}; // guidance is marked in the picture: without one there is none
    Driver blind(p);
    blind.startRunning();
    blind.at(0.160, 10);
    const simulation::EndoscopeCues& none = blind.out.cues.exercise.of<simulation::EndoscopeCues>();
    QVERIFY(none.present && !none.pictureShown && !none.guided && !none.landmarkShown);
    QCOMPARE(vectorOf(none.toLumen_T).norm() + vectorOf(none.toLandmark_T).norm() + none.lumenDistance_m,
             0.0);
    QVERIFY(std::abs(none.depth_m - 0.160) < 1e-6); // the marks on the shaft are there
    p.cues = {"object"};
    Driver seeing(p);
    seeing.startRunning();
    seeing.at(0.160, 10);
    QVERIFY(seeing.out.cues.exercise.of<simulation::EndoscopeCues>().pictureShown &&
            !seeing.out.cues.exercise.of<simulation::EndoscopeCues>().guided);
    QVERIFY(!seeing.out.cues.objectShown);
}

void TestUrethraPicture::landmarkCueIsWhereTheLandmarkIs() {
    Driver d(wholeProcedure());
    d.startRunning();
    d.at(0.160, 10);
    QVERIFY(d.out.cues.exercise.of<simulation::EndoscopeCues>().landmarkShown);
    const Vec3 seen_W =
        d.tool().p_WT +
        d.tool().q_WT * vectorOf(d.out.cues.exercise.of<simulation::EndoscopeCues>().toLandmark_T);
    const std::array<double, 3> landmark = procedurePlan(d.p).landmark_A[0];
    QVERIFY((d.p.pose.pointToA(seen_W) - vectorOf(landmark)).norm() < 1e-9);
    QVERIFY(d.out.cues.exercise.of<simulation::EndoscopeCues>().toLandmark_T[0] <
            0.0); // the patient's right lies to the left in the picture
    d.at(0.120, 10);
    QVERIFY(!d.out.cues.exercise.of<simulation::EndoscopeCues>().landmarkShown); // back in the canal
}

QTEST_APPLESS_MAIN(TestUrethraPicture)
#include "test_urethra_picture.moc"
