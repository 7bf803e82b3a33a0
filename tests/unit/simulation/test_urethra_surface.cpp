// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "core/units.h"
#include "simulation/geometry/urethra/urethra_curve_net.h"
#include "simulation/geometry/urethra/urethra_surface.h"
#include "urethra_vertices.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

using namespace chiron;
using namespace chiron::tests;
using simulation::UrethraCurveNet;
using simulation::UrethraDeformation;
using simulation::UrethraMeshSettings;
using simulation::VertexRange;

namespace {

constexpr double kLength = 0.13922485126556;

/// Whether a vertex has the same bits in both.
bool sameVertex(const UrethraSurface& surface, const std::vector<float>& a, const std::vector<float>& b,
                std::size_t vertex) {
    for (std::size_t plane = 0; plane < 7; ++plane) {
        const std::size_t i = plane * surface.vertexCount() + vertex;
        if (std::memcmp(&a[i], &b[i], sizeof(float)) != 0)
            return false;
    }
    return true;
}

/// A section's own arc length where the vertex' rounded one is that of a section.
double unrounded(const UrethraCurveNet& net, double s) {
    for (const auto* curves : {&net.rest(), &net.deformed()})
        for (int i = 0; i < curves->sections(); ++i)
            if (std::abs(curves->s_m(i) - s) < 1.5e-8)
                return curves->s_m(i);
    return s;
}

UrethraDeformation wander(core::Random& random, UrethraDeformation at) {
    const std::uint64_t kind = random.below(20);
    if (kind == 0)
        return {random.below(2) == 0, random.uniform(-0.03, 0.18), random.uniform(-0.003, 0.003), 0.0};
    if (kind == 1)
        return {false, at.tip_s_m, at.ex_m, at.en_m};
    at.inside = true;
    if (kind < 14)
        at.tip_s_m += random.uniform(-0.0006, 0.0010);
    if (kind >= 10)
        at.ex_m += random.uniform(-2e-4, 2e-4);
    if (kind == 19)
        at.ex_m = at.en_m = 0.0;
    return at;
}

} // namespace

class TestUrethraSurface : public QObject {
    Q_OBJECT
private slots:
    void hasTheStatedLayout();
    void agreesWithTheCurves_data();
    void agreesWithTheCurves();
    void trianglesFaceTheLumen();
    void ringsRunFromEntranceToNeck();
    void beyondTheDeformationNoBitChanges();
    void updateEqualsRebuild();
    void updateRewritesWhatIsNearOnly();
};

void TestUrethraSurface::hasTheStatedLayout() {
    const UrethraSurface surface({}, {}, {});
    QCOMPARE(surface.ringSize(), std::size_t(128));
    QCOMPARE(surface.vertexCount(), std::size_t(25728 + 9 * 8 * 128)); // P1's rings and the moving sections'
    QCOMPARE(surface.plane(0).size(), surface.vertexCount());
    QCOMPARE(surface.arcLength_m().size(), surface.vertexCount());
    QCOMPARE(surface.triangles().size(), (surface.vertexCount() - 128) * 6);
    // every edge inside is shared by two triangles that run it in opposite directions; the two open ends have
    // 128 each
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    const auto triangles = surface.triangles();
    for (std::size_t t = 0; t < triangles.size(); t += 3)
        for (std::size_t i = 0; i < 3; ++i)
            ++edges[{triangles[t + i], triangles[t + (i + 1) % 3]}];
    std::size_t open = 0;
    for (const auto& [edge, count] : edges) {
        QCOMPARE(count, 1);
        open += edges.count({edge.second, edge.first}) == 0 ? 1 : 0;
    }
    QCOMPARE(open, std::size_t(256));
}

// Positions to the rounding of float at 0.14 m, normals to 0.06 degrees, edges included; sides of whole
// vector blocks and of parts of them.
void TestUrethraSurface::agreesWithTheCurves_data() {
    QTest::addColumn<int>("n");
    QTest::addColumn<int>("perPatch");
    QTest::newRow("P1's") << 17 << 8;
    QTest::newRow("5 a side") << 12 << 5;
    QTest::newRow("16 a side") << 9 << 16;
    QTest::newRow("19 a side") << 17 << 19;
    QTest::newRow("1 a side") << 33 << 1;
}

