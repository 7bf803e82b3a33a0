// SPDX-License-Identifier: GPL-3.0-or-later
// What is touched lets go: a tool that has come out on another side, or presses harder than the tissue bears,
// is soon free.
#include "core/units.h"
#include "modules/exercises/object_handling/simulation/object_handling_scene.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"
#include "simulation/objects/contact_yield.h"
#include "simulation/objects/felt_place.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

using namespace chiron;
using core::Vec3;
using namespace chiron::simulation;
namespace contact = core::contact_bits;

namespace {

constexpr double kFall_s = 0.020;

SphereApexParameters dome(ApexSurface surface, double yield_N) {
    SphereApexParameters p;
    p.surface = surface;
    p.centreDiscRadius_m = 0.0;
    p.meshEdge_m = 0.002;
    p.trials = 1;
    if (yield_N > 0.0)
        p.yield = {yield_N, kFall_s};
    return p;
}

ObjectHandlingParameters organBed(double yield_N) {
    ObjectHandlingParameters p;
    p.organBed = true;
    p.bedMesh.shape = MeshSource::Shape::ellipsoid;
    p.bedMesh.halfAxisX_m = p.bedMesh.halfAxisY_m = 0.090;
    p.bedMesh.halfAxisZ_m = 0.014;
    p.bedMesh.edge_m = 0.006;
    p.object.mass_kg = 0.010;
    p.trials = 1;
    if (yield_N > 0.0)
        p.yield = {yield_N, kFall_s};
    return p;
}

/// A scene with one tool that is led along straight lines.
struct Led {
    explicit Led(std::unique_ptr<IScene> made, const Vec3& begin) : scene(std::move(made)) {
        in.tools.count = 1;
        in.started = in.forceReady = true;
        in.tools.tools[0].p_WT = begin;
        for (int i = 0; i < 3; ++i)
            tick();
    }
    void tick() {
        const Vec3 before = force();
        scene->respond(source.next(0), in, out);
        largestStep_N = std::max(largestStep_N, (force() - before).norm());
        largest_N = std::max(largest_N, force().norm());
        yields += (out.contact[0] & contact::kYielded) != 0 ? 1 : 0;
    }
    void to(const Vec3& goal, double speed_m_per_s) {
        core::ToolState& tool = in.tools.tools[0];
        const Vec3 way = goal - tool.p_WT;
        const int n = std::max(1, static_cast<int>(way.norm() / (speed_m_per_s * core::kTickSeconds)));
        for (int i = 0; i < n; ++i) {
            tool.p_WT += way / n;
            tool.v_WT = way / (n * core::kTickSeconds);
            tick();
        }
        tool.v_WT.setZero();
    }
    void wait(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds / core::kTickSeconds); ++i)
            tick();
    }
    Vec3 force() const { return out.tissue.tools[0].force; }
    bool free() const {
        return force() == Vec3::Zero() && out.storedEnergy_J == 0.0 && out.contactStiffness_N_per_m == 0.0;
    }

    std::unique_ptr<IScene> scene;
    realtime::TickSource source;
    SceneInput in;
    SceneOutput out;
    double largestStep_N = 0.0;
    double largest_N = 0.0;
    int yields = 0;
};

} // namespace

class TestLetsGo : public QObject {
    Q_OBJECT
private slots:
    void theFactorOfAContact();
    void torqueYieldsToo();
    void whatIsFoundDeepIsNotEntered();
    void aPlaceIsFeltWithoutJumps();
    void aSheetThatIsFoundDeepLetsOut();
    void upFromUnderneath_data();
    void upFromUnderneath();
    void outOnTheOtherSideOfTheDome_data();
    void outOnTheOtherSideOfTheDome();
    void pressedHarderThanItBears_data();
    void pressedHarderThanItBears();
    void throughTheRimOfAnOrgan_data();
    void throughTheRimOfAnOrgan();
    void neverYieldsWhereTheContentDoesNotSaySo();
};

