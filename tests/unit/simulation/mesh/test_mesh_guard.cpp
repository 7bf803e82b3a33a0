// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_shapes.h"
#include "realtime/tick_guard.h"
#include "simulation/geometry/mesh/mesh_contact.h"
#include "simulation/geometry/mesh/moved_mesh.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

/// A tick on a mesh allocates, locks and throws nothing: 10,000 of them, in and out of contact, jumping, on a
/// mesh that moves.
class TestMeshGuard : public QObject {
    Q_OBJECT

private slots:
    void nothingForbidden_data() {
        QTest::addColumn<bool>("moving");
        QTest::newRow("at rest") << false;
        QTest::newRow("moving") << true;
    }
    void nothingForbidden() {
        QFETCH(bool, moving);
        const TriangleMesh mesh = *makeMesh(bumpyOrgan(0.0015));
        ObjectAttributes attributes;
        attributes.friction = 0.4;
        attributes.roughness_m = 5e-5;
        attributes.recoveryShare = 1.0;
        attributes.recoveryTime_s = 0.2;
        const MeshContact contact(attributes, 0.001);
        MeshContactState state;
        MeshDents dents(mesh.vertices().size(), attributes.recoveryTime_s);
        const std::vector<CornerAngles> angles = cornerAngles(mesh);
        std::vector<Vec3> positions, normals(mesh.vertices().size());
        for (const SurfaceVertex& v : mesh.vertices())
            positions.push_back(v.position);
        smoothNormals(mesh, angles, positions, normals);
        core::Random random(6);
        Vec3 p(0.0, 0.0, 0.030);
        int touching = 0, followed = 0;
        tests::resetForbiddenCounts();
        for (std::uint64_t n = 0; n < 10'000; ++n) {
            p += (random.below(100) == 0 ? 5e-3 : 1e-4) *
                     Vec3(random.normal(), random.normal(), random.normal()) +
                 0.01 * (Vec3(0.0, 0.0, 0.024) - p);
            const tests::TickGuard guard;
            const MeshResponse r = moving ? contact.respond(MovedMesh(mesh, positions, normals, 1e-3), p,
                                                            Vec3::Zero(), n, state, &dents)
                                          : contact.respond(mesh, p, Vec3::Zero(), n, state, &dents);
            if (moving && n % 33 == 0)
                smoothNormals(mesh, angles, positions, normals);
            touching += r.contact.inContact ? 1 : 0;
            followed += r.foot.track == MeshTrack::followed ? 1 : 0;
        }
        const tests::ForbiddenCounts counts = tests::forbiddenCounts();
        QCOMPARE(counts.total(), std::uint64_t{0});
        QVERIFY(touching > 2'000 && touching < 9'999);
        QVERIFY(followed > 0); // the fallback was in it too
    }
};

QTEST_APPLESS_MAIN(TestMeshGuard)
#include "test_mesh_guard.moc"
