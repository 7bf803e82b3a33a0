// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_shapes.h"
#include "simulation/geometry/mesh/mesh_contact.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

constexpr double kStiffness = 500.0;

ObjectAttributes plain() {
    ObjectAttributes attributes;
    attributes.stiffness_N_per_m = kStiffness;
    attributes.damping_Ns_per_m = 0.0;
    return attributes;
}

double angle(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace

/// The force of a mesh: closed form, agreement with looking everywhere, continuity, no snag.
class TestMeshContact : public QObject {
    Q_OBJECT

private slots:
    /// A ball cut into 50,000 triangles against the ball itself: f = k (R + r − ρ) p/ρ.
    void sphereInClosedForm() {
        const double R = 0.020, r = 0.001, edge = 0.0003;
        const TriangleMesh mesh = *makeMesh(ellipsoid(R, R, R, edge));
        const MeshContact contact(plain(), r);
        core::Random random(5);
        const double sag = edge * edge / (6.0 * R); // of a facet's middle under the ball, and then some
        int inside = 0;
        for (int i = 0; i < 3000; ++i) {
            MeshContactState state;
            const Vec3 direction = Vec3(random.normal(), random.normal(), random.normal()).normalized();
            const double depth = random.uniform(-0.002, 0.010);
            const MeshResponse response =
                contact.respond(mesh, (R + r - depth) * direction, Vec3::Zero(), 0, state);
            if (depth < -sag) {
                QVERIFY(!response.contact.inContact && response.contact.force.isZero());
                continue;
            }
            if (depth < sag)
                continue;
            ++inside;
            QVERIFY2((response.contact.force - kStiffness * depth * direction).norm() <
                         kStiffness * (2.0 * sag + 2e-4 * depth),
                     qPrintable(QString("%1 at %2")
                                    .arg((response.contact.force - kStiffness * depth * direction).norm())
                                    .arg(depth)));
            QVERIFY(angle(response.contact.normal, direction) < 3e-4);
            QVERIFY(std::abs(response.contact.energy_J - 0.5 * kStiffness * depth * depth) <
                    kStiffness * depth * 3.0 * sag);
            QVERIFY((response.surfaced - (R + r) * direction).norm() < 1e-5);
        }
        QVERIFY(inside > 2000);
    }

    /// Wherever the tool is nearer to the sheet than half the part's thickness: ≤ 0.2 N from looking at every
    /// triangle.
    void agreesWithBruteForce_data() {
        QTest::addColumn<double>("press_m");
        QTest::addColumn<double>("radius_m");
        QTest::addColumn<double>("edge_m");
        QTest::addColumn<int>("ticks");
        QTest::newRow("0.5 mm, tool of 1 mm") << 0.0005 << 0.001 << 0.0007 << 5'000;
        QTest::newRow("2 mm, tool of 1 mm") << 0.002 << 0.001 << 0.0007 << 5'000;
        QTest::newRow("4 mm, tool of 1 mm") << 0.004 << 0.001 << 0.0007 << 5'000;
        QTest::newRow("4 mm, point") << 0.004 << 0.0 << 0.0007 << 7'000;
        // what looking everywhere says turns by whole facets: as deep as this only a finer mesh says it to
        // 0.2 N
        QTest::newRow("6 mm, point, 130,000 triangles") << 0.006 << 0.0 << 0.00043 << 4'000;
    }
    void agreesWithBruteForce() {
        QFETCH(double, press_m);
        QFETCH(double, radius_m);
        QFETCH(double, edge_m);
        QFETCH(int, ticks);
        const TriangleMesh mesh = *makeMesh(bumpyOrgan(edge_m));
        BruteForce brute(mesh);
        const std::vector<Vec3> path =
            strokes(brute, mesh, Vec3(0.040, 0.030, 0.025), 11, ticks, radius_m, press_m, 0.0005);
        const MeshContact contact(plain(), radius_m);
        MeshContactState state;
        double worst = 0.0;
        // past the bumps' roundness and back the foot has to catch up: there from nine tenths of it, and only
        // where it is tracked
        const double share = press_m > 0.005 ? 0.9 : 1.0;
        int compared = 0, thin = 0, followed = 0;
        for (std::size_t n = 0; n < path.size(); ++n) {
            const MeshResponse mine = contact.respond(mesh, path[n], Vec3::Zero(), n, state);
            const MeshPlace place = brute.nearest(path[n]);
            const Vec3 way = pointAt(mesh, place) - path[n];
            const bool inside = way.dot(pseudoNormal(mesh, place)) > 0.0;
            const double depth = (inside ? 1.0 : -1.0) * way.norm() + radius_m;
            followed += mine.foot.track == MeshTrack::followed ? 1 : 0;
            const double below = mine.foot.depth_m - radius_m; // of the centre
            if (mine.foot.within() && below > 0.0 &&
                below >=
                    share * brute.halfThickness(mine.foot.point, mine.foot.normal, 2.0 * mesh.meanEdge_m())) {
                ++thin;
                continue;
            }
            if (share < 1.0 && mine.foot.track == MeshTrack::followed)
                continue;
            ++compared;
            const Vec3 theirs = depth > 0.0 && way.norm() > 1e-6
                                    ? Vec3(kStiffness * depth * (inside ? 1.0 : -1.0) * way.normalized())
                                    : Vec3(kStiffness * std::max(0.0, depth) * mine.contact.normal);
            worst = std::max(worst, (mine.contact.force - theirs).norm());
        }
        qInfo("%d ticks compared, worst %.3f N; %d too deep for the part; %d followed", compared, worst, thin,
              followed);
        QVERIFY(compared > ticks - ticks / 4); // over 20,000 in all
        QVERIFY2(worst <= 0.2, qPrintable(QString::number(worst)));
    }

    /// Direction and force along random smooth paths, at several depths: a bounded change per 0.01 mm.
    void directionIsContinuous_data() {
        QTest::addColumn<double>("depth_m");
        QTest::addColumn<double>("degrees");
        QTest::newRow("skin") << 0.0003 << 0.5;
        QTest::newRow("1 mm") << 0.001 << 0.5;
        QTest::newRow("2 mm") << 0.002 << 1.0;
        QTest::newRow("as deep as the bumps are round") << 0.004 << 3.0;
        QTest::newRow("deeper") << 0.006 << 3.0;
    }
    void directionIsContinuous() {
        QFETCH(double, depth_m);
        QFETCH(double, degrees);
        const TriangleMesh mesh = *makeMesh(bumpyOrgan());
        const MeshContact contact(plain(), 0.001);
        double worst = 0.0, worstForce = 0.0, worstOfAFacet = 0.0;
        int crossings = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            core::Random random(seed);
            const Vec3 axes(0.040, 0.030, 0.025);
            const Vec3 pole = Vec3(random.normal(), random.normal(), random.normal()).normalized(),
                       side = pole.unitOrthogonal(), third = pole.cross(side);
            MeshContactState state;
            Vec3 before = Vec3::Zero(), force = Vec3::Zero();
            std::uint32_t triangle = 0;
            // down to depth on the way (not faster than 0.01 mm a tick), then along an ellipse under the
            // skin, waving
            for (int n = 0; n < 5'000; ++n) {
                const double s = n < 1000 ? 0.0 : 1e-5 * (n - 1000) / 0.032, sink = std::min(1.0, n / 1000.0);
                const Vec3 on = (std::cos(s) * pole + std::sin(s) * side + 0.2 * std::sin(3.0 * s) * third)
                                    .normalized()
                                    .cwiseProduct(axes);
                const Vec3 out = on.cwiseQuotient(axes.cwiseProduct(axes)).normalized();
                const Vec3 p = on + (0.002 - sink * (0.001 + depth_m)) * out;
                const MeshResponse now =
                    contact.respond(mesh, p, Vec3::Zero(), static_cast<std::uint64_t>(n), state);
                if (now.contact.inContact && before != Vec3::Zero()) {
                    worst = std::max(worst, angle(before, now.contact.normal));
                    worstForce = std::max(worstForce, (now.contact.force - force).norm());
                    if (now.foot.place.triangle != triangle) {
                        ++crossings;
                        worstOfAFacet = std::max(worstOfAFacet, angle(facet(mesh, triangle),
                                                                      facet(mesh, now.foot.place.triangle)));
                    }
                }
                before = now.contact.inContact ? now.contact.normal : Vec3::Zero();
                force = now.contact.force;
                triangle = now.foot.place.triangle;
            }
        }
        qInfo("worst turn in 0.01 mm: %.3f degrees, %.4f N; of facet normals %.1f degrees; %d edges crossed",
              core::degFromRad(worst), worstForce, core::degFromRad(worstOfAFacet), crossings);
        QVERIFY(crossings > 100);
        QVERIFY2(core::degFromRad(worst) <= degrees, qPrintable(QString::number(core::degFromRad(worst))));
        QVERIFY(worstOfAFacet > worst); // facets would have stepped
    }

    /// A straight frictionless stroke over bumps: the foot goes on and never back, and the sideways force is
    /// that of the slope.
    void straightStrokeDoesNotSnag() {
        const TriangleMesh mesh = *makeMesh(bumpyOrgan());
        const MeshContact contact(plain(), 0.001);
        for (const double y : {-0.008, -0.0031, 0.0004, 0.0063}) {
            MeshContactState state;
            double before = -1.0, sideways = 0.0, climb = 0.0;
            int reversals = 0, ticks = 0;
            for (int n = 0; n < 4'000; ++n) { // 40 mm along x, 1 mm under the ellipsoid's top
                const double x = -0.020 + 1e-5 * n;
                const double z = 0.025 * std::sqrt(1.0 - x * x / 0.0016 - y * y / 0.0009) + 0.001 - 0.0015;
                const MeshResponse now =
                    contact.respond(mesh, {x, y, z}, Vec3::Zero(), static_cast<std::uint64_t>(n), state);
                if (!now.contact.inContact) {
                    before = -1.0;
                    continue;
                }
                ++ticks;
                if (before > -1.0 && now.foot.point.x() < before)
                    ++reversals;
                before = now.foot.point.x();
                sideways = std::max(sideways, std::abs(now.contact.force.x()));
                const Vec3 slope = now.contact.force.normalized() - now.foot.normal;
                climb = std::max(climb, slope.norm());
            }
            QVERIFY(ticks > 3'000);
            QCOMPARE(reversals, 0);
            QVERIFY(climb < 1e-9);    // nothing but the surface's slope pushes sideways
            QVERIFY(sideways > 0.02); // and the bumps do
        }
    }

    /// Force from damping, friction, roughness and dents arrives through the object's attributes.
    void attributesAreFelt() {
        const TriangleMesh mesh = *makeMesh(ellipsoid(0.020, 0.020, 0.020, 0.001));
        ObjectAttributes attributes = plain();
        attributes.friction = 0.4;
        const MeshContact rubs(attributes, 0.001);
        MeshContactState state;
        MeshResponse now;
        for (int n = 0; n < 3'000; ++n)
            now = rubs.respond(mesh, {2e-6 * (n - 1500), 0.0, 0.019}, Vec3::Zero(),
                               static_cast<std::uint64_t>(n), state);
        QVERIFY(now.contact.normalForce_N > 0.1);
        QVERIFY(std::abs(now.contact.friction.norm() - 0.4 * now.contact.normalForce_N) <
                0.01 * now.contact.normalForce_N);
        QVERIFY(now.contact.friction.x() < 0.0);
        attributes = plain();
        attributes.roughness_m = 0.0001;
        const MeshContact rough(attributes, 0.001);
        double low = 1.0, high = 0.0;
        state.reset();
        for (int n = 0; n < 3'000; ++n) {
            const double a = 1e-5 * (n - 1500) / 0.019;
            now = rough.respond(mesh, 0.0195 * Vec3(std::sin(a), 0.0, std::cos(a)), Vec3::Zero(),
                                static_cast<std::uint64_t>(n), state);
            low = std::min(low, now.contact.normalForce_N);
            high = std::max(high, now.contact.normalForce_N);
        }
        QVERIFY(high - low > 0.05);
    }

    /// A lasting press gives way with τ and comes back with τ, at the place where it was made and nowhere
    /// else.
    void dentsStayWhereTheyWerePressed() {
        const TriangleMesh mesh = *makeMesh(ellipsoid(0.020, 0.020, 0.020, 0.001));
        ObjectAttributes attributes = plain();
        attributes.recoveryShare = 1.0;
        attributes.recoveryTime_s = 0.2;
        const MeshContact contact(attributes, 0.001);
        MeshDents dents(mesh.vertices().size(), attributes.recoveryTime_s);
        MeshContactState state;
        const Vec3 here(0.0, 0.0, 0.019), there(0.019, 0.0, 0.0), away(0.0, 0.0, 0.030);
        std::uint64_t tick = 0;
        const auto press = [&](const Vec3& p) {
            return contact.respond(mesh, p, Vec3::Zero(), tick++, state, &dents).contact.normalForce_N;
        };
        const double quick = press(here);
        double slow = 0.0;
        for (int n = 0; n < 2'000; ++n)
            slow = press(here);
        const double depth = 0.002;
        QVERIFY(std::abs(quick - 2.0 * kStiffness * depth) < 0.03);
        QVERIFY(std::abs(slow - kStiffness * depth) < 0.03);
        press(away);
        QVERIFY(std::abs(press(there) - 2.0 * kStiffness * depth) < 0.03); // fresh
        press(away);
        const double soon = press(here); // the dent is still there
        QVERIFY2(soon < 1.05 * kStiffness * depth, qPrintable(QString::number(soon)));
        press(away);
        tick += 200; // one time constant: what had given way has come back by 1 − 1/e
        const double later = press(here);
        QVERIFY2(std::abs(later - kStiffness * depth * (2.0 - std::exp(-1.0))) < 0.05,
                 qPrintable(QString::number(later)));
    }
};

QTEST_APPLESS_MAIN(TestMeshContact)
#include "test_mesh_contact.moc"