void TestUrethraSurface::agreesWithTheCurves() {
    QFETCH(int, n);
    QFETCH(int, perPatch);
    const UrethraMeshSettings mesh{n, 26, perPatch, 9};
    UrethraSurface surface({}, {}, mesh);
    UrethraCurveNet net({}, {}, mesh);
    const std::vector<UrethraDeformation> tips{{},
                                               {true, 0.0533, 0.001, -0.002},
                                               {true, -0.004, 0.0, 0.0},
                                               {true, 0.1, 0.0, 0.0},
                                               {true, 0.137, 0.001, 0.001},
                                               {true, 0.155, -0.001, 0.001}};
    for (const UrethraDeformation& tip : tips) {
        surface.update(tip);
        net.deform(tip);
        const std::size_t ring = surface.ringSize();
        double s = -1.0;
        for (std::size_t v = 0; v < surface.vertexCount(); ++v) {
            if (v % ring == 0)
                s = unrounded(net, surface.arcLength_m()[v]);
            const auto exact =
                net.at(s, 2.0 * core::kPi * static_cast<double>(v % ring) / static_cast<double>(ring));
            QVERIFY((position(surface, v) - exact.p_A).norm() < 3e-8);
            QVERIFY2((normalOf(surface, v) - exact.n_A).norm() < 1e-3,
                     qPrintable(QString::number(s, 'g', 12)));
        }
    }
}

void TestUrethraSurface::trianglesFaceTheLumen() {
    UrethraSurface surface({}, {}, {});
    const simulation::UrethraCentreline line(13.0, 0.0877);
    for (const double tip : {-1.0, -0.005, 0.0601, 0.1363, 0.16}) {
        surface.update({tip > -1.0, tip, 0.0, 0.0});
        std::size_t real = 0;
        const auto triangles = surface.triangles();
        for (std::size_t t = 0; t < triangles.size(); t += 3) {
            const Vec3 a = position(surface, triangles[t]);
            const Vec3 b = position(surface, triangles[t + 1]);
            const Vec3 c = position(surface, triangles[t + 2]);
            const Vec3 front = (b - a).cross(c - a);
            if (front.norm() < 1e-10) // collapsed, or between sections a micrometre apart
                continue;
            ++real;
            const Vec3 middle = (a + b + c) / 3.0;
            const auto foot = line.foot(middle);
            QVERIFY(front.dot(foot.at.p_A - middle) > 0.0);
            for (std::size_t i = 0; i < 3; ++i)
                QVERIFY(normalOf(surface, triangles[t + i]).dot(front) > 0.9 * front.norm());
        }
        QVERIFY(real >= 25600 * 2);
    }
}

void TestUrethraSurface::ringsRunFromEntranceToNeck() {
    UrethraSurface surface({}, {}, {});
    for (double tip = -0.02; tip < 0.17; tip += 0.0013) {
        surface.update({true, tip, 0.0005, 0.0});
        const auto s = surface.arcLength_m();
        for (std::size_t v = 128; v < s.size(); v += 128)
            QVERIFY(s[v] >= s[v - 128]);
        QCOMPARE(s.front(), 0.0F);
        QVERIFY(std::abs(s.back() - kLength) < 1e-8);
    }
}

