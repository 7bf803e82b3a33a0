// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_shapes.h"
#include "simulation/geometry/mesh/mesh_contact.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

constexpr double kThick_m = 0.003;
constexpr double kStep_m = 1e-5; // 10 mm/s

TriangleMesh made(const MeshShape& shape) {
    auto mesh = TriangleMesh::create(shape.vertices, shape.triangles);
    if (!mesh)
        qFatal("%s", mesh.error().message.c_str());
    return std::move(*mesh);
}

/// A tool on one mesh, moved in straight lines of 0.01 mm a tick; remembers the largest change of force in a
/// tick.
struct Tool {
    const TriangleMesh& mesh;
    MeshContact contact;
    MeshContactState state;
    MeshResponse now;
    Vec3 at;
    std::uint64_t tick = 0;
    double worstChange_N = 0.0;

    Tool(const TriangleMesh& m, const Vec3& start, double radius_m, double stiffness = 500.0)
        : mesh(m), contact(plain(stiffness), radius_m), at(start) {
        step(start);
    }
    static ObjectAttributes plain(double stiffness) {
        ObjectAttributes attributes;
        attributes.stiffness_N_per_m = stiffness;
        return attributes;
    }
    void step(const Vec3& p) {
        const Vec3 before = now.contact.force;
        now = contact.respond(mesh, p, Vec3::Zero(), tick++, state);
        worstChange_N = std::max(worstChange_N, (now.contact.force - before).norm());
        at = p;
    }
    void moveTo(const Vec3& p, const std::function<void()>& each = {}) {
        const Vec3 from = at;
        const int steps = std::max(1, static_cast<int>(std::ceil((p - from).norm() / kStep_m)));
        for (int i = 1; i <= steps; ++i) {
            step(from + (p - from) * (static_cast<double>(i) / steps));
            if (each)
                each();
        }
    }
};

} // namespace

/// Contact stays on the side that was entered, pressed to twice the thickness, until the tool leaves there.
class TestMeshThinParts : public QObject {
    Q_OBJECT

private slots:
    void plateThroughAndBack_data() {
        QTest::addColumn<double>("radius_m");
        QTest::newRow("point") << 0.0;
        QTest::newRow("1 mm") << 0.001;
    }
    void plateThroughAndBack() {
        QFETCH(double, radius_m);
        const TriangleMesh mesh = made(plate(0.030, kThick_m, 0.001));
        Tool tool(mesh, {0.0012, 0.0007, radius_m + 0.002}, radius_m);
        QVERIFY(!tool.now.contact.inContact);
        tool.moveTo({0.0012, 0.0007, radius_m - 2.0 * kThick_m});
        QVERIFY(tool.now.contact.inContact);
        QVERIFY((tool.now.contact.force - Vec3(0.0, 0.0, 500.0 * 2.0 * kThick_m)).norm() < 1e-6);
        // all over the middle, still through it: up, and as much as the depth
        for (const Vec3& corner : {Vec3(0.012, 0.0, 0.0), Vec3(0.012, 0.012, 0.0), Vec3(-0.012, -0.012, 0.0),
                                   Vec3(0.0012, 0.0007, 0.0)})
            tool.moveTo(corner + Vec3(0.0, 0.0, radius_m - 2.0 * kThick_m), [&] {
                QVERIFY((tool.now.contact.force - Vec3(0.0, 0.0, 500.0 * 2.0 * kThick_m)).norm() < 1e-6);
            });
        tool.moveTo({0.0012, 0.0007, radius_m + 0.0001});
        QVERIFY(!tool.now.contact.inContact);
        QVERIFY2(tool.worstChange_N <= 500.0 * kStep_m * 1.01,
                 qPrintable(QString::number(tool.worstChange_N)));
    }

    void plateFromBelow() {
        const TriangleMesh mesh = made(plate(0.030, kThick_m, 0.001));
        Tool tool(mesh, {0.0, 0.0003, -kThick_m - 0.003}, 0.001);
        tool.moveTo({0.0, 0.0003, -kThick_m - 0.001 + 2.0 * kThick_m});
        QVERIFY((tool.now.contact.force - Vec3(0.0, 0.0, -500.0 * 2.0 * kThick_m)).norm() < 1e-6);
        tool.moveTo({0.0, 0.0003, -kThick_m - 0.002});
        QVERIFY(!tool.now.contact.inContact);
    }

    /// Over the edge of the plate while pressed through it: the force turns and ends without a step, never
    /// pulls, and the far side is not felt.
    void overTheEdgeOfThePlate() {
        const TriangleMesh mesh = made(plate(0.030, kThick_m, 0.001));
        Tool tool(mesh, {0.0, 0.0003, 0.002}, 0.001);
        tool.moveTo({0.0, 0.0003, -0.005});
        double least = 1.0;
        tool.moveTo({0.025, 0.0003, -0.005}, [&] { least = std::min(least, tool.now.contact.force.z()); });
        QVERIFY2(least >= -1e-9, qPrintable(QString::number(least)));
        QVERIFY(!tool.now.contact.inContact);
        qInfo("largest change in 0.01 mm: %g N", tool.worstChange_N);
        QVERIFY2(tool.worstChange_N <= 0.2, qPrintable(QString::number(tool.worstChange_N)));
    }

