// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/geometry/urethra/urethra_curve_net.h"
#include "support/urethra_reference_geometry.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <memory>

using namespace chiron;
using core::Vec3;
using simulation::CoonsPatch;
using simulation::CubicBezier;
using simulation::PatchPoint;
using simulation::UrethraCurveNet;
using simulation::UrethraCurves;
using simulation::UrethraDeformation;
using testing::UrethraReferenceGeometry;

namespace {

simulation::UrethraAnatomy withStricture() {
    simulation::UrethraAnatomy anatomy;
    anatomy.changes[0] = {0.080, 0.012, 0.004, 0.0015, 15.0, 1.0};
    anatomy.changes[1] = {0.108, 0.012, 0.006, 0.0045, 1.0, 1.0}; // wider than the endoscope
    anatomy.changeCount = 2;
    return anatomy;
}

std::unique_ptr<UrethraCurveNet> net(int n = 17, int w = 26) {
    return std::make_unique<UrethraCurveNet>(simulation::UrethraAnatomy{}, simulation::Endoscope{},
                                             simulation::UrethraMeshSettings{n, w, 8, 9});
}

/// Tips from before A to beyond C, with no, little and much offset.
const std::vector<UrethraDeformation> kTips{
    {true, -0.004, 0.0, 0.0},     {true, 0.0, 0.0, 0.0},        {true, 0.0312, 0.0, 0.0},
    {true, 0.0604, 0.0, 0.0},     {true, 0.0604, 0.001, 0.002}, {true, 0.0931, -0.003, 0.0},
    {true, 0.1274, 0.0, -0.003},  {true, 0.1291, 0.0, 0.0},     {true, 0.1350, 0.001, 0.001},
    {true, 0.1500, 0.002, 0.001}, {true, 0.0771, 0.0, 0.005},
};

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

double worstTangentAlong(const UrethraCurves& curves) {
    double worst = 0.0;
    for (int span = 0; span + 1 < curves.spans(); ++span)
        for (int j = 0; j < curves.columns(); ++j)
            worst = std::max(
                worst, angleBetween(curves.along(span, j).slope(1.0), curves.along(span + 1, j).slope(0.0)));
    return worst;
}

double worstTangentAround(const UrethraCurves& curves, int sections) {
    double worst = 0.0;
    for (int i = 0; i < sections; ++i)
        for (int j = 0; j < curves.columns(); ++j) { // j + 1 wraps: the seam is one of them
            const CubicBezier next = curves.around(i, (j + 1) % curves.columns());
            worst = std::max(worst, angleBetween(curves.around(i, j).slope(1.0), next.slope(0.0)));
        }
    return worst;
}

} // namespace

class TestUrethraSurfaceCurves : public QObject {
    Q_OBJECT
private slots:
    void interpolatesEverySectionPoint();
    void tangentsAgreeAtAllJoints();
    void basicSectionsStayWhereTheyAre();
    void agreesWithTheReference_data();
    void agreesWithTheReference();
    void endsWhereTheWindowEnds();
};

void TestUrethraSurfaceCurves::interpolatesEverySectionPoint() {
    const auto curves = net();
    UrethraReferenceGeometry reference({}, {}, {});
    for (const UrethraDeformation& tip : kTips) {
        curves->deform(tip);
        reference.deform(tip);
        const UrethraCurves& now = curves->deformed();
        for (int span = 0; span < now.spans(); ++span)
            for (int j = 0; j < 16; ++j) {
                const CoonsPatch patch = now.patch(span, j);
                const int next = (j + 1) % 16;
                QVERIFY((patch.at(0, 0).p_A - now.vector(span, UrethraCurves::kPoint, j)).norm() < 1e-16);
                QVERIFY((patch.at(0, 1).p_A - now.vector(span, UrethraCurves::kPoint, next)).norm() < 1e-16);
                QVERIFY((patch.at(1, 0).p_A - now.vector(span + 1, UrethraCurves::kPoint, j)).norm() < 1e-16);
                QVERIFY((patch.at(1, 1).p_A - now.vector(span + 1, UrethraCurves::kPoint, next)).norm() <
                        1e-16);
                // the points themselves lie on the opened tube, not merely near it
                const Vec3 exact = reference.exactAt(now.s_m(span), 2.0 * core::kPi * j / 16);
                QVERIFY((now.vector(span, UrethraCurves::kPoint, j) - exact).norm() < 1e-12);
            }
    }
}

void TestUrethraSurfaceCurves::tangentsAgreeAtAllJoints() {
    const auto curves = net();
    QVERIFY(worstTangentAlong(curves->rest()) < 1e-6);
    QVERIFY(worstTangentAround(curves->rest(), 26) < 1e-6);
    for (const UrethraDeformation& tip : kTips) {
        curves->deform(tip);
        const UrethraCurves& now = curves->deformed();
        QVERIFY(worstTangentAlong(now) < 1e-6);
        // the end is no section but a ring of the resting Coons surface: not a joint of curves (crease below)
        QVERIFY(worstTangentAround(now, now.sections() - (curves->plan().endsOnRest() ? 1 : 0)) < 1e-6);
        if (!curves->plan().endsOnRest())
            continue;
        const auto& end = curves->plan().sections().back();
        for (int j = 0; j < 16; ++j)
            QVERIFY(angleBetween(now.along(now.spans() - 1, j).slope(1.0),
                                 curves->rest().along(end.restSpan, j).slope(end.restParameter)) < 1e-6);
    }
}