void TestLetsGo::theFactorOfAContact() {
    ContactYield yield({6.0, kFall_s});
    QCOMPARE(yield.step(6.0, false, false, 0.001), 1.0);
    QCOMPARE(int(yield.bits()), 0);
    double before_N = 3.0;
    QCOMPARE(yield.step(3.0, false, true, 0.001) * 3.0, 3.0); // where it is, and down from there
    QCOMPARE(int(yield.bits()), int(contact::kYielded | contact::kThrough | contact::kBeyondChecked));
    for (int i = 0; i < 20; ++i) {
        QVERIFY(!yield.gone());
        const double now_N = 3.0 * yield.step(3.0, false, true, 0.001);
        QVERIFY(now_N <= before_N && before_N - now_N <= 1.5 * 3.0 / 20.0 + 1e-9);
        QVERIFY(!(yield.bits() & contact::kYielded));
        before_N = now_N;
    }
    QCOMPARE(before_N, 0.0);
    QVERIFY(yield.gone());
    QCOMPARE(yield.step(5.0, false, false, 0.001), 0.0);
    QCOMPARE(yield.step(0.0, true, false, 0.001), 1.0);
    QCOMPARE(yield.step(5.9, false, false, 0.001), 1.0); // whole again, as strong as before
    QCOMPARE(6.5 * yield.step(6.5, false, false, 0.001), 6.0);
}

// Under a torque as under a force: never more than it bears of either, by one curve, told once.
void TestLetsGo::torqueYieldsToo() {
    TissueYield yield({8.0, kFall_s, 0.2});
    QCOMPARE(yield.step(7.9, false, 0.001, 0.19), 1.0);
    QVERIFY(!yield.through());
    double before_Nm = 0.2;
    for (int i = 0; i <= 20; ++i) {
        const double force_N = 2.0, torque_Nm = 0.25;
        const double factor = yield.step(force_N, false, 0.001, torque_Nm);
        QCOMPARE(yield.yielded(), i == 0);
        QVERIFY(torque_Nm * factor <= 0.2 * (1.0 + 1e-12) && torque_Nm * factor <= before_Nm * (1.0 + 1e-12));
        QVERIFY(before_Nm - torque_Nm * factor <= 1.5 * 0.2 / 20.0 + 1e-12);
        before_Nm = torque_Nm * factor;
    }
    QCOMPARE(before_Nm, 0.0);
    QCOMPARE(yield.step(0.0, true, 0.001), 1.0);
    QCOMPARE(yield.step(2.0, false, 0.001, 0.2), 1.0); // whole again
    TissueYield byForce({8.0, kFall_s});               // no torque stated: as it was
    byForce.step(1.0, true, 0.001);
    QCOMPARE(byForce.step(2.0, false, 0.001, 5.0), 1.0);
    QCOMPARE(byForce.step(16.0, false, 0.001, 5.0), 0.5);
}

// Who is in tissue before he was seen, deeper than it holds, has not broken it: 0 N until he is out, and no
// event.
void TestLetsGo::whatIsFoundDeepIsNotEntered() {
    ContactYield yield({6.0, kFall_s});
    for (int i = 0; i < 50; ++i) {
        QCOMPARE(yield.step(20.0, false, false, 0.001), 0.0);
        QVERIFY(yield.through() && yield.gone() && !(yield.bits() & contact::kYielded));
    }
    yield.step(0.0, true, false, 0.001);
    QCOMPARE(yield.step(5.0, false, false, 0.001), 1.0);
    QCOMPARE(6.5 * yield.step(6.5, false, false, 0.001), 6.0);
    QVERIFY(yield.bits() & contact::kYielded);
    yield.reset();                                       // another trial
    QCOMPARE(yield.step(4.0, false, false, 0.001), 1.0); // what holds, holds: the supervisor arms it
    yield.reset();
    QCOMPARE(yield.step(4.0, false, true, 0.001), 0.0);
}

