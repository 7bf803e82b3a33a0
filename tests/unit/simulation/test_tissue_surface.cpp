// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"
#include "simulation/palpation/layered_stiffness.h"
#include "tissue_laws.h"

#include <QtTest>
#include <limits>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {
/// The nearest surface point by search: a grid of 0.5 mm, then finer and finer about the best.
double distanceBySearch(const TissueSurface& surface, const Vec3& p) {
    Vec2 middle = p.head<2>();
    double reach = 0.03, best = 1e9;
    for (int round = 0; round < 12; ++round, reach *= 0.25) {
        Vec2 next = middle;
        for (int i = -60; i <= 60; ++i)
            for (int j = -60; j <= 60; ++j) {
                const Vec2 xy = middle + reach * Vec2(i / 60.0, j / 60.0);
                const double distance = (surface.pointAt(xy) - p).norm();
                if (distance < best) {
                    best = distance;
                    next = xy;
                }
            }
        middle = next;
    }
    return best;
}
} // namespace

// The tissue's surface: nearest points, how they follow, where they are unique; and what layers amount to.
class TestTissueSurface : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void nearestIsNearest();
    void footIsThePlaceAbove();
    void anyGuessFindsTheSameFoot();
    void derivativesByDifferences();
    void footFollowsTheTool();
    void deepestUniqueOfOneDome();
    void rayMeetsTheSurface();
    void signIsRightEverywhere();
    void punchWeightHasItsLimits();
    void layersHaveTheirLimits();
};

void TestTissueSurface::nearestIsNearest() {
    const TissueSurface surface(furrowedDome());
    core::Random random(31);
    for (int n = 0; n < 60; ++n) {
        const Vec2 xy(random.uniform(-0.045, 0.045), random.uniform(-0.045, 0.045));
        const Vec3 p = surface.pointAt(xy) + random.uniform(-0.012, 0.020) * surface.normalAt(xy);
        const SurfaceFoot foot = surface.nearest(p, p.head<2>());
        QVERIFY(std::abs(std::abs(foot.depth_m) - distanceBySearch(surface, p)) < 1e-8);
        QVERIFY((foot.p_W - foot.depth_m * foot.normal - p).norm() < 1e-9);
    }
}

// From below, on a known place's normal, the foot is that place, to rounding.
void TestTissueSurface::footIsThePlaceAbove() {
    const TissueSurface surface(furrowedDome());
    QVERIFY2(surface.deepestUnique_m() > 0.008 && surface.deepestUnique_m() < 0.025,
             qPrintable(QString::number(surface.deepestUnique_m())));
    core::Random random(32);
    for (int n = 0; n < 5000; ++n) {
        const Vec2 xy(random.uniform(-0.045, 0.045), random.uniform(-0.045, 0.045));
        const double depth =
            random.uniform(-0.9 * std::min(0.01, surface.highestUnique_m()), 0.9 * surface.deepestUnique_m());
        const Vec3 p = surface.pointAt(xy) - depth * surface.normalAt(xy);
        const SurfaceFoot foot = surface.nearest(p, p.head<2>() + Vec2(random.uniform(-1e-3, 1e-3), 0.0));
        QVERIFY2((foot.p_W - surface.pointAt(xy)).norm() < 1e-10,
                 qPrintable(QString::number((foot.p_W - surface.pointAt(xy)).norm())));
        QVERIFY(std::abs(foot.depth_m - depth) < 1e-12);
    }
}

void TestTissueSurface::anyGuessFindsTheSameFoot() {
    const TissueSurface surface(furrowedDome());
    core::Random random(33);
    for (int n = 0; n < 3000; ++n) {
        const Vec2 xy(random.uniform(-0.04, 0.04), random.uniform(-0.04, 0.04));
        const Vec3 p =
            surface.pointAt(xy) - random.uniform(0.0, 0.9 * surface.deepestUnique_m()) * surface.normalAt(xy);
        const SurfaceFoot a = surface.nearest(p, p.head<2>());
        const SurfaceFoot b =
            surface.nearest(p, Vec2(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)));
        QVERIFY2((a.p_W - b.p_W).norm() < 1e-10, qPrintable(QString::number((a.p_W - b.p_W).norm())));
    }
}