void TestUrethraSurface::beyondTheDeformationNoBitChanges() {
    UrethraSurface surface({}, {}, {});
    const std::vector<float> rest = contents(surface);
    core::Random random(3);
    std::size_t untouched = 0;
    for (int i = 0; i < 300; ++i) {
        const UrethraDeformation tip{true, random.uniform(-0.012, 0.135), i % 3 == 0 ? 0.0 : 0.002,
                                     i % 2 == 0 ? 0.0 : -0.001};
        surface.update(tip);
        const std::vector<float> now = contents(surface);
        for (std::size_t v = 0; v < surface.vertexCount(); ++v)
            if (surface.arcLength_m()[v] > tip.tip_s_m + 0.010 + 1e-8) {
                ++untouched;
                QVERIFY2(sameVertex(surface, now, rest, v), qPrintable(QString::number(v)));
            }
        // and none of its rings is missing: the first lies within a ring's distance of the end
        const auto s = surface.arcLength_m();
        const auto beyond =
            std::find_if(s.begin(), s.end(), [&](float at) { return at > tip.tip_s_m + 0.010; });
        QVERIFY(beyond == s.end() || *beyond < std::max(0.0, tip.tip_s_m + 0.010) + 0.0012);
    }
    QVERIFY(untouched > 1000000);
    surface.update({});
    QVERIFY(sameBits(contents(surface), rest)); // and out again
}

void TestUrethraSurface::updateEqualsRebuild() {
    for (const UrethraMeshSettings& mesh : {UrethraMeshSettings{}, UrethraMeshSettings{12, 31, 5, 6}}) {
        UrethraSurface walked({}, {}, mesh);
        UrethraSurface built({}, {}, mesh);
        core::Random random(4);
        UrethraDeformation tip{true, -0.02, 0.0, 0.0};
        std::vector<float> before = contents(walked);
        for (int i = 0; i < 500; ++i) {
            tip = wander(random, tip);
            std::vector<bool> reported(walked.vertexCount());
            std::size_t end = 0;
            for (const VertexRange& range : walked.update(tip)) {
                QVERIFY(range.count > 0 && (end == 0 || range.first > end)); // ascending, apart
                end = range.first + range.count;
                QVERIFY(end <= walked.vertexCount());
                std::fill_n(reported.begin() + static_cast<std::ptrdiff_t>(range.first), range.count, true);
            }
            built.rebuild(tip);
            const std::vector<float> now = contents(walked);
            QVERIFY2(sameBits(now, contents(built)), qPrintable(QString::number(i)));
            for (std::size_t v = 0; v < walked.vertexCount(); ++v)
                QVERIFY(reported[v] || sameVertex(walked, now, before, v));
            before = now;
        }
    }
}

void TestUrethraSurface::updateRewritesWhatIsNearOnly() {
    UrethraSurface surface({}, {}, {});
    QVERIFY(surface.update({}).empty());
    surface.update({true, 0.0600, 0.0, 0.0});
    QVERIFY(surface.update({true, 0.0600, 0.0, 0.0}).empty());
    double at = 0.0600;
    for (int step = 0; step < 300; ++step) {
        const std::vector<float> before(surface.arcLength_m().begin(), surface.arcLength_m().end());
        const auto ranges = surface.update({true, at += 1e-4, 0.0, 0.0});
        QVERIFY(!ranges.empty());
        std::size_t rewritten = 0;
        for (const VertexRange& range : ranges) {
            rewritten += range.count;
            for (std::size_t v = range.first; v < range.first + range.count; ++v) {
                // up to three spans of at most 8.4 mm behind the tip, one ring beyond the end
                QVERIFY(surface.arcLength_m()[v] > at - 0.0255 && surface.arcLength_m()[v] < at + 0.0112);
                QVERIFY(before[v] > at - 0.0255 && before[v] < at + 0.0112);
            }
        }
        QVERIFY(rewritten < surface.vertexCount() / 2);
    }
    // far from the tip an offset moves nothing either
    for (const VertexRange& range : surface.update({true, at, 0.0, 0.001}))
        for (std::size_t v = range.first; v < range.first + range.count; ++v)
            QVERIFY(surface.arcLength_m()[v] > at - 0.040 - 0.017 && surface.arcLength_m()[v] < at + 0.0112);
    surface.update({true, 0.2, 0.0, 0.0}); // wholly beyond C nothing moves any more
    QVERIFY(surface.update({true, 0.21, 0.0, 0.0}).empty());
}

QTEST_APPLESS_MAIN(TestUrethraSurface)
#include "test_urethra_surface.moc"