namespace {
ContactPlace at(double depth_m, const Vec3& normal = Vec3::UnitZ()) {
    ContactPlace place;
    place.depth_m = depth_m;
    place.normal = normal;
    place.depthGradient = -normal;
    return place;
}
} // namespace

// Whatever a geometry says, the way out changes by no more than the tool's way and 0.05 mm a tick, and is the
// geometry's again soon.
void TestLetsGo::aPlaceIsFeltWithoutJumps() {
    FeltPlace felt;
    Vec3 p(0.0, 0.0, 0.001);
    QCOMPARE(felt.step(at(-0.001), p, false).depth_m, -0.001);
    Vec3 before = Vec3::Zero();
    for (int i = 1; i <= 1100;
         ++i) { // down 5 mm; from tick 500 the surface says another depth, then another way out
        const double way_m = i <= 600 ? 1e-5 : 0.0;
        p.z() -= way_m;
        const Vec3 normal = i < 800 ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::UnitX());
        const ContactPlace place = felt.step(at((i < 500 ? 0.0 : 0.003) - p.z(), normal), p, false);
        const Vec3 out = place.depth_m > 0.0 ? Vec3(place.depth_m * place.normal) : Vec3(Vec3::Zero());
        QVERIFY((out - before).norm() <= way_m + FeltPlace::kCatchUp_m + 1e-12);
        QVERIFY(std::abs(place.normal.norm() - 1.0) < 1e-12 && place.depthGradient == -place.normal);
        if (i < 500 || i == 799 || i == 1100)
            QVERIFY(std::abs(place.depth_m - felt.geometric_m()) < 1e-12);
        before = out;
    }
    for (int i = 0; i < 3; ++i) // a surface that goes away at once lags, and then nothing is left
        QVERIFY(felt.step(at(-0.001), p, false).depth_m > 0.0);
    for (int i = 0; i < 300; ++i)
        felt.step(at(-0.001), p, false);
    QCOMPARE(felt.felt_m(), -0.001);
    QCOMPARE(felt.less_m(), 0.0);
}

// Found 5 mm deep behind a sheet that it did not go in by: nothing where it is, the sheet's stiffness from
// there on, nothing on the way out.
void TestLetsGo::aSheetThatIsFoundDeepLetsOut() {
    FeltPlace felt;
    Vec3 p(0.0, 0.0, -0.005);
    felt.step(at(0.0001), p, false);
    p.x() += 1e-5;
    QVERIFY(felt.step(at(0.005), p, true).depth_m <= 1e-4 + 1e-5 + FeltPlace::kCatchUp_m + 1e-12);
    const double first_m = felt.felt_m();
    for (int i = 0; i < 100; ++i) {
        p.z() -= 2e-5;
        felt.step(at(-p.z()), p, false);
    }
    QVERIFY(std::abs(felt.felt_m() - first_m - 0.002) < 1e-12);
    for (int i = 0; i < 1000; ++i) { // and out
        const double before_m = felt.felt_m();
        p.z() += 1e-5;
        felt.step(at(-p.z()), p, false);
        QVERIFY(felt.felt_m() <= before_m &&
                felt.felt_m() <= std::max(0.0, first_m + 0.002 - 1e-5 * (i + 1)) + 1e-12);
    }
    for (int i = 0; i < 500; ++i) {
        p.z() -= 1e-5;
        felt.step(at(-p.z()), p, false);
        QVERIFY(std::abs(felt.felt_m() + p.z()) < 1e-12 || p.z() > 0.0); // it has been out: the sheet itself
    }
}

void TestLetsGo::upFromUnderneath_data() {
    QTest::addColumn<int>("surface");
    QTest::addColumn<double>("yield_N");
    QTest::addRow("exact") << static_cast<int>(ApexSurface::exact) << 6.0;
    QTest::addRow("mesh") << static_cast<int>(ApexSurface::mesh) << 6.0;
    QTest::addRow("organ") << static_cast<int>(ApexSurface::organ) << 6.0;
}