void TestTissueSurface::derivativesByDifferences() {
    const TissueSurface surface(furrowedDome());
    core::Random random(34);
    constexpr double h = 1e-6;
    for (int n = 0; n < 2000; ++n) {
        const Vec2 xy(random.uniform(-0.045, 0.045), random.uniform(-0.045, 0.045));
        const SurfaceHeight at = surface.heightAt(xy);
        for (int axis = 0; axis < 2; ++axis) {
            const SurfaceHeight up = surface.heightAt(xy + h * Vec2::Unit(axis)),
                                down = surface.heightAt(xy - h * Vec2::Unit(axis));
            QVERIFY(std::abs((up.z_m - down.z_m) / (2 * h) - at.slope[axis]) < 1e-8);
            QVERIFY(((up.slope - down.slope) / (2 * h) - at.curvature_per_m.col(axis)).norm() <
                    0.02); // third derivative · h, at rims
        }
    }
}

void TestTissueSurface::footFollowsTheTool() {
    const TissueSurface surface(furrowedDome());
    core::Random random(35);
    constexpr double h = 1e-6;
    for (int n = 0; n < 2000; ++n) {
        const Vec2 xy(random.uniform(-0.04, 0.04), random.uniform(-0.04, 0.04));
        const Vec3 p = surface.pointAt(xy) - random.uniform(-0.004, 0.006) * surface.normalAt(xy);
        const SurfaceFoot foot = surface.nearest(p, xy);
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 slope = (surface.nearest(p + h * Vec3::Unit(axis), xy).p_W -
                                surface.nearest(p - h * Vec3::Unit(axis), xy).p_W) /
                               (2 * h);
            QVERIFY2((slope - foot.follows.col(axis)).norm() < 1e-4,
                     qPrintable(QString::number((slope - foot.follows.col(axis)).norm())));
        }
        QVERIFY((foot.follows - foot.follows.transpose()).norm() < 1e-12 &&
                (foot.follows * foot.normal).norm() < 1e-9);
    }
}

// A round dome h (1 − r²/R²)³ bends most at its top: 6 h/R²; a furrow of the same shape bends that much the
// other way.
void TestTissueSurface::deepestUniqueOfOneDome() {
    QVERIFY(TissueSurface(SurfaceShape{}).deepestUnique_m() == std::numeric_limits<double>::infinity());
    SurfaceShape dome;
    dome.bumps = {{Vec2(0.01, 0.02), Vec2(0.04, 0.04), 0.0, 0.012}};
    const double radius = 0.04 * 0.04 / (6.0 * 0.012);
    QVERIFY(std::abs(TissueSurface(dome).deepestUnique_m() / radius - 0.99) < 1e-9);
    dome.bumps[0].height_m = -0.012;
    QVERIFY(std::abs(TissueSurface(dome).highestUnique_m() / radius - 0.99) < 1e-9);
    // Just above that depth two guesses find one foot; well below it the point has several.
    dome.bumps[0].height_m = 0.012;
    const TissueSurface surface(dome);
    const Vec3 top(0.01, 0.02, 0.012);
    const Vec3 deep = top - Vec3(0, 0, 1.3 * radius);
    QVERIFY(
        (surface.nearest(deep, Vec2(0.02, 0.02)).p_W - surface.nearest(deep, Vec2(0.0, 0.02)).p_W).norm() >
        1e-3);
    const Vec3 safe = top - Vec3(0, 0, 0.95 * radius);
    QVERIFY(
        (surface.nearest(safe, Vec2(0.02, 0.02)).p_W - surface.nearest(safe, Vec2(0.0, 0.02)).p_W).norm() <
        1e-9);
}

void TestTissueSurface::rayMeetsTheSurface() {
    const TissueSurface surface(furrowedDome());
    core::Random random(36);
    int met = 0;
    for (int n = 0; n < 2000; ++n) {
        const Vec2 xy(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03));
        const Vec3 ray = (Vec3(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), -1.0)).normalized();
        Vec3 hit;
        if (!surface.meets(surface.pointAt(xy) + random.uniform(-0.005, 0.005) * ray, ray, hit))
            continue;
        ++met;
        QVERIFY(std::abs(hit.z() - surface.heightAt(hit.head<2>()).z_m) < 1e-12);
    }
    QVERIFY(met > 1990);
    Vec3 hit;
    QVERIFY(!surface.meets(Vec3(0, 0, 0.05), Vec3::UnitX(), hit)); // along the surface
}

