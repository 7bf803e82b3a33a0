// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_shapes.h"
#include "simulation/geometry/mesh/mesh_import.h"

#include <QtTest>
#include <algorithm>
#include <limits>
#include <numeric>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

MeshShape box() {
    return plate(0.020, 0.010, 0.005); // 4 x 4 x 2 cells: 128 triangles, 66 vertices
}

MeshShape made(const MeshSource& source) {
    return *makeMeshShape(source);
}

double volumeOf(const MeshImport& import) {
    return import.mesh ? volume(*import.mesh) : 0.0;
}

bool refused(const MeshImport& import, MeshProblem why) {
    const MeshFinding* finding = import.report.find(why);
    return !import.mesh && !import.report.usable() && finding != nullptr && !finding->repaired &&
           !finding->place.empty() && !finding->found.empty() && !finding->expected.empty();
}

bool repaired(const MeshImport& import, MeshProblem what, std::size_t count) {
    const MeshFinding* finding = import.report.find(what);
    return import.mesh && finding != nullptr && finding->repaired && finding->count == count &&
           !finding->place.empty();
}

} // namespace

/// Meshes that people bring: read, checked, put right where that is safe, refused with the place where it is
/// not.
class TestMeshImport : public QObject {
    Q_OBJECT

private slots:
    void roundTrips_data() {
        QTest::addColumn<int>("format");
        QTest::newRow("OBJ") << 0;
        QTest::newRow("STL") << 1;
        QTest::newRow("binary STL") << 2;
    }
    void roundTrips() {
        QFETCH(int, format);
        for (const MeshShape& shape : {box(), made(bumpyOrgan(0.002)), made(bumpyDome())}) {
            const TriangleMesh before = *TriangleMesh::create(shape.vertices, shape.triangles);
            const std::string bytes = format == 0   ? writeObj(shape)
                                      : format == 1 ? writeStl(shape)
                                                    : writeBinaryStl(shape);
            const MeshFormat kind = format == 0 ? MeshFormat::obj : MeshFormat::stl;
            QVERIFY(guessMeshFormat(bytes) == kind);
            const MeshImport again = importMesh(bytes, kind);
            QVERIFY2(again.mesh, again.report.text().c_str());
            QCOMPARE(again.mesh->triangles().size(), before.triangles().size());
            QCOMPARE(again.mesh->vertices().size(), before.vertices().size());
            QCOMPARE(again.report.shells, std::size_t{1});
            QVERIFY(std::abs(volumeOf(again) / volume(before) - 1.0) < 1e-6);
            QVERIFY(std::abs(again.report.volume_m3 / volume(before) - 1.0) < 1e-6);
            QVERIFY((again.mesh->highest() - before.highest()).norm() < 1e-8);
            if (format == 0) {
                QVERIFY(again.report.findings.empty());
            } else {
                QVERIFY(repaired(again, MeshProblem::duplicateVertices,
                                 3 * before.triangles().size() - before.vertices().size()));
            }
            // the shape as content stores it: to half a micrometre, and the same again
            const MeshSource stored = *storedMesh(again.shape, "organ");
            const auto kept = makeMesh(stored);
            QVERIFY2(kept, kept ? "" : kept.error().message.c_str());
            QVERIFY(std::abs(volume(*kept) / volume(before) - 1.0) < 1e-4);
        }
    }

    void unitsAndPolygons() {
        const char* obj =
            "# a cube of 2\no cube\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 "
            "2\nvn 0 0 1\nusemtl x\n"
            "f 1 4 3 2\nf 5/1 6/2 7/3 8/4\nf 1//1 2//1 6//1 5//1\nf -6 -5 -1 -2\r\nf 2 3 7 6\nf 1 5 8 4\n";
        const MeshImport mm = importMesh(obj, MeshFormat::obj);
        QVERIFY2(mm.mesh, mm.report.text().c_str());
        QCOMPARE(mm.report.triangles, std::size_t{12});
        QVERIFY(std::abs(volumeOf(mm) - 8e-9) < 1e-18);
        QVERIFY(repaired(mm, MeshProblem::polygons, 6));
        const MeshImport cm = importMesh(obj, MeshFormat::obj, 0.01);
        QVERIFY(std::abs(volumeOf(cm) - 8e-6) < 1e-15);
        QVERIFY(refused(importMesh(obj, MeshFormat::obj, 0.0), MeshProblem::badNumber));
    }