// A hand that is under the table when the trial begins touches nothing there, breaks nothing, and finds all
// of it whole when it has come out.
void TestLetsGo::upFromUnderneath() {
    QFETCH(int, surface);
    QFETCH(double, yield_N);
    for (const Vec3& start : {Vec3(0.0, 0.0, -0.050), Vec3(0.010, 0.010, -0.017), Vec3(0.028, 0.0, -0.025),
                              Vec3(0.031, 0.0, -0.016), Vec3(0.060, 0.0, -0.030)}) {
        Led led(std::make_unique<SphereApexScene>(dome(static_cast<ApexSurface>(surface), yield_N), 7),
                start);
        for (const Vec3& place : {Vec3(0.045, 0.010, -0.020), Vec3(-0.005, 0.025, -0.016),
                                  Vec3(0.0, -0.010, -0.004), Vec3(0.045, 0.0, -0.002),
                                  Vec3(0.015, 0.0, -0.002), Vec3(0.005, 0.0, 0.010), Vec3(0.0, 0.0, 0.030)})
            led.to(place, 0.1);
        QCOMPARE(led.largest_N, 0.0);
        QCOMPARE(led.yields, 0);
        QVERIFY(led.free());
        led.to(Vec3(0.0, 0.0, 0.018), 0.02);
        QVERIFY(led.force().z() > 0.5); // whole
    }
}

void TestLetsGo::outOnTheOtherSideOfTheDome_data() {
    QTest::addColumn<int>("surface");
    QTest::addColumn<double>("yield_N");
    for (const double yield_N : {0.0, 6.0}) {
        QTest::addRow("mesh %g", yield_N) << static_cast<int>(ApexSurface::mesh) << yield_N;
        QTest::addRow("organ %g", yield_N) << static_cast<int>(ApexSurface::organ) << yield_N;
    }
}

// Pushed in from the side and out at the back, the dome keeps nothing: it fell by its curve, told so once,
// and is whole for the next touch.
void TestLetsGo::outOnTheOtherSideOfTheDome() {
    QFETCH(int, surface);
    QFETCH(double, yield_N);
    for (const double height_m : {0.002, 0.006, 0.015})
        for (const double speed_m_per_s : {0.02, 0.3}) {
            Led led(std::make_unique<SphereApexScene>(dome(static_cast<ApexSurface>(surface), yield_N), 7),
                    Vec3(-0.040, 0.0, height_m));
            QVERIFY(led.free());
            led.to(Vec3(0.026, 0.001, height_m), speed_m_per_s);
            led.wait(2.0 * kFall_s);
            QVERIFY2(led.free(), qPrintable(QString::number(led.force().norm())));
            QCOMPARE(led.yields,
                     height_m < 0.005 ? 1 : std::min(led.yields, 1)); // higher up it may slide over instead
            QCOMPARE(int(led.out.contact[0] & contact::kThrough), 0); // out: nothing is left of it
            led.to(Vec3(0.060, 0.0, height_m), 0.1);
            QVERIFY(led.free());
            led.to(Vec3(0.0, 0.0, 0.030), 0.1);
            led.to(Vec3(0.0, 0.0, 0.017), 0.1);
            led.wait(1.0);
            QVERIFY(led.force().z() > 0.4);
        }
}

void TestLetsGo::pressedHarderThanItBears_data() {
    QTest::addColumn<int>("surface");
    for (const auto& [name, surface] :
         {std::pair{"exact", ApexSurface::exact}, std::pair{"mesh", ApexSurface::mesh},
          std::pair{"organ", ApexSurface::organ}})
        QTest::newRow(name) << static_cast<int>(surface);
}