void TestUrethraSurfaceCurves::basicSectionsStayWhereTheyAre() {
    const auto curves = net();
    const UrethraCurves& rest = curves->rest();
    const auto centre = [](const UrethraCurves& of, int section) {
        return Vec3(0.5 * (of.vector(section, UrethraCurves::kPoint, 0) +
                           of.vector(section, UrethraCurves::kPoint, 8)));
    };
    for (double tip = -0.02; tip < 0.17; tip += 0.00037)
        for (const double offset : {0.0, 0.002}) {
            curves->deform({true, tip, 0.5 * offset, offset});
            int basic = 0;
            for (std::size_t i = 0; i < curves->plan().sections().size(); ++i) {
                const auto& section = curves->plan().sections()[i];
                if (basic >= rest.sections() || section.s_m != rest.s_m(basic) || section.restSpan >= 0)
                    continue;
                const auto at = curves->centreline().at(section.s_m);
                const Vec3 moved = centre(curves->deformed(), static_cast<int>(i)) - centre(rest, basic);
                QVERIFY(std::abs(moved.dot(at.t_A)) < 1e-16); // never along the centre-line
                if (offset == 0.0) {                          // and not at all
                    QVERIFY(section.ex_m == 0.0 && section.en_m == 0.0 && moved.norm() < 1e-16);
                    const double more = section.radius_m / 0.0025;
                    for (int j = 0; j < 16; ++j)
                        QVERIFY((curves->deformed().vector(static_cast<int>(i), UrethraCurves::kPoint, j) -
                                 at.p_A - more * (rest.vector(basic, UrethraCurves::kPoint, j) - at.p_A))
                                    .norm() < 1e-16);
                }
                ++basic;
            }
            // every basic section up to the deformation's end is among them
            const double end = tip + 0.010;
            for (int i = 0; i < rest.sections(); ++i)
                QVERIFY(i < basic || rest.s_m(i) > end - 2e-6);
        }
}

void TestUrethraSurfaceCurves::agreesWithTheReference_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("P1's urethra") << 0;
    QTest::newRow("stricture and a wide part") << 1;
    QTest::newRow("thin endoscope") << 2;
    QTest::newRow("other grids") << 3;
}

void TestUrethraSurfaceCurves::agreesWithTheReference() {
    QFETCH(int, kind);
    const simulation::UrethraAnatomy anatomy = kind == 1 ? withStricture() : simulation::UrethraAnatomy{};
    simulation::Endoscope scope;
    if (kind == 2)
        scope.radius_m = 0.0018;
    const simulation::UrethraMeshSettings mesh =
        kind == 3 ? simulation::UrethraMeshSettings{12, 41, 3, 6} : simulation::UrethraMeshSettings{};
    UrethraCurveNet curves(anatomy, scope, mesh);
    UrethraReferenceGeometry reference(anatomy, scope, mesh);
    core::Random random(7);
    double worst = 0.0;
    for (int i = 0; i < 40; ++i) {
        UrethraDeformation tip{i % 8 != 0, random.uniform(-0.015, 0.16), 0.0, 0.0};
        if (i % 3 != 0) {
            tip.ex_m = random.uniform(-0.003, 0.003);
            tip.en_m = random.uniform(-0.003, 0.003);
        }
        if (i % 5 == 0) // tip or end within the nudge of a basic section
            tip.tip_s_m =
                curves.rest().s_m(5 + i / 4) + random.uniform(-1.2e-6, 1.2e-6) - (i % 2) * scope.beak_m;
        curves.deform(tip);
        reference.deform(tip);
        for (int k = 0; k < 40; ++k) {
            const double s =
                k % 2 == 0 ? random.uniform(0.0, reference.length())
                           : std::clamp(tip.tip_s_m + random.uniform(-0.01, 0.012), 0.0, reference.length());
            const double angle = random.uniform(0.0, 2.0 * core::kPi);
            worst = std::max(worst, (curves.at(s, angle).p_A - reference.at(s, angle)).norm());
        }
    }
    qInfo("largest difference %.1e m", worst);
    QVERIFY(worst < 1e-9);
}

void TestUrethraSurfaceCurves::endsWhereTheWindowEnds() {
    const auto curves = net();
    core::Random random(9);
    for (int i = 0; i < 2000; ++i) {
        const double tip = random.uniform(-0.012, 0.13);
        curves->deform({true, tip, 0.001, 0.001});
        const double end = tip + 0.010;
        if (end <= simulation::UrethraSectionPlan::kNudge_m) {
            QVERIFY(curves->plan().sections().empty());
        } else if (end < curves->centreline().length_m()) {
            const auto& last = curves->plan().sections().back();
            QVERIFY(last.restSpan >= 0 && last.s_m <= end && last.s_m > end - 1.01e-6);
        } else {
            QCOMPARE(curves->plan().sections().back().s_m, curves->centreline().length_m());
        }
        for (std::size_t k = 1; k < curves->plan().sections().size(); ++k)
            QVERIFY(curves->plan().sections()[k].s_m - curves->plan().sections()[k - 1].s_m > 0.9e-6);
    }
}

QTEST_APPLESS_MAIN(TestUrethraSurfaceCurves)
#include "test_urethra_surface_curves.moc"
