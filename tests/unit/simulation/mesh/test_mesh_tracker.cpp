// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_shapes.h"
#include "simulation/geometry/mesh/mesh_contact.h"
#include "simulation/geometry/mesh/moved_mesh.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

ObjectAttributes plain() {
    ObjectAttributes attributes;
    attributes.damping_Ns_per_m = 0.0;
    return attributes;
}

} // namespace

/// Contact found, kept, lost and found again; on meshes at rest and on the move.
class TestMeshTracker : public QObject {
    Q_OBJECT

private slots:
    /// A tool that comes and goes at random, at any speed: no contact is missed and none is invented.
    void comesAndGoes_data() {
        QTest::addColumn<double>("speed_m");
        QTest::newRow("20 mm/s") << 2e-5;
        QTest::newRow("0.5 m/s") << 5e-4;
        QTest::newRow("1 m/s, where the supervisor stops it") << 1e-3;
    }
    void comesAndGoes() {
        QFETCH(double, speed_m);
        const TriangleMesh mesh = *makeMesh(bumpyOrgan(0.0015));
        const double radius_m = 0.001;
        MeshTracker tracker;
        core::Random random(8);
        Vec3 p(0.0, 0.0, 0.040), v = Vec3::Zero();
        int began = 0, searched = 0, touching = 0;
        bool was = false;
        for (int n = 0; n < 20'000; ++n) {
            // drawn towards a shell 4 mm about the surface, pushed about
            const NearestOnMesh truth = nearestOnMesh(mesh, p);
            const Vec3 out = (p - truth.point).normalized() * (truth.signedDistance_m < 0.0 ? -1.0 : 1.0);
            v = 0.95 * v + 0.2 * speed_m * Vec3(random.normal(), random.normal(), random.normal());
            if (std::abs(truth.signedDistance_m) > 0.004)
                v -= 0.3 * speed_m * (truth.signedDistance_m > 0.0 ? 1.0 : -1.0) * out;
            if (v.norm() > speed_m)
                v *= speed_m / v.norm();
            p += v;
            const MeshFoot foot = tracker.update(mesh, p, radius_m);
            const double depth = radius_m - nearestOnMesh(mesh, p).signedDistance_m;
            if (depth > 2e-5 && !foot.within())
                QFAIL(qPrintable(QString("missed %1 mm at tick %2").arg(1e3 * depth).arg(n)));
            // a foot that lags behind a fast tool may hold it a little longer
            if (depth < -(2e-5 + 2.0 * speed_m) && foot.within())
                QFAIL(qPrintable(QString("invented, %1 mm away at tick %2").arg(-1e3 * depth).arg(n)));
            began += foot.within() && !was ? 1 : 0;
            touching += foot.within() ? 1 : 0;
            searched += foot.track == MeshTrack::acquired ? 1 : 0;
            was = foot.within();
        }
        qInfo("%d contacts, %d ticks of them, %d found in the whole mesh", began, touching, searched);
        QVERIFY(began > 1 && touching > 2'000);
        QVERIFY(searched <= began + touching / 20); // else it is kept by walking
    }

    /// Jumps: while in contact by a few millimetres, and from anywhere to anywhere.
    void jumpsAndTeleports() {
        const TriangleMesh mesh = *makeMesh(bumpyOrgan(0.0015));
        BruteForce brute(mesh);
        const MeshContact contact(plain(), 0.001);
        MeshContactState state;
        core::Random random(12);
        for (std::uint64_t n = 0; n < 3'000; ++n) {
            Vec3 direction(random.normal(), random.normal(), random.normal());
            direction.normalize();
            const Vec3 on = direction.cwiseProduct(Vec3(0.040, 0.030, 0.025));
            if (n % 3 == 0) // in the middle of nowhere, then back: each place is a jump of more than 20 mm
                (void)contact.respond(mesh, 3.0 * on, Vec3::Zero(), n, state);
            const MeshPlace nearest = brute.nearest(on);
            const Vec3 p = pointAt(mesh, nearest) - 0.0005 * normalAt(mesh, nearest);
            // out of the mesh's reach first, so that the way does not count
            state.tracker.reset();
            const MeshResponse response = contact.respond(mesh, p, Vec3::Zero(), n, state);
            QVERIFY(response.foot.track == MeshTrack::acquired);
            QVERIFY((response.contact.force - 500.0 * 0.0015 * normalAt(mesh, nearest)).norm() < 0.05);
            const Vec3 beside = p + 0.002 * response.foot.normal.unitOrthogonal(); // 2 m/s
            const MeshResponse after = contact.respond(mesh, beside, Vec3::Zero(), n, state);
            const MeshPlace there = brute.nearest(beside);
            const double depth =
                0.001 + (pointAt(mesh, there) - beside).dot(pseudoNormal(mesh, there).normalized());
            QVERIFY(depth < 5e-5 ||
                    (after.contact.inContact && std::abs(after.contact.depth_m - depth) < 3e-4));
        }
        // a jump of more than 20 mm while in contact: no walk, found anew
        state.reset();
        (void)contact.respond(mesh, {0.0, 0.0, 0.0245}, Vec3::Zero(), 0, state);
        const MeshResponse other = contact.respond(mesh, {0.0, 0.0, -0.0245}, Vec3::Zero(), 1, state);
        QVERIFY(other.foot.track == MeshTrack::acquired && other.contact.normal.z() < -0.8);
    }

    /// After an answer D nothing is asked of the tree within D: told by the foot, which stays apart at no
    /// cost.
    void safeDistanceHolds() {
        const TriangleMesh mesh = *makeMesh(ellipsoid(0.020, 0.020, 0.020, 0.001));
        MeshTracker tracker;
        QVERIFY(!tracker.update(mesh, {0.0, 0.0, 0.050}, 0.0).within());
        for (int n = 0; n < 30'000; ++n) {
            const double z = 0.050 - 1e-6 * n;
            const MeshFoot foot = tracker.update(mesh, {0.0, 0.0, z}, 0.0);
            QVERIFY(!foot.within());
            QVERIFY(-foot.depth_m <= z - 0.020 + 1e-5); // what is said to be clear is clear
        }
    }

    /// A mesh that moves as a whole under a tool that moves with it gives the same force; the bristle goes
    /// along.
    void movesWithTheMesh() {
        const TriangleMesh mesh = *makeMesh(bumpyOrgan(0.0015));
        std::vector<Vec3> positions, normals;
        for (const SurfaceVertex& v : mesh.vertices()) {
            positions.push_back(v.position);
            normals.push_back(v.normal);
        }
        ObjectAttributes attributes = plain();
        attributes.friction = 0.5;
        const MeshContact contact(attributes, 0.001);
        MeshContactState still, moving;
        for (std::uint64_t n = 0; n < 2'000; ++n) {
            const Vec3 p(1e-6 * static_cast<double>(n), 0.0, 0.0248),
                shift = 0.008 * Vec3(std::sin(0.004 * static_cast<double>(n)), 0.3, 0.1);
            for (std::size_t v = 0; v < positions.size(); ++v)
                positions[v] = mesh.vertices()[v].position + shift;
            const MeshResponse a = contact.respond(mesh, p, Vec3::Zero(), n, still);
            const Vec3 drift = n == 0 ? Vec3::Zero()
                                      : Vec3(8.0 * (std::sin(0.004 * static_cast<double>(n)) -
                                                    std::sin(0.004 * static_cast<double>(n - 1))),
                                             0.0, 0.0);
            const MeshResponse b = contact.respond(MovedMesh(mesh, positions, normals, shift.norm()),
                                                   p + shift, drift, n, moving);
            QVERIFY2((a.contact.force - b.contact.force).norm() < 1e-4,
                     qPrintable(QString("%1 at %2").arg((a.contact.force - b.contact.force).norm()).arg(n)));
            QVERIFY((a.foot.point + shift - b.foot.point).norm() < 1e-6);
        }
        QVERIFY(still.object.bristle.stretch().norm() > 1e-5);
    }

    /// A surface that comes up to a tool that stands still touches it, and lets go when it sinks again.
    void aRisingSurfaceTouchesAStillTool() {
        const TriangleMesh mesh = *makeMesh(ellipsoid(0.020, 0.020, 0.020, 0.001));
        const std::vector<CornerAngles> angles = cornerAngles(mesh);
        std::vector<Vec3> positions(mesh.vertices().size()), normals(mesh.vertices().size());
        const MeshContact contact(plain(), 0.001);
        MeshContactState state;
        double most = 0.0;
        for (std::uint64_t n = 0; n <= 2'000; ++n) {
            const double rise = 0.004 * std::sin(core::kPi * static_cast<double>(n) / 2'000.0);
            for (std::size_t v = 0; v < positions.size(); ++v) {
                const Vec3& x = mesh.vertices()[v].position;
                positions[v] = x + std::max(0.0, x.z() / 0.020) * rise * Vec3::UnitZ();
            }
            smoothNormals(mesh, angles, positions, normals);
            const MeshResponse now = contact.respond(MovedMesh(mesh, positions, normals, rise),
                                                     {0.0, 0.0, 0.023}, Vec3::Zero(), n, state);
            const double depth = rise - 0.002;
            QVERIFY(std::abs(now.contact.force.z() - 500.0 * std::max(0.0, depth)) < 0.02);
            most = std::max(most, now.contact.force.z());
        }
        QVERIFY(most > 0.9);
        QVERIFY(!state.tracker.foot().within());
    }

    /// Smooth normals of unmoved vertices are those of the mesh.
    void smoothNormalsAgree() {
        const TriangleMesh mesh = *makeMesh(bumpyDome());
        const std::vector<CornerAngles> angles = cornerAngles(mesh);
        std::vector<Vec3> positions, normals(mesh.vertices().size());
        for (const SurfaceVertex& v : mesh.vertices())
            positions.push_back(v.position);
        smoothNormals(mesh, angles, positions, normals);
        for (std::size_t v = 0; v < normals.size(); ++v)
            QVERIFY((normals[v] - mesh.vertices()[v].normal).norm() < 1e-12);
    }

    void sameInputsSameBits() {
        const TriangleMesh a = *makeMesh(bumpyOrgan(0.002)), b = *makeMesh(bumpyOrgan(0.002));
        ObjectAttributes attributes;
        attributes.friction = 0.3;
        attributes.roughness_m = 5e-5;
        attributes.recoveryShare = 0.5;
        attributes.recoveryTime_s = 0.3;
        const MeshContact contact(attributes, 0.001);
        MeshContactState first, second;
        MeshDents one(a.vertices().size(), 0.3), two(b.vertices().size(), 0.3);
        core::Random random(2);
        Vec3 p(0.0, 0.0, 0.026);
        for (std::uint64_t n = 0; n < 10'000; ++n) {
            p += 2e-5 * Vec3(random.normal(), random.normal(), random.normal()) +
                 0.01 * (Vec3(0.0, 0.0, 0.0255) - p);
            const Vec3 f = contact.respond(a, p, Vec3::Zero(), n, first, &one).contact.force,
                       g = contact.respond(b, p, Vec3::Zero(), n, second, &two).contact.force;
            QVERIFY(f == g);
        }
    }

    /// Nothing that a tool may do gives a number that is none, or a pull.
    void anyMotionGivesAForceThatPushes() {
        ObjectAttributes attributes = plain();
        attributes.damping_Ns_per_m = 5.0;
        for (const MeshSource& source :
             {bumpyOrgan(0.002), bumpyDome(), ellipsoid(0.030, 0.030, 0.0015, 0.001)}) {
            const TriangleMesh mesh = *makeMesh(source);
            const MeshContact contact(attributes, 0.0005);
            MeshContactState state;
            core::Random random(77);
            Vec3 p = Vec3::Zero();
            for (std::uint64_t n = 0; n < 20'000; ++n) {
                const double reach = random.below(50) == 0 ? 0.03 : 4e-4; // now and then far
                p += reach * Vec3(random.normal(), random.normal(), random.normal());
                p *= p.norm() > 0.05 ? 0.5 : 1.0;
                const Vec3 v(random.normal(), random.normal(), random.normal());
                const MeshResponse r = contact.respond(mesh, p, v, n, state);
                QVERIFY(r.contact.force.allFinite() && r.contact.energy_J >= 0.0);
                QVERIFY(r.contact.force.dot(r.contact.normal) >= 0.0);
                QVERIFY(std::abs(r.contact.normal.norm() - 1.0) < 1e-9);
                const Vec3& w = r.foot.place.weights;
                QVERIFY(!r.foot.within() || (w.minCoeff() >= 0.0 && std::abs(w.sum() - 1.0) < 1e-9));
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestMeshTracker)
#include "test_mesh_tracker.moc"
