// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/geometry/urethra/urethra_curve_net.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <memory>

using namespace chiron;
using core::Vec3;
using simulation::CoonsPatch;
using simulation::PatchPoint;
using simulation::UrethraCurveNet;
using simulation::UrethraCurves;

namespace {

std::unique_ptr<UrethraCurveNet> net(int n = 17, int w = 26) {
    return std::make_unique<UrethraCurveNet>(simulation::UrethraAnatomy{}, simulation::Endoscope{},
                                             simulation::UrethraMeshSettings{n, w, 8, 9});
}

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Vec3 normal(const PatchPoint& at) {
    return at.du_A.cross(at.dv_A);
}

/// Largest angle between the two sides' normals along the edges of patches, in degrees.
double worstCrease(const UrethraCurves& curves) {
    double worst = 0.0;
    for (int span = 0; span < curves.spans(); ++span)
        for (int j = 0; j < curves.columns(); ++j)
            for (double t = 0.0; t <= 1.0; t += 0.125) {
                const CoonsPatch here = curves.patch(span, j);
                const CoonsPatch beside = curves.patch(span, (j + 1) % curves.columns());
                worst = std::max(worst, angleBetween(normal(here.at(t, 1.0)), normal(beside.at(t, 0.0))));
                if (span + 1 < curves.spans())
                    worst = std::max(worst, angleBetween(normal(here.at(1.0, t)),
                                                         normal(curves.patch(span + 1, j).at(0.0, t))));
            }
    return core::degFromRad(worst);
}

/// The same where the deformation meets the resting surface.
double creaseAtTheEnd(const UrethraCurveNet& curves) {
    if (!curves.plan().endsOnRest())
        return 0.0;
    const auto& end = curves.plan().sections().back();
    double worst = 0.0;
    for (int j = 0; j < curves.rest().columns(); ++j)
        for (double v = 0.0; v <= 1.0; v += 0.125)
            worst = std::max(
                worst,
                angleBetween(normal(curves.deformed().patch(curves.deformed().spans() - 1, j).at(1.0, v)),
                             normal(curves.rest().patch(end.restSpan, j).at(end.restParameter, v))));
    return core::degFromRad(worst);
}

/// Largest distance of the surface from the exact resting tube.
double tubeError(int n, int w) {
    const auto curves = net(n, w);
    double worst = 0.0;
    for (int span = 0; span < w - 1; ++span)
        for (int j = 0; j < n - 1; j += std::max(1, (n - 1) / 16))
            for (double t = 0.0; t < 1.0; t += 0.125) {
                const Vec3 p = curves->rest().patch(span, j).at(t, n > 65 ? 0.0 : 0.5).p_A;
                const auto foot = curves->centreline().foot(p);
                worst = std::max(worst, std::abs(std::hypot(foot.ex_m, foot.en_m) - 0.0025));
            }
    return worst;
}

} // namespace

class TestUrethraSurfaceShape : public QObject {
    Q_OBJECT
private slots:
    void creasesStaySmall();
    void convergesToTheTube();
    void nothingPops();
};

void TestUrethraSurfaceShape::creasesStaySmall() {
    const auto curves = net();
    const double rest = worstCrease(curves->rest());
    double deformed = 0.0;
    double offCentre = 0.0;
    double end = 0.0;
    for (double s = -0.0099; s < 0.16; s += 0.00171)
        for (const double offset : {0.0, 0.001, -0.003}) {
            curves->deform({true, s, 0.3 * offset, offset});
            if (curves->deformed().spans() < 1)
                continue;
            const double crease = worstCrease(curves->deformed());
            double& largest = offset == 0.0 ? deformed : offCentre;
            largest = std::max(largest, crease);
            end = std::max(end, creaseAtTheEnd(*curves));
        }
    qInfo("creases: %.3f deg at rest, %.3f with the tip inside, %.3f with it 3 mm off, %.3f at the "
          "deformation's end",
          rest, deformed, offCentre, end);
    QVERIFY(rest < 0.05);
    QVERIFY(offCentre < 0.5);
    QVERIFY(deformed < 0.5);
    QVERIFY(end < 0.5);
}

void TestUrethraSurfaceShape::convergesToTheTube() {
    const auto circle = [](int n) { // a section alone: no error along
        const auto curves = net(n, 4);
        double worst = 0.0;
        for (double v = 0.0; v <= 1.0; v += 0.0625) {
            const auto foot = curves->centreline().foot(curves->rest().around(1, 0).at(v));
            worst = std::max(worst, std::abs(std::hypot(foot.ex_m, foot.en_m) - 0.0025));
        }
        return worst;
    };
    const double coarse = circle(17);
    const double circleOrder = std::log2(coarse / circle(33));
    const double tube = tubeError(129, 26);
    const double tubeOrder = std::log2(tube / tubeError(129, 51));
    const double laterOrder = std::log2(tubeError(129, 101) / tubeError(129, 201));
    qInfo("circle n = 17: %.2f um, order %.2f; tube w = 26: %.2f um, order %.2f, later %.2f", coarse * 1e6,
          circleOrder, tube * 1e6, tubeOrder, laterOrder);
    QVERIFY(std::abs(coarse * 1e6 - 1.4) < 0.1);
    QVERIFY(circleOrder > 3.8 && circleOrder < 4.2);
    QVERIFY(tube * 1e6 < 1.0);
    QVERIFY(tubeOrder > 2.7 && laterOrder > 2.8);
    QVERIFY(tubeError(65, 201) < 0.1 * tubeError(17, 26));
}

// A tip that moves by a little moves the surface by a little: also when it, another moving section or the end
// passes a basic section or enters or leaves the canal. Past it the wall moves by at most ½π(r_e − r_u)/ℓ =
// 0.18 per tip movement.
void TestUrethraSurfaceShape::nothingPops() {
    const auto before = net();
    const auto after = net();
    core::Random random(8);
    double worst = 0.0;
    for (int i = 0; i < 60; ++i) {
        const double section = i % 10 == 0   ? 0.0
                               : i % 10 == 1 ? before->rest().s_m(25)
                                             : before->rest().s_m(i % 24 + 1);
        const double moving = section - 0.010 * static_cast<double>(i % 9) / 8.0;
        for (double from = -2.0e-6; from < 2.0e-6; from += 0.25e-6) {
            before->deform({true, moving + from, 0.0005, -0.001});
            after->deform({true, moving + from + 0.25e-6, 0.0005, -0.001});
            for (int k = 0; k < 25; ++k) {
                const double s = std::clamp(section + random.uniform(-0.012, 0.012), 0.0, 0.1392);
                const double angle = random.uniform(0.0, 6.28);
                worst = std::max(worst, (before->at(s, angle).p_A - after->at(s, angle).p_A).norm());
            }
        }
    }
    qInfo("tip moved by 0.25 um: surface by at most %.3f um", worst * 1e6);
    QVERIFY(worst < 0.15e-6);
}

QTEST_APPLESS_MAIN(TestUrethraSurfaceShape)
#include "test_urethra_surface_shape.moc"