    /// Edge-on: a plate with flat side, and one with a round rim of 1.5 mm pressed four times as deep as it
    /// is round.
    void rim_data() {
        QTest::addColumn<bool>("round");
        QTest::newRow("flat side") << false;
        QTest::newRow("round rim") << true;
    }
    void rim() {
        QFETCH(bool, round);
        const TriangleMesh mesh =
            made(round ? roundedPlate(kThick_m, 0.0003) : plate(0.060, kThick_m, 0.0005));
        const double middle = round ? 0.0 : -0.5 * kThick_m, edge = round ? 0.5 * kThick_m : 0.030;
        const double deep = 2.0 * kThick_m, radius_m = 0.001;
        Tool tool(mesh, {edge + 0.004, 1e-4, middle + 2e-5}, radius_m);
        double least = 1.0;
        tool.moveTo({edge + radius_m - deep, 1e-4, middle + 2e-5}, [&] {
            if (tool.now.contact.inContact)
                least = std::min(least, tool.now.contact.normal.x());
        });
        QVERIFY(tool.now.contact.inContact);
        QVERIFY2(least > 0.8,
                 qPrintable(QString::number(least))); // outward all the way in, though 20 µm off the middle
        QVERIFY2(std::abs(tool.now.contact.force.x() - 500.0 * deep) < 0.25 * 500.0 * deep,
                 qPrintable(QString::number(tool.now.contact.force.x())));
        const Vec3 still = tool.now.contact.force;
        for (int i = 0; i < 1000; ++i)
            tool.step(tool.at);
        QVERIFY((tool.now.contact.force - still).norm() < 1e-3); // a still tool is held still
        tool.moveTo({edge + 0.002, 1e-4, middle + 2e-5});
        QVERIFY(!tool.now.contact.inContact);
        qInfo("largest change in 0.01 mm: %g N", tool.worstChange_N);
        QVERIFY2(tool.worstChange_N <= 0.1, qPrintable(QString::number(tool.worstChange_N)));
    }

    /// A fold: from above through the upper leg and the gap into the lower leg; the upper one keeps the tool.
    void foldPressedThrough() {
        const double bend = 0.003;
        const TriangleMesh mesh = made(fold(bend, kThick_m, 0.0005));
        const double top = bend + 0.5 * kThick_m, radius_m = 0.001;
        Tool tool(mesh, {0.012, 0.0, top + 0.003}, radius_m);
        tool.moveTo({0.012, 0.0, top + radius_m - 2.0 * kThick_m});
        QVERIFY((tool.now.contact.force - Vec3(0.0, 0.0, 500.0 * 2.0 * kThick_m)).norm() < 1e-6);
        tool.moveTo({0.012, 0.0, top + 0.002});
        QVERIFY(!tool.now.contact.inContact);
        // and at the bend, from the side, twice its thickness: its inside is met at 1.5 mm radius
        tool.moveTo({-0.012, 0.0, top + 0.002});
        tool.moveTo({-0.012, 0.0, 1e-4});
        tool.moveTo({-top - radius_m + 2.0 * kThick_m, 0.0, 1e-4},
                    [&] { QVERIFY(!tool.now.contact.inContact || tool.now.contact.normal.x() < -0.8); });
        QVERIFY2(std::abs(tool.now.contact.force.x() + 500.0 * 2.0 * kThick_m) < 0.1 * 500.0 * 2.0 * kThick_m,
                 qPrintable(QString::number(tool.now.contact.force.x())));
        qInfo("largest change in 0.01 mm: %g N", tool.worstChange_N);
        QVERIFY2(tool.worstChange_N <= 0.1, qPrintable(QString::number(tool.worstChange_N)));
    }

    /// Between the legs of the fold: each wall is entered from its own side.
    void insideTheFold() {
        const double bend = 0.005;
        const TriangleMesh mesh = made(fold(bend, kThick_m, 0.0005));
        Tool tool(mesh, {0.040, 0.0, 0.0}, 0.001);
        tool.moveTo({0.012, 0.0, 0.0});
        QVERIFY(!tool.now.contact.inContact);
        tool.moveTo({0.012, 0.0, 0.004}); // the upper leg's inside is at 3.5 mm
        QVERIFY((tool.now.contact.force - Vec3(0.0, 0.0, -500.0 * 0.0015)).norm() < 1e-6);
        tool.moveTo({0.012, 0.0, -0.004});
        QVERIFY((tool.now.contact.force - Vec3(0.0, 0.0, 500.0 * 0.0015)).norm() < 1e-6);
    }

    /// Faster than the plate is thick a tick: it is entered where the way went in, not where the nearest side
    /// is.
    void fastThroughThePlate_data() {
        QTest::addColumn<double>("fall_m");
        QTest::newRow("to its lower half") << 0.0040;
        QTest::newRow("out below") << 0.0080;
    }
    void fastThroughThePlate() {
        QFETCH(double, fall_m);
        const TriangleMesh mesh = made(plate(0.030, kThick_m, 0.001));
        Tool tool(mesh, {0.0012, 0.0007, 0.0015}, 0.0);
        tool.step({0.0012, 0.0007, 0.0015 - fall_m});
        QVERIFY(tool.now.foot.track == MeshTrack::acquired);
        QVERIFY((tool.now.contact.force - Vec3(0.0, 0.0, 500.0 * (fall_m - 0.0015))).norm() < 1e-6);
    }
};

QTEST_APPLESS_MAIN(TestMeshThinParts)
#include "test_mesh_thin_parts.moc"