    void holes() {
        MeshShape shape = box();
        shape.triangles.erase(shape.triangles.begin() + 10);
        const MeshImport import = importMesh(shape);
        QVERIFY(refused(import, MeshProblem::hole));
        QCOMPARE(import.report.find(MeshProblem::hole)->count, std::size_t{3});
        const std::string text = import.report.text();
        QVERIFY2(text.find("refused: edge ") == 0 && text.find("mm") != std::string::npos, text.c_str());
    }

    void flippedTrianglesAreTurned() {
        MeshShape shape = made(bumpyOrgan(0.004));
        const TriangleMesh before = *TriangleMesh::create(shape.vertices, shape.triangles);
        for (const std::size_t t : {3U, 200U, 201U, 640U})
            std::swap(shape.triangles[t][0], shape.triangles[t][1]);
        const MeshImport import = importMesh(shape);
        QVERIFY2(repaired(import, MeshProblem::flippedTriangle, 4), import.report.text().c_str());
        QCOMPARE(import.report.find(MeshProblem::flippedTriangle)->place, std::string("triangle 4"));
        QVERIFY(std::abs(volumeOf(import) - volume(before)) < 1e-15);
    }

    /// The first triangle says nothing about which way the others should look: the fewer are turned.
    void theFewerAreTurnedAlsoIfTheFirstIsOneOfThem() {
        MeshShape shape = made(bumpyOrgan(0.004));
        for (const std::size_t t : {0U, 200U})
            std::swap(shape.triangles[t][0], shape.triangles[t][1]);
        const MeshImport import = importMesh(shape);
        QVERIFY2(repaired(import, MeshProblem::flippedTriangle, 2), import.report.text().c_str());
        QCOMPARE(import.report.find(MeshProblem::flippedTriangle)->place, std::string("triangle 1"));
    }

    void insideOutIsTurned() {
        MeshShape shape = box();
        for (auto& t : shape.triangles)
            std::swap(t[0], t[1]);
        const MeshImport import = importMesh(shape);
        QVERIFY(repaired(import, MeshProblem::insideOut, 1));
        QVERIFY(std::abs(volumeOf(import) - 4e-6) < 1e-15);
    }

    void aHollowLooksInwards() {
        MeshShape shape = box();
        const auto outer = static_cast<std::uint32_t>(shape.vertices.size());
        const MeshShape hollow = made(ellipsoid(0.003, 0.003, 0.003, 0.001));
        for (const Vec3& p : hollow.vertices)
            shape.vertices.push_back(p + Vec3(0.0, 0.0, -0.005));
        for (const auto& t : hollow.triangles)
            shape.triangles.push_back(
                {t[0] + outer, t[1] + outer, t[2] + outer}); // looks out of the hollow: wrong
        const MeshImport import = importMesh(shape);
        QVERIFY(repaired(import, MeshProblem::insideOut, 1));
        QVERIFY(repaired(import, MeshProblem::severalShells, 1));
        QCOMPARE(import.report.shells, std::size_t{2});
        QVERIFY(volumeOf(import) < 4e-6 && volumeOf(import) > 3.8e-6);
    }

    void nonManifoldEdge() {
        MeshShape shape = box();
        shape.vertices.push_back({0.0, 0.0, 0.02});
        const auto tip = static_cast<std::uint32_t>(shape.vertices.size() - 1);
        shape.triangles.push_back({shape.triangles[40][0], shape.triangles[40][1], tip}); // a fin
        const MeshImport import = importMesh(shape);
        QVERIFY(refused(import, MeshProblem::nonManifoldEdge));
        QCOMPARE(import.report.find(MeshProblem::nonManifoldEdge)->count, std::size_t{1});
    }