// Down onto the apex and beside it, as deep as a device goes: never more than the tissue bears, and nothing
// jumps.
void TestLetsGo::pressedHarderThanItBears() {
    QFETCH(int, surface);
    constexpr double kYield_N = 5.0;
    for (const Vec3& over : {Vec3(0.0, 0.0, 0.040), Vec3(0.012, 0.004, 0.040), Vec3(0.0195, 0.0, 0.040),
                             Vec3(0.034, 0.0, 0.040), Vec3(0.055, 0.0, 0.040)})
        for (const double speed_m_per_s : {0.05, 0.3}) {
            SphereApexParameters p = dome(static_cast<ApexSurface>(surface), kYield_N);
            p.damping_Ns_per_m = 0.0;
            Led led(std::make_unique<SphereApexScene>(p, 7), over);
            led.to(Vec3(over.x(), over.y(), -0.080), speed_m_per_s);
            QVERIFY2(led.largest_N <= kYield_N * (1.0 + 1e-9), qPrintable(QString::number(led.largest_N)));
            const double step_N = 1.5 * kYield_N * core::kTickSeconds / kFall_s +
                                  500.0 * speed_m_per_s * core::kTickSeconds + 0.1;
            QVERIFY2(led.largestStep_N <= step_N, qPrintable(QStringLiteral("%1 N at x %2, %3 m/s")
                                                                 .arg(led.largestStep_N)
                                                                 .arg(over.x())
                                                                 .arg(speed_m_per_s)));
            QCOMPARE(led.yields, 1);
            QVERIFY(led.force() == Vec3::Zero() && led.out.storedEnergy_J == 0.0);
            QVERIFY(led.out.contact[0] & contact::kThrough);
            led.to(over, 0.3); // out: whole again
            QVERIFY(led.free());
            QCOMPARE(int(led.out.contact[0]), 0);
        }
}

void TestLetsGo::throughTheRimOfAnOrgan_data() {
    QTest::addColumn<double>("yield_N");
    QTest::newRow("never by force") << 0.0;
    QTest::newRow("at 6 N") << 6.0;
}

// An organ's edge is thinner than a press is deep: in at the top, out at the side.
void TestLetsGo::throughTheRimOfAnOrgan() {
    QFETCH(double, yield_N);
    for (const double angle_rad : {0.3, 1.9, 4.0})
        for (const double speed_m_per_s : {0.03, 0.3}) {
            const Vec3 out(std::cos(angle_rad), std::sin(angle_rad), 0.0);
            Led led(std::make_unique<ObjectHandlingScene>(organBed(yield_N), 3),
                    0.080 * out + Vec3(0.0, 0.0, 0.010));
            led.to(0.082 * out + Vec3(0.0, 0.0, -0.014), speed_m_per_s); // into the rim ...
            led.to(0.110 * out + Vec3(0.0, 0.0, -0.014), speed_m_per_s); // ... and out of it sideways
            led.wait(2.0 * kFall_s);
            QVERIFY2(led.free(), qPrintable(QStringLiteral("%1 N").arg(led.force().norm())));
            QVERIFY(led.largest_N <= (yield_N > 0.0 ? yield_N : 30.0) * (1.0 + 1e-9));
        }
}

// A session from before there was such a law: the plane holds whatever presses it, and how far that is beyond
// what was checked is flagged.
void TestLetsGo::neverYieldsWhereTheContentDoesNotSaySo() {
    Led led(std::make_unique<SphereApexScene>(dome(ApexSurface::exact, 0.0), 7), Vec3(0.055, 0.0, 0.010));
    led.to(Vec3(0.055, 0.0, -0.080), 0.3);
    QVERIFY(led.force().norm() > 39.0);
    QCOMPARE(int(led.out.contact[0]), int(contact::kBeyondChecked));
    led.to(Vec3(0.055, 0.0, -0.0119), 0.3); // 0.6 of the radius of 20 mm
    QCOMPARE(int(led.out.contact[0]), 0);
}

QTEST_GUILESS_MAIN(TestLetsGo)
#include "test_lets_go.moc"