void TestTissueSurface::signIsRightEverywhere() {
    SurfaceShape wild = furrowedDome(); // steep enough that feet are ambiguous a few millimetres away
    wild.bumps.push_back({Vec2(-0.01, 0.0), Vec2(0.008, 0.008), 0.0, 0.008});
    const TissueSurface surface(wild);
    QVERIFY(surface.deepestUnique_m() < 0.003);
    core::Random random(37);
    for (int n = 0; n < 50000; ++n) {
        const Vec3 p(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(-0.03, 0.04));
        const SurfaceFoot foot =
            surface.nearest(p, Vec2(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)));
        const double below = surface.heightAt(p.head<2>()).z_m - p.z();
        if (std::abs(below) < 1e-6)
            continue;
        QVERIFY(below > 0.0 ? foot.depth_m > 0.0 : foot.depth_m <= 0.0);
        QVERIFY(std::abs(foot.depth_m) <= std::abs(below) + 1e-9); // never farther than straight up or down
    }
}

void TestTissueSurface::punchWeightHasItsLimits() {
    for (const double nu : {0.3, 0.45, 0.5}) {
        double before = 0.0;
        for (int i = 0; i <= 4000; ++i) {
            const double now = punchWeight(1e-5 * i, 0.005, nu);
            QVERIFY(now >= before && now < 1.0);
            before = now;
        }
        QVERIFY(std::abs(punchWeight(1e3, 0.005, nu) - 1.0) < 1e-4 && punchWeight(0.0, 0.005, nu) == 0.0);
    }
    QVERIFY(std::abs(punchWeight(0.005, 0.005, 0.5) - (0.5 - 0.5 / core::kPi)) < 1e-15);
}

void TestTissueSurface::layersHaveTheirLimits() {
    const auto modulus = [](const std::vector<TissueLayer>& layers) {
        return layeredModulus_Pa(layers, 0.005, 0.5);
    };
    QVERIFY(std::abs(modulus({{"gland", 1.0, 17e3}}) - 17e3) < 1e-9);
    QVERIFY(std::abs(modulus({{"a", 0.002, 17e3}, {"b", 0.003, 17e3}, {"c", 1.0, 17e3}}) - 17e3) < 1e-8);
    QVERIFY(std::abs(modulus({{"thick", 5.0, 9e3}, {"below", 1.0, 30e3}}) / 9e3 - 1.0) < 1e-3);
    QVERIFY(std::abs(modulus({{"thin", 1e-7, 9e3}, {"below", 1.0, 30e3}}) / 30e3 - 1.0) < 1e-3);
    double before = 30e3;
    for (int i = 1; i < 200;
         ++i) { // a softer layer growing thicker: softer and softer, always between the two
        const double now = modulus({{"fat", 1e-4 * i, 10e3}, {"gland", 1.0, 30e3}});
        QVERIFY(now < before && now > 10e3);
        before = now;
    }
    // Cutting a layer in two changes nothing; the order of layers does.
    const double whole = modulus({{"skin", 0.002, 40e3}, {"fat", 0.006, 8e3}, {"gland", 1.0, 17e3}});
    QVERIFY(
        std::abs(
            modulus({{"skin", 0.002, 40e3}, {"fat", 0.001, 8e3}, {"fat", 0.005, 8e3}, {"gland", 1.0, 17e3}}) -
            whole) < 1e-9);
    QVERIFY(std::abs(modulus({{"skin", 0.002, 8e3}, {"fat", 0.006, 40e3}, {"gland", 1.0, 17e3}}) - whole) >
            1e3);
    // A rigid base under 5 mm: finite, 1/I₀(1) = 2.9 times the layer's own.
    QVERIFY(std::abs(modulus({{"film", 0.005, 17e3}, {"bone", 1.0, 1e15}}) / 17e3 -
                     1.0 / (0.5 - 0.5 / core::kPi)) < 1e-6);
    // The contact takes it: k = 2 a E/(1 − ν²).
    TissueParameters p;
    p.layers = {{"skin", 0.002, 40e3}, {"gland", 1.0, 17e3}};
    QVERIFY(std::abs(TissueContact(p).normalStiffness_N_per_m() - 2.0 * 0.005 * modulus(p.layers) / 0.75) <
            1e-9);
    p.stiffness_N_per_m = 650.0;
    QCOMPARE(TissueContact(p).normalStiffness_N_per_m(), 650.0);
}

QTEST_APPLESS_MAIN(TestTissueSurface)
#include "test_tissue_surface.moc"