    void twoBallsThatShareAVertex() {
        const MeshShape ball = made(ellipsoid(0.005, 0.005, 0.005, 0.002));
        const auto top = static_cast<std::uint32_t>(
            std::max_element(ball.vertices.begin(), ball.vertices.end(),
                             [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); }) -
            ball.vertices.begin());
        MeshShape shape = ball;
        const auto offset = static_cast<std::uint32_t>(ball.vertices.size());
        for (const Vec3& p : ball.vertices) // mirrored through the top vertex
            shape.vertices.push_back(2.0 * ball.vertices[top] - p);
        for (const auto& t : ball.triangles)
            shape.triangles.push_back({t[0] + offset, t[2] + offset, t[1] + offset});
        const MeshImport import = importMesh(shape);
        QVERIFY2(repaired(import, MeshProblem::nonManifoldVertex, 1), import.report.text().c_str());
        QCOMPARE(import.report.shells, std::size_t{2});
        QCOMPARE(import.mesh->vertices().size(), 2 * ball.vertices.size());
    }

    void degenerateTriangles() {
        // a side of the box with a vertex in it: two triangles more of which one has no area, and closed
        // still
        MeshShape sliver = box();
        const auto t = sliver.triangles[0];
        sliver.triangles.push_back({t[0], t[0], t[1]});
        const MeshImport dropped = importMesh(sliver);
        QVERIFY(repaired(dropped, MeshProblem::degenerateTriangle, 1));
        QCOMPARE(dropped.report.triangles, std::size_t{128});
        // an edge split on one side only, closed by a triangle on a line: without it there is a hole
        MeshShape split = box();
        const auto cut = split.triangles[0];
        split.vertices.push_back(0.5 * (split.vertices[cut[0]] + split.vertices[cut[1]]));
        const auto middle = static_cast<std::uint32_t>(split.vertices.size() - 1);
        split.triangles[0] = {cut[0], middle, cut[2]};
        split.triangles.push_back({middle, cut[1], cut[2]});
        split.triangles.push_back({cut[0], cut[1], middle});
        const MeshImport kept = importMesh(split);
        QVERIFY2(refused(kept, MeshProblem::degenerateTriangle), kept.report.text().c_str());
    }

    void doubledTriangleIsDropped() {
        MeshShape shape = box();
        const auto t = shape.triangles[7];
        shape.triangles.push_back({t[1], t[2], t[0]});
        QVERIFY(repaired(importMesh(shape), MeshProblem::doubledTriangle, 1));
    }

    void verticesNearlyAtOnePlaceAreJoined() {
        MeshShape shape = box();
        core::Random random(3);
        MeshShape apart;
        for (const auto& t : shape.triangles)
            for (const std::uint32_t v : t) {
                apart.vertices.push_back(shape.vertices[v] + 1e-9 * Vec3(random.uniform(-1, 1),
                                                                         random.uniform(-1, 1),
                                                                         random.uniform(-1, 1)));
                if (apart.vertices.size() % 3 == 0) {
                    const auto n = static_cast<std::uint32_t>(apart.vertices.size());
                    apart.triangles.push_back({n - 3, n - 2, n - 1});
                }
            }
        const MeshImport import = importMesh(apart);
        QVERIFY2(import.mesh, import.report.text().c_str());
        QCOMPARE(import.mesh->vertices().size(), shape.vertices.size());
    }

    void oneSidedIsRefused() {
        // a real projective plane of six vertices: closed, every edge in two triangles, and no inside
        MeshShape shape;
        for (int i = 0; i < 6; ++i)
            shape.vertices.push_back(0.01 * Vec3(std::cos(i), std::sin(i), 0.3 * i * i));
        shape.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                           {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
        QVERIFY(refused(importMesh(shape), MeshProblem::oneSided));
    }

    void unusedVertices() {
        MeshShape shape = box();
        shape.vertices.insert(shape.vertices.begin(), Vec3(1.0, 1.0, 1.0));
        for (auto& t : shape.triangles)
            for (auto& v : t)
                ++v;
        const MeshImport import = importMesh(shape);
        QVERIFY(repaired(import, MeshProblem::unusedVertices, 1));
        QVERIFY(import.mesh->highest().x() < 0.011);
    }

    void badFiles_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<bool>("obj");
        QTest::addColumn<int>("problem");
        QTest::addColumn<QByteArray>("place");
        const auto row = [](const char* name, const std::string& bytes, bool obj, MeshProblem why,
                            const char* place) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes) << obj << static_cast<int>(why)
                                << QByteArray(place);
        };
        const std::string obj = writeObj(box()), stl = writeStl(box()), binary = writeBinaryStl(box());
        row("empty", "", true, MeshProblem::wrongFile, "the beginning");
        row("a picture", std::string("\x89PNG\r\n\x1a\n", 8) + std::string(500, 'x'), true,
            MeshProblem::wrongFile, "the beginning");
        row("a picture called STL", std::string("\x89PNG\r\n\x1a\n", 8) + std::string(50, 'x'), false,
            MeshProblem::truncated, "byte 58"); // an STL file may begin with anything
        row("prose", "Dear colleague,\nhere is the mesh.\n", true, MeshProblem::wrongFile, "the beginning");
        row("NaN", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n", true, MeshProblem::badNumber, "line 2");
        row("infinite", "v 0 0 0\nv 1 0 inf\n", true, MeshProblem::badNumber, "line 2");
        row("huge", "v 0 0 0\nv 1 0 1e999\n", true, MeshProblem::badNumber, "line 2");
        row("missing number", "v 0 0\n", true, MeshProblem::badNumber, "line 1");
        row("word", "v 0 0 zero\n", true, MeshProblem::badNumber, "line 1");
        row("no such vertex", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", true, MeshProblem::badIndex,
            "triangle 1 (line 4)");
        row("vertex 0", "v 0 0 0\nf 0 1 1\n", true, MeshProblem::badIndex, "line 2");
        row("far back", "v 0 0 0\nf -1 -1 -7\n", true, MeshProblem::badIndex, "line 2");
        row("face of two", "v 0 0 0\nv 1 0 0\nf 1 2\n", true, MeshProblem::badLine, "line 3");
        row("no statement", "v 0 0 0\nxyzzy\n", true, MeshProblem::badLine, "line 2");
        row("no faces", "v 0 0 0\nv 1 0 0\n", true, MeshProblem::noTriangles, "the end of the file");
        row("OBJ cut off", obj.substr(0, obj.rfind('\n', obj.size() * 9 / 10) + 1), true, MeshProblem::hole,
            "");
        row("STL cut off", stl.substr(0, stl.size() / 2 + 3), false, MeshProblem::truncated, "");
        row("STL without its end", stl.substr(0, stl.size() - 16), false, MeshProblem::truncated, "");
        row("STL of four corners",
            "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 "
            "0\nendloop\nendfacet\nendsolid\n",
            false, MeshProblem::badLine, "line 2");
        row("STL with NaN", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n", false,
            MeshProblem::badNumber, "line 4");
        row("binary STL cut off", binary.substr(0, binary.size() - 20), false, MeshProblem::truncated, "");
        row("binary STL, header alone", binary.substr(0, 60), false, MeshProblem::truncated, "byte 60");
        std::string named = binary; // as some programs write it: words, then spaces
        named.replace(0, 80, "solid of a program" + std::string(62, ' '));
        const std::string end = "byte " + std::to_string(named.size() - 20);
        row("binary STL called solid, cut off", named.substr(0, named.size() - 20), false,
            MeshProblem::truncated, end.c_str());
        std::string spoiled = binary;
        for (std::size_t i = 0; i < 4; ++i)
            spoiled[84 + 50 * 3 + 12 + i] = static_cast<char>(0xff); // a NaN
        row("binary STL with NaN", spoiled, false, MeshProblem::badNumber, "triangle 4 (byte 246)");
    }
    void badFiles() {
        QFETCH(QByteArray, bytes);
        QFETCH(bool, obj);
        QFETCH(int, problem);
        QFETCH(QByteArray, place);
        const MeshImport import =
            importMesh(std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())),
                       obj ? MeshFormat::obj : MeshFormat::stl);
        QVERIFY2(refused(import, static_cast<MeshProblem>(problem)), import.report.text().c_str());
        if (!place.isEmpty())
            QCOMPARE(QByteArray::fromStdString(import.report.find(static_cast<MeshProblem>(problem))->place),
                     place);
    }

    /// Ten million triangles, claimed by a header or brought line by line, are refused before they are
    /// stored.
    void tenMillionTriangles() {
        std::string header = writeBinaryStl({});
        const std::uint32_t ten = 10'000'000;
        for (std::size_t i = 0; i < 4; ++i)
            header[80 + i] = static_cast<char>(ten >> (8 * i) & 0xffU);
        const MeshImport claimed = importMesh(header, MeshFormat::stl);
        QVERIFY2(refused(claimed, MeshProblem::tooManyTriangles), claimed.report.text().c_str());
        QCOMPARE(claimed.report.find(MeshProblem::tooManyTriangles)->found,
                 std::string("10000000 triangles or more"));
        QVERIFY(claimed.shape.triangles.capacity() == 0);
        std::string lines = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        lines.reserve(90'000'000);
        for (int i = 0; i < 10'000'000; ++i)
            lines += "f 1 2 3\n";
        const MeshImport brought = importMesh(lines, MeshFormat::obj);
        QVERIFY(refused(brought, MeshProblem::tooManyTriangles));
        QCOMPARE(brought.report.find(MeshProblem::tooManyTriangles)->place, std::string("line 2000004"));
        QVERIFY(brought.shape.triangles.size() <= TriangleMesh::kMostTriangles);
    }

    void bytesBehindABinaryStl() {
        const MeshImport import = importMesh(writeBinaryStl(box()) + "trailer", MeshFormat::stl);
        QVERIFY(repaired(import, MeshProblem::bytesBehindTheEnd, 1));
    }

    /// Bytes at random and files with a byte changed: an answer every time, never a mesh that is not closed.
    void spoiledFilesNeverPass() {
        core::Random random(9);
        const std::string files[] = {writeObj(made(ellipsoid(0.01, 0.01, 0.01, 0.006))), writeStl(box()),
                                     writeBinaryStl(box())};
        for (int i = 0; i < 2'000; ++i) {
            std::string bytes = files[i % 3];
            for (std::uint64_t k = random.below(4) + 1; k > 0; --k)
                bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
            if (i % 5 == 0)
                bytes.resize(random.below(bytes.size()));
            const MeshImport import = importMesh(bytes, i % 3 == 0 ? MeshFormat::obj : MeshFormat::stl);
            QCOMPARE(import.mesh.has_value(), import.report.usable());
            if (import.mesh)
                QVERIFY(std::isfinite(volumeOf(import)));
            else
                QVERIFY(!import.report.text().empty());
        }
    }

    /// Two corners 0.3 µm apart are one in whole micrometres: the sliver between them goes, and what is
    /// stored is closed.
    void roundingIsCheckedAgain() {
        MeshShape shape;
        shape.vertices = {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}, {3e-7, 0, 0}};
        shape.triangles = {{4, 2, 1}, {0, 2, 4}, {0, 4, 3}, {4, 1, 3}, {1, 2, 3}, {0, 3, 2}};
        QVERIFY(importMesh(shape).mesh);
        const auto stored = storedMesh(shape, "thin");
        QVERIFY2(stored, stored ? "" : stored.error().message.c_str());
        QCOMPARE(stored->id, std::string("thin"));
        QCOMPARE(stored->triangles.size() / 3, std::size_t{4});
        QVERIFY(makeMesh(*stored));
        // and one that has nothing left
        for (Vec3& v : shape.vertices)
            v *= 1e-5;
        QVERIFY(!storedMesh(shape, "dust"));
    }

    void contentTakesNoMore() {
        const auto refusedShape = storedMesh(made(bumpyOrgan(0.00045)), "large");
        QVERIFY(!refusedShape);
        QVERIFY2(refusedShape.error().message.find("100000") != std::string::npos,
                 refusedShape.error().message.c_str());
        MeshShape shape = box();
        shape.vertices[0].x() = 1.1;
        QVERIFY(!storedMesh(shape, "far"));
    }

    void storedMeshesAreChecked() {
        MeshShape shape = box();
        shape.vertices[0].x() = 3e3;
        QVERIFY(!storedMesh(shape, "far"));
        MeshSource open = *storedMesh(box(), "box");
        open.triangles.resize(open.triangles.size() - 3);
        const auto refusedMesh = makeMesh(open);
        QVERIFY(!refusedMesh && refusedMesh.error().message.find("edge") == 0);
        open.triangles.push_back(0);
        QVERIFY(!makeMesh(open));
    }
};

QTEST_APPLESS_MAIN(TestMeshImport)
#include "test_mesh_import.moc"
