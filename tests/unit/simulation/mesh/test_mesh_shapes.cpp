// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_shapes.h"
#include "simulation/geometry/mesh/mesh_query.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

/// What the generators make: closed, outward, of the size asked for, the same every time; and what they
/// refuse.
class TestMeshShapes : public QObject {
    Q_OBJECT

private slots:
    void dome() {
        MeshSource source = bumpyDome();
        source.bumpHeight_m = 0.0;
        const TriangleMesh mesh = *makeMesh(source);
        const double exact = core::kPi * (2.0 / 3.0 * std::pow(0.020, 3) + 0.075 * 0.075 * 0.010);
        QVERIFY2(std::abs(volume(mesh) / exact - 1.0) < 2e-3,
                 qPrintable(QString::number(volume(mesh) / exact)));
        QVERIFY(std::abs(mesh.highest().z() - 0.020) < 1e-12 && std::abs(mesh.lowest().z() + 0.010) < 1e-12);
        QVERIFY(std::abs(mesh.meanEdge_m() / source.edge_m - 1.0) < 0.15);
        for (const SurfaceVertex& v : mesh.vertices())
            if (v.position.z() > 0.002)
                QVERIFY((v.normal - v.position.normalized()).norm() < 0.02);
    }

    /// With bumps the apex stays the highest point of the dome: a task that asks for it has one answer.
    void domeWithBumpsKeepsItsApex() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            MeshSource source = bumpyDome();
            source.bumpHeight_m = 0.0005;
            source.seed = seed;
            const TriangleMesh mesh = *makeMesh(source);
            const auto top = std::max_element(mesh.vertices().begin(), mesh.vertices().end(),
                                              [](const SurfaceVertex& a, const SurfaceVertex& b) {
                                                  return a.position.z() < b.position.z();
                                              });
            QVERIFY(top->position.head<2>().norm() < 1e-12);
        }
    }

    void organ() {
        const TriangleMesh smooth = *makeMesh(ellipsoid(0.040, 0.030, 0.025, 0.0007));
        QCOMPARE(smooth.triangles().size(), std::size_t{50'000});
        QVERIFY(std::abs(volume(smooth) / (4.0 / 3.0 * core::kPi * 0.040 * 0.030 * 0.025) - 1.0) < 1e-3);
        for (const SurfaceVertex& v : smooth.vertices()) {
            const Vec3 exact = v.position.cwiseQuotient(Vec3(0.0016, 0.0009, 0.000625)).normalized();
            QVERIFY((v.normal - exact).norm() < 2e-3);
        }
        const MeshShape bumpy = *makeMeshShape(bumpyOrgan()),
                        flat = *makeMeshShape(ellipsoid(0.040, 0.030, 0.025, 0.0007));
        double rms = 0.0;
        for (std::size_t v = 0; v < bumpy.vertices.size(); ++v)
            rms += (bumpy.vertices[v] - flat.vertices[v]).squaredNorm();
        rms = std::sqrt(rms / static_cast<double>(bumpy.vertices.size()));
        QVERIFY2(std::abs(rms / (0.0004 / std::sqrt(2.0)) - 1.0) < 0.2, qPrintable(QString::number(rms)));
    }

    void halfAMillion() {
        const TriangleMesh mesh = *makeMesh(bumpyOrgan(0.000222));
        QVERIFY(mesh.triangles().size() > 490'000 && mesh.triangles().size() < 510'000);
        QVERIFY(volume(mesh) > 0.0);
    }

    void theSameSourceGivesTheSameMesh() {
        const TriangleMesh a = *makeMesh(bumpyOrgan(0.002)), b = *makeMesh(bumpyOrgan(0.002));
        MeshSource other = bumpyOrgan(0.002);
        other.seed = 2;
        const TriangleMesh c = *makeMesh(other);
        bool same = a.vertices().size() == b.vertices().size(), different = false;
        for (std::size_t v = 0; v < a.vertices().size(); ++v) {
            same = same && a.vertices()[v].position == b.vertices()[v].position &&
                   a.vertices()[v].normal == b.vertices()[v].normal;
            different = different || a.vertices()[v].position != c.vertices()[v].position;
        }
        QVERIFY(same);
        QVERIFY(different);
    }

    void refusedWithTheReason() {
        const auto says = [](const MeshSource& source, const char* word) {
            const auto mesh = makeMesh(source);
            return !mesh && mesh.error().message.find(word) != std::string::npos;
        };
        QVERIFY(says({}, "no shape"));
        MeshSource s = bumpyOrgan();
        s.halfAxisY_m = 0.0;
        QVERIFY(says(s, "halfAxisY_m"));
        s = bumpyOrgan();
        s.edge_m = 1e-6;
        QVERIFY(says(s, "edge_m"));
        s = bumpyOrgan();
        s.bumpHeight_m = 0.002;
        QVERIFY(says(s, "bumpHeight_m"));
        s = bumpyDome();
        s.plateRadius_m = 0.019;
        QVERIFY(says(s, "plateRadius_m"));
        s = bumpyDome();
        s.halfAxisX_m = std::nan("");
        QVERIFY(says(s, "halfAxisX_m"));
    }

    /// The tree's nearest point against looking everywhere, with its side.
    void nearestAgreesWithLookingEverywhere() {
        for (const MeshSource& source : {bumpyOrgan(0.0015), bumpyDome()}) {
            const TriangleMesh mesh = *makeMesh(source);
            BruteForce brute(mesh);
            core::Random random(4);
            const Vec3 size = mesh.highest() - mesh.lowest();
            for (int i = 0; i < 2'000; ++i) {
                const Vec3 p = mesh.lowest() + Vec3(random.uniform(-0.1, 1.1), random.uniform(-0.1, 1.1),
                                                    random.uniform(-0.1, 1.1))
                                                   .cwiseProduct(size);
                const NearestOnMesh found = nearestOnMesh(mesh, p);
                const double exact = (pointAt(mesh, brute.nearest(p)) - p).norm();
                QVERIFY(std::abs(std::abs(found.signedDistance_m) - exact) < 1e-12);
                // the side by another way: how often a line from p goes in and comes out
                int crossings = 0;
                Vec3 at = p;
                const Vec3 way(0.3711, 0.2177, 1.0);
                for (auto entry = firstEntry(mesh, at, p + way); entry;
                     entry = firstEntry(mesh, at, p + way)) {
                    at = pointAt(mesh, *entry) + 1e-7 * way;
                    ++crossings;
                }
                int back = 0;
                at = p + way;
                for (auto entry = firstEntry(mesh, at, p); entry; entry = firstEntry(mesh, at, p)) {
                    at = pointAt(mesh, *entry) - 1e-7 * way;
                    ++back;
                }
                // forth it goes in `crossings` times, back `back` times; inside, once more back than forth
                QCOMPARE(found.signedDistance_m < 0.0, back == crossings + 1);
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestMeshShapes)
#include "test_mesh_shapes.moc"
