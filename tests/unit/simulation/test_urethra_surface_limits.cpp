// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "simulation/geometry/urethra/urethra_curve_net.h"
#include "urethra_vertices.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::tests;
using simulation::UrethraCurveNet;
using simulation::UrethraDeformation;
using simulation::UrethraMeshSettings;

namespace {

constexpr double kLength = 0.13922485126556;

bool allGood(const UrethraSurface& surface) {
    for (std::size_t v = 0; v < surface.vertexCount(); ++v)
        if (!position(surface, v).allFinite() || !(std::abs(normalOf(surface, v).norm() - 1.0) < 1e-5) ||
            !std::isfinite(surface.arcLength_m()[v]))
            return false;
    return true;
}

} // namespace

class TestUrethraSurfaceLimits : public QObject {
    Q_OBJECT
private slots:
    void grazingCasesHaveNoHoles();
    void coarsestAndFinestMeshes();
    void thinEndoscopeDoesNotSqueeze();
};

void TestUrethraSurfaceLimits::grazingCasesHaveNoHoles() {
    UrethraSurface surface({}, {}, {});
    const UrethraCurveNet net({}, {}, {});
    std::vector<double> places{0.0, kLength, -0.010, kLength - 0.010, 1e9, -1e9};
    for (int i = 0; i < 26; ++i)
        places.push_back(net.rest().s_m(i));
    for (const double place : places)
        for (const double more : {0.0, 1e-15, 1e-9, 0.5e-6, 0.999999e-6, 1e-6, 1.000001e-6, 2e-6})
            for (const double sign : {-1.0, 1.0}) {
                surface.update({true, place + sign * more, 0.0, 0.0});
                QVERIFY2(allGood(surface), qPrintable(QString::number(place + sign * more, 'g', 17)));
                surface.update({true, place + sign * more - 0.010, 0.001, -0.002}); // and the end there
                QVERIFY2(allGood(surface), qPrintable(QString::number(place + sign * more - 0.010, 'g', 17)));
            }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<float> rest = contents(UrethraSurface({}, {}, {}));
    for (const UrethraDeformation& bad :
         {UrethraDeformation{true, nan, 0, 0}, UrethraDeformation{true, 0.05, nan, 0},
          UrethraDeformation{true, 0.05, 0, infinity}}) {
        surface.update(bad); // unknown: drawn at rest
        QVERIFY(sameBits(contents(surface), rest));
    }
}

void TestUrethraSurfaceLimits::coarsestAndFinestMeshes() {
    for (const UrethraMeshSettings& mesh :
         {UrethraMeshSettings{5, 4, 1, 3}, UrethraMeshSettings{129, 401, 1, 33},
          UrethraMeshSettings{129, 4, 32, 3}, UrethraMeshSettings{6, 4, 9, 33}}) {
        UrethraSurface surface({}, {}, mesh);
        UrethraSurface built({}, {}, mesh);
        for (const double tip : {-0.005, 0.0, 0.05, 0.0512, 0.1345, 0.2}) {
            surface.update({true, tip, 0.001, 0.001});
            built.rebuild({true, tip, 0.001, 0.001});
            QVERIFY(allGood(surface) && sameBits(contents(surface), contents(built)));
        }
    }
}

void TestUrethraSurfaceLimits::thinEndoscopeDoesNotSqueeze() {
    simulation::Endoscope thin;
    thin.radius_m = 0.0015;
    UrethraSurface surface({}, thin, {});
    const simulation::UrethraCentreline line(13.0, 0.0877);
    for (const double tip : {0.02, 0.0733, 0.13})
        for (const double offset : {0.0, 0.0009}) { // within the slack of 1 mm
            surface.update({true, tip, offset, 0.0});
            for (std::size_t v = 0; v < surface.vertexCount(); ++v) {
                const auto foot = line.foot(position(surface, v));
                QVERIFY(std::abs(std::hypot(foot.ex_m, foot.en_m) - 0.0025) < 3e-6); // interpolation alone
            }
        }
    surface.update({true, 0.0733, 0.002, 0.0}); // 1 mm past the slack
    double widest = 0.0;
    for (std::size_t v = 0; v < surface.vertexCount(); ++v)
        widest = std::max(widest, position(surface, v).x());
    QVERIFY(std::abs(widest - 0.0035) < 3e-6);
}

QTEST_APPLESS_MAIN(TestUrethraSurfaceLimits)
#include "test_urethra_surface_limits.moc"
