// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of every kind of broken mesh, to the word, and what is made of those that can be put right;
// generated meshes to the vertex; what a tool that goes over one feels; the files that are written. Against
// what was looked at and kept: people's files are judged by these words and repairs, and content is made by
// these generators. A change that is meant is kept anew, and its difference is read in review:
// CHIRON_STORE_OUTLINES=1 ctest --test-dir build/release -R "^test_kept_meshes$"
#include "core/fp_environment.h"
#include "mesh_shapes.h"
#include "simulation/geometry/mesh/mesh_contact.h"
#include "simulation/geometry/mesh/mesh_import.h"
#include "support/kept_numbers.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <tuple>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;
using tests::NumberLines;

namespace {

MeshShape box() {
    return plate(0.020, 0.010, 0.005);
}

MeshShape ball(double radius_m, double edge_m, const Vec3& centre) {
    MeshShape shape = *makeMeshShape(ellipsoid(radius_m, radius_m, radius_m, edge_m));
    for (Vec3& p : shape.vertices)
        p += centre;
    return shape;
}

MeshShape together(MeshShape a, const MeshShape& b, bool inwards = false) {
    const auto offset = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& t : b.triangles)
        a.triangles.push_back(
            inwards ? std::array<std::uint32_t, 3>{t[0] + offset, t[2] + offset, t[1] + offset}
                    : std::array<std::uint32_t, 3>{t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

/// Sums that change with every vertex, corner and order.
void addShape(NumberLines& lines, const MeshShape& shape) {
    double places = 0.0, corners = 0.0;
    for (std::size_t v = 0; v < shape.vertices.size(); ++v)
        places += shape.vertices[v].dot(Vec3(1.0, 2.0, 3.0)) * static_cast<double>(1 + v % 31);
    for (std::size_t t = 0; t < shape.triangles.size(); ++t)
        corners += (shape.triangles[t][0] + 2.0 * shape.triangles[t][1] + 3.0 * shape.triangles[t][2]) *
                   static_cast<double>(1 + t % 29);
    lines.add(QStringLiteral("  shape"), {static_cast<double>(shape.vertices.size()),
                                          static_cast<double>(shape.triangles.size()), places, corners});
}

void addMesh(NumberLines& lines, const TriangleMesh& mesh) {
    double neighbours = 0.0;
    Vec3 normals = Vec3::Zero();
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            neighbours += mesh.triangles()[t].neighbour[i] * static_cast<double>(1 + (3 * t + i) % 37);
    for (std::size_t v = 0; v < mesh.vertices().size(); ++v)
        normals += mesh.vertices()[v].normal * static_cast<double>(1 + v % 23);
    MeshShape shape;
    for (const SurfaceVertex& v : mesh.vertices())
        shape.vertices.push_back(v.position);
    for (const SurfaceTriangle& t : mesh.triangles())
        shape.triangles.push_back(t.vertex);
    addShape(lines, shape);
    lines.add(QStringLiteral("  mesh"),
              {neighbours, normals.x(), normals.y(), normals.z(), mesh.meanEdge_m(), mesh.longestEdge_m()});
    lines.add(QStringLiteral("  box"), {mesh.lowest().x(), mesh.lowest().y(), mesh.lowest().z(),
                                        mesh.highest().x(), mesh.highest().y(), mesh.highest().z()});
}

void addImport(NumberLines& lines, const QString& name, const MeshImport& import) {
    lines.add(name);
    for (const QString& line :
         QString::fromStdString(import.report.text()).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
        lines.add(QStringLiteral("  ") + line);
    for (const MeshFinding& f : import.report.findings)
        lines.add(QStringLiteral("  kind %1, %2")
                      .arg(static_cast<int>(f.problem))
                      .arg(f.repaired ? QStringLiteral("repaired") : QStringLiteral("refused")),
                  {static_cast<double>(f.count)});
    lines.add(QStringLiteral("  came out"),
              {static_cast<double>(import.report.vertices), static_cast<double>(import.report.triangles),
               static_cast<double>(import.report.shells), import.report.size_m[0], import.report.size_m[1],
               import.report.size_m[2], import.report.volume_m3 * 1e6});
    if (import.mesh)
        addShape(lines, import.shape);
}

double sumOf(const std::string& bytes) {
    double sum = 0.0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        sum += static_cast<unsigned char>(bytes[i]) * static_cast<double>(1 + i % 251);
    return sum;
}

} // namespace

class TestKeptMeshes : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void shapesThatAreBroken();
    void filesThatAreBroken();
    void whatIsStored();
    void filesThatAreWritten();
    void generatedMeshes();
    void surfacesThatAreRefused();
    void aToolGoesOverOne();
    void everythingKeptIsSeen() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const QString& name, const NumberLines& lines) {
        const QString differs = m_kept.differs(name, lines.lines());
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/simulation/mesh/kept_meshes.txt"),
                           &tests::sameNumbers};
};

void TestKeptMeshes::shapesThatAreBroken() {
    NumberLines lines;
    const auto broken = [&](const char* name, auto change) {
        MeshShape shape = box();
        change(shape);
        addImport(lines, QString::fromLatin1(name), importMesh(shape));
    };
    broken("a box", [](MeshShape&) {});
    broken("nothing", [](MeshShape& s) { s = {}; });
    broken("no number", [](MeshShape& s) {
        s.vertices[3].y() = std::nan("");
        s.vertices[7].z() = std::numeric_limits<double>::infinity();
    });
    broken("no such vertex", [](MeshShape& s) {
        s.triangles[2][1] = static_cast<std::uint32_t>(s.vertices.size());
        s.triangles[5][0] = 4'000'000;
    });
    broken("a hole", [](MeshShape& s) { s.triangles.erase(s.triangles.begin() + 10); });
    broken("two holes", [](MeshShape& s) {
        s.triangles.erase(s.triangles.begin() + 40);
        s.triangles.erase(s.triangles.begin() + 10);
    });
    broken("a fin", [](MeshShape& s) {
        s.vertices.emplace_back(0.0, 0.0, 0.02);
        s.triangles.push_back(
            {s.triangles[40][0], s.triangles[40][1], static_cast<std::uint32_t>(s.vertices.size() - 1)});
    });
    broken("two fins", [](MeshShape& s) {
        s.vertices.emplace_back(0.0, 0.0, 0.02);
        s.vertices.emplace_back(0.0, 0.01, 0.02);
        for (std::uint32_t back = 1; back <= 2; ++back)
            s.triangles.push_back({s.triangles[40][0], s.triangles[40][1],
                                   static_cast<std::uint32_t>(s.vertices.size() - back)});
    });
    broken("flipped", [](MeshShape& s) {
        std::swap(s.triangles[3][0], s.triangles[3][1]);
        std::swap(s.triangles[70][0], s.triangles[70][1]);
    });
    broken("mostly flipped", [](MeshShape& s) {
        for (std::size_t t = 20; t < s.triangles.size(); ++t)
            std::swap(s.triangles[t][0], s.triangles[t][1]);
    });
    broken("half flipped", [](MeshShape& s) {
        for (std::size_t t = 0; t < s.triangles.size() / 2; ++t)
            std::swap(s.triangles[t][0], s.triangles[t][1]);
    });
    broken("inside out", [](MeshShape& s) {
        for (auto& t : s.triangles)
            std::swap(t[0], t[1]);
    });
    broken("two corners at one place", [](MeshShape& s) {
        s.triangles.push_back({s.triangles[0][0], s.triangles[0][0], s.triangles[0][1]});
        s.triangles.push_back({s.triangles[9][0], s.triangles[9][2], s.triangles[9][0]});
    });
    broken("doubled", [](MeshShape& s) {
        const auto t = s.triangles[7], u = s.triangles[50];
        s.triangles.push_back({t[1], t[2], t[0]});
        s.triangles.push_back(u);
        s.triangles.push_back({u[2], u[0], u[1]});
    });
    broken("split on one side", [](MeshShape& s) {
        const auto cut = s.triangles[0];
        s.vertices.push_back(0.5 * (s.vertices[cut[0]] + s.vertices[cut[1]]));
        const auto middle = static_cast<std::uint32_t>(s.vertices.size() - 1);
        s.triangles[0] = {cut[0], middle, cut[2]};
        s.triangles.push_back({middle, cut[1], cut[2]});
        s.triangles.push_back({cut[0], cut[1], middle});
    });
    broken("unused", [](MeshShape& s) {
        s.vertices.emplace_back(1.0, 1.0, 1.0);
        s.vertices.insert(s.vertices.begin(), Vec3(2.0, 0.0, 0.0));
        for (auto& t : s.triangles)
            for (auto& v : t)
                ++v;
    });
    for (const double apart :
         {1e-9, 2e-8, 4e-8, 1e-6}) // of a size of 30 mm: within a millionth of it, and not
        broken(apart < 1e-7 ? "corners apart" : "corners farther apart", [apart](MeshShape& s) {
            MeshShape made;
            for (std::size_t t = 0; t < s.triangles.size(); ++t) {
                const auto first = static_cast<std::uint32_t>(made.vertices.size());
                for (std::size_t i = 0; i < 3; ++i)
                    made.vertices.push_back(s.vertices[s.triangles[t][i]] +
                                            apart * Vec3(t % 2 == 0, i == 1, t % 3 == 0));
                made.triangles.push_back({first, first + 1, first + 2});
            }
            s = made;
        });
    const MeshShape large = ball(0.02, 0.006, Vec3::Zero());
    addImport(lines, QStringLiteral("a hollow"),
              importMesh(together(large, ball(0.005, 0.002, Vec3(0.003, 0.0, 0.0)))));
    addImport(lines, QStringLiteral("a hollow, the right way"),
              importMesh(together(large, ball(0.005, 0.002, Vec3(0.003, 0.0, 0.0)), true)));
    addImport(lines, QStringLiteral("a ball in a hollow"),
              importMesh(together(together(large, ball(0.010, 0.004, Vec3::Zero()), true),
                                  ball(0.004, 0.002, Vec3::Zero()))));
    addImport(lines, QStringLiteral("two beside each other"),
              importMesh(together(large, ball(0.005, 0.002, Vec3(0.03, 0.0, 0.0)))));
    addImport(lines, QStringLiteral("two beside each other, one inside out"),
              importMesh(together(large, ball(0.005, 0.002, Vec3(0.0, -0.03, 0.0)), true)));
    MeshShape many; // more than are asked which lies in which
    for (int i = 0; i < 66; ++i)
        many = together(many, ball(0.005, 0.006, Vec3(0.012 * (i % 8), 0.012 * (i / 8), 0.0)), i % 5 == 0);
    addImport(lines, QStringLiteral("sixty-six balls"), importMesh(many));
    MeshShape some; // as many as are
    for (int i = 0; i < 64; ++i)
        some = together(
            some,
            ball(i == 63 ? 0.2 : 0.005, i == 63 ? 0.2 : 0.006, Vec3(0.012 * (i % 8), 0.012 * (i / 8), 0.0)),
            i == 63);
    addImport(lines, QStringLiteral("sixty-three balls in one"), importMesh(some));
    MeshShape touching = ball(0.005, 0.002, Vec3::Zero());
    const auto top = static_cast<std::uint32_t>(
        std::max_element(touching.vertices.begin(), touching.vertices.end(),
                         [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); }) -
        touching.vertices.begin());
    MeshShape mirrored = touching;
    for (Vec3& p : mirrored.vertices)
        p = 2.0 * touching.vertices[top] - p;
    addImport(lines, QStringLiteral("two that share a vertex"),
              importMesh(together(touching, mirrored, true)));
    MeshShape plane;
    for (int i = 0; i < 6; ++i)
        plane.vertices.push_back(0.01 * Vec3(std::cos(i), std::sin(i), 0.3 * i * i));
    plane.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                       {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
    addImport(lines, QStringLiteral("one-sided"), importMesh(plane));
    hold(QStringLiteral("shapes"), lines);
}

void TestKeptMeshes::filesThatAreBroken() {
    NumberLines lines;
    const auto read = [&](const QString& name, const std::string& bytes, double unit_m = 0.001) {
        const auto guessed = guessMeshFormat(bytes);
        lines.add(QStringLiteral("%1: %2").arg(name, !guessed                      ? QStringLiteral("neither")
                                                     : *guessed == MeshFormat::obj ? QStringLiteral("OBJ")
                                                                                   : QStringLiteral("STL")));
        addImport(lines, QStringLiteral(" as OBJ"), importMesh(bytes, MeshFormat::obj, unit_m));
        addImport(lines, QStringLiteral(" as STL"), importMesh(bytes, MeshFormat::stl, unit_m));
    };
    const std::string obj = writeObj(box()), stl = writeStl(box()), binary = writeBinaryStl(box());
    read(QStringLiteral("OBJ"), obj, 0.01);
    read(QStringLiteral("STL"), stl);
    read(QStringLiteral("binary STL"), binary);
    read(QStringLiteral("nothing"), "");
    read(QStringLiteral("without a unit"), obj, 0.0);
    read(QStringLiteral("of an endless unit"), obj, std::numeric_limits<double>::infinity());
    read(QStringLiteral("a picture"), std::string("\x89PNG\r\n\x1a\n", 8) + std::string(500, 'x'));
    read(QStringLiteral("prose"), "Dear colleague,\nhere is the mesh.\n");
    read(QStringLiteral("a comment"), "# nothing\n");
    read(QStringLiteral("what is passed over"), "mtllib a\no x\ng y\ns 1\nusemtl z\nvn 0 0 1\nvt 0 0\nvp "
                                                "1\nl 1 2\np 1\nmg 1\nbevel on\nlod 1\n\n   \nv 0 0 0\n");
    read(QStringLiteral("NaN"), "v 0 0 0\nv 1 0 nan\n");
    read(QStringLiteral("huge"), "v 0 0 0\nv 1 1e999 0\n");
    read(QStringLiteral("huge in metres"), "v 0 0 0\nv 1 1e308 0\n", 1e3);
    read(QStringLiteral("plus"), "v +0.5 0 -.5\n");
    read(QStringLiteral("a missing number"), "v 0 0\n");
    read(QStringLiteral("a long word"), "v 0 0 " + std::string(100, 'z') + "\n");
    read(QStringLiteral("a long statement"), "v 0 0 0\n" + std::string(100, 'q') + "\n");
    read(QStringLiteral("no such vertex"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
    read(QStringLiteral("the last vertex"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\n");
    read(QStringLiteral("before the first vertex"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n");
    read(QStringLiteral("vertex 0"), "v 0 0 0\nf 0 1 1\n");
    read(QStringLiteral("a long number of a vertex"), "v 0 0 0\nf 1 1 " + std::string(60, '7') + "\n");
    read(QStringLiteral("vertex 2147483648"), "v 0 0 0\nf 1 1 2147483648\n");
    read(QStringLiteral("a word for a vertex"), "v 0 0 0\nf 1 1 1x\n");
    read(QStringLiteral("a slash for a vertex"), "v 0 0 0\nf 1 1 /2\n");
    read(QStringLiteral("a face of two"), "v 0 0 0\nv 1 0 0\nf 1 2 # 3\n");
    read(QStringLiteral("polygons"),
         "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\nf 1 4 3 2\nf 5/1 6/2 7/3 "
         "8/4\nf 1//1 2//1 6//1 5//1\nf -6 -5 -1 -2\r\nf 2 3 7 6\nf 1 5 8 4\n");
    read(QStringLiteral("no faces"), "v 0 0 0\nv 1 0 0\n");
    read(QStringLiteral("OBJ cut off"), obj.substr(0, obj.rfind('\n', obj.size() * 9 / 10) + 1));
    read(QStringLiteral("STL cut off"), stl.substr(0, stl.size() / 2 + 3));
    read(QStringLiteral("STL without its end"), stl.substr(0, stl.size() - 16));
    read(QStringLiteral("STL of four corners"),
         "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 "
         "0\nendloop\nendfacet\nendsolid\n");
    read(QStringLiteral("STL of two corners"), "solid x\n\nfacet normal 0 0 1\nouter loop\nvertex 0 0 "
                                               "0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n");
    read(QStringLiteral("STL with another word"),
         "solid x\nfacet normal 0 0 1\nouter loop\n" + std::string(100, 'w') + "\n");
    read(QStringLiteral("STL with a word between"), "solid x\n" + std::string(100, 'w') + "\n");
    read(QStringLiteral("STL with NaN"), "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n");
    read(QStringLiteral("STL of nothing"), "solid x\nendsolid x\n");
    read(QStringLiteral("binary STL cut off"), binary.substr(0, binary.size() - 20));
    read(QStringLiteral("binary STL, header alone"), binary.substr(0, 60));
    read(QStringLiteral("binary STL, 83 bytes"), binary.substr(0, 83));
    read(QStringLiteral("binary STL, 84 bytes"), binary.substr(0, 84));
    read(QStringLiteral("binary STL and more"), binary + "trailer");
    std::string named = binary;
    named.replace(0, 80, "solid of a program" + std::string(62, ' '));
    read(QStringLiteral("binary STL called solid"), named);
    std::string spoiled = binary;
    for (std::size_t i = 0; i < 4; ++i)
        spoiled[84 + 50 * 3 + 12 + i] = static_cast<char>(0xff);
    read(QStringLiteral("binary STL with NaN"), spoiled);
    for (const std::uint32_t count : {2'000'000U, 2'000'001U}) {
        std::string claims = binary.substr(0, 84);
        for (std::size_t i = 0; i < 4; ++i)
            claims[80 + i] = static_cast<char>(count >> (8 * i) & 0xffU);
        read(QStringLiteral("binary STL that claims %1").arg(count), claims);
    }
    std::string late = std::string(1999, '\n') + "v 0 0 0\n";
    read(QStringLiteral("after 1999 lines"), late);
    read(QStringLiteral("after 2000 lines"), "\n" + late);
    hold(QStringLiteral("files"), lines);
}

void TestKeptMeshes::whatIsStored() {
    NumberLines lines;
    const auto store = [&](const char* name, const MeshShape& shape) {
        const auto stored = storedMesh(shape, "stored");
        if (!stored) {
            lines.add(QStringLiteral("%1: %2").arg(QLatin1String(name),
                                                   QString::fromStdString(stored.error().message)));
            return;
        }
        double places = 0.0, corners = 0.0;
        for (std::size_t i = 0; i < stored->vertices_um.size(); ++i)
            places += stored->vertices_um[i] * static_cast<double>(1 + i % 31);
        for (std::size_t i = 0; i < stored->triangles.size(); ++i)
            corners += stored->triangles[i] * static_cast<double>(1 + i % 29);
        lines.add(QString::fromLatin1(name),
                  {static_cast<double>(stored->vertices_um.size()),
                   static_cast<double>(stored->triangles.size()), places, corners});
    };
    store("a box", box());
    store("a bumpy organ", *makeMeshShape(bumpyOrgan(0.003)));
    MeshShape far = box();
    far.vertices[0].x() = 1.0;
    store("1 m away", far);
    far.vertices[0].x() = -1.000001;
    store("farther away", far);
    far.vertices[0].x() = std::nan("");
    store("nowhere", far);
    MeshShape dust = box();
    for (Vec3& v : dust.vertices)
        v *= 1e-5;
    store("dust", dust);
    MeshShape open = box();
    open.triangles.pop_back();
    store("open", open);
    MeshShape crowd; // one vertex too many
    crowd.vertices.resize(kMostStoredVertices + 1, Vec3::Zero());
    store("many vertices", crowd);
    crowd.vertices.resize(3);
    crowd.triangles.resize(kMostStoredTriangles + 1, {0, 1, 2});
    store("many triangles", crowd);
    hold(QStringLiteral("stored"), lines);
}

void TestKeptMeshes::filesThatAreWritten() {
    NumberLines lines;
    const MeshShape shape = ball(0.005, 0.006, Vec3(0.01, -0.02, 0.0301));
    for (const double unit_m : {0.001, 0.01}) {
        const std::string obj = writeObj(shape, unit_m), stl = writeStl(shape, unit_m),
                          binary = writeBinaryStl(shape, unit_m);
        lines.add(QStringLiteral("OBJ"), {static_cast<double>(obj.size())});
        lines.add(QStringLiteral("STL"), {static_cast<double>(stl.size())});
        lines.add(QStringLiteral("binary STL"),
                  {static_cast<double>(binary.size()), sumOf(binary.substr(0, 84))});
        for (const std::string& text : {obj, stl})
            for (const QString& line :
                 QString::fromStdString(text).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
                lines.add(line);
        addShape(lines, importMesh(binary, MeshFormat::stl, unit_m).shape);
    }
    hold(QStringLiteral("written"), lines);
}

void TestKeptMeshes::generatedMeshes() {
    NumberLines lines;
    const auto generate = [&](const QString& name, const MeshSource& source) {
        lines.add(name);
        const auto shape = makeMeshShape(source);
        const auto mesh = makeMesh(source);
        if (!shape || !mesh) {
            lines.add(QStringLiteral("  ") +
                      QString::fromStdString(shape ? mesh.error().message : shape.error().message));
            return;
        }
        addShape(lines, *shape);
        addMesh(lines, *mesh);
    };
    generate(QStringLiteral("ball"), ellipsoid(0.01, 0.01, 0.01, 0.004));
    generate(QStringLiteral("ball of few"), ellipsoid(0.01, 0.01, 0.01, 0.05));
    generate(QStringLiteral("organ"), bumpyOrgan(0.003));
    MeshSource other = bumpyOrgan(0.003);
    other.seed = 77;
    other.bumpWavelength_m = 0.006;
    generate(QStringLiteral("another organ"), other);
    MeshSource dome = bumpyDome();
    dome.edge_m = 0.003;
    generate(QStringLiteral("bumpy dome"), dome);
    dome.bumpHeight_m = 0.0;
    generate(QStringLiteral("dome"), dome);
    dome.halfAxisX_m = 0.012;
    dome.plateRadius_m = 0.02;
    dome.plateThickness_m = 0.002;
    generate(QStringLiteral("small dome"), dome);
    dome.edge_m = 0.009;
    generate(QStringLiteral("dome with little plate"), dome);

    const auto refuse = [&](const char* name, auto change, bool asDome = false) {
        MeshSource s = asDome ? bumpyDome() : bumpyOrgan(0.003);
        change(s);
        const auto made = makeMeshShape(s);
        lines.add(QStringLiteral("%1: %2").arg(QLatin1String(name),
                                               made ? QStringLiteral("taken")
                                                    : QString::fromStdString(made.error().message)));
    };
    double MeshSource::*const sizes[] = {&MeshSource::halfAxisX_m,      &MeshSource::halfAxisY_m,
                                         &MeshSource::halfAxisZ_m,      &MeshSource::edge_m,
                                         &MeshSource::bumpWavelength_m, &MeshSource::bumpHeight_m,
                                         &MeshSource::plateThickness_m};
    for (const auto size : sizes)
        for (const double value : {0.0, -0.001, std::nan(""), std::numeric_limits<double>::infinity()})
            for (const bool asDome : {false, true})
                refuse(
                    asDome ? "a dome's size" : "an organ's size", [&](MeshSource& s) { s.*size = value; },
                    asDome);
    refuse("no shape", [](MeshSource& s) { s.shape = MeshSource::Shape::none; });
    refuse("as steep as may be", [](MeshSource& s) {
        s.bumpHeight_m = 0.0099999 / (2.0 * core::kPi);
        s.bumpWavelength_m = 0.01;
    });
    refuse("steeper", [](MeshSource& s) {
        s.bumpHeight_m = 0.0100001 / (2.0 * core::kPi);
        s.bumpWavelength_m = 0.01;
    });
    refuse(
        "a plate that is just large enough",
        [](MeshSource& s) {
            s.halfAxisX_m = 0.02;
            s.edge_m = 0.002;
            s.plateRadius_m = 0.0221;
        },
        true);
    refuse(
        "a plate that is not",
        [](MeshSource& s) {
            s.halfAxisX_m = 0.02;
            s.edge_m = 0.002;
            s.plateRadius_m = 0.0219;
        },
        true);
    refuse("too fine", [](MeshSource& s) { s.edge_m = 1e-5; });
    refuse(
        "too fine a dome", [](MeshSource& s) { s.edge_m = 1e-5; }, true);
    hold(QStringLiteral("generated"), lines);
}

void TestKeptMeshes::surfacesThatAreRefused() {
    NumberLines lines;
    const auto make = [&](const char* name, auto change) {
        MeshShape shape = box();
        change(shape);
        const auto mesh = TriangleMesh::create(shape.vertices, shape.triangles);
        lines.add(QStringLiteral("%1: %2").arg(QLatin1String(name),
                                               mesh ? QStringLiteral("taken")
                                                    : QString::fromStdString(mesh.error().message)));
        if (mesh)
            addMesh(lines, *mesh);
    };
    make("a box", [](MeshShape&) {});
    make("nothing", [](MeshShape& s) { s.triangles.clear(); });
    make("too many",
         [](MeshShape& s) { s.triangles.resize(TriangleMesh::kMostTriangles + 1, s.triangles[0]); });
    make("no number", [](MeshShape& s) { s.vertices[5].x() = std::nan(""); });
    make("no such vertex",
         [](MeshShape& s) { s.triangles[4][2] = static_cast<std::uint32_t>(s.vertices.size()); });
    make("no area", [](MeshShape& s) { s.triangles[4][2] = s.triangles[4][1]; });
    make("open", [](MeshShape& s) { s.triangles.pop_back(); });
    make("an edge of three", [](MeshShape& s) { s.triangles.push_back(s.triangles[8]); });
    make("one the other way", [](MeshShape& s) { std::swap(s.triangles[6][0], s.triangles[6][1]); });
    hold(QStringLiteral("surfaces"), lines);
}

/// In, along, out, back in fast and across an edge; with everything that an object may have.
void TestKeptMeshes::aToolGoesOverOne() {
    NumberLines lines;
    const TriangleMesh organ = *makeMesh(bumpyOrgan(0.0025));
    const TriangleMesh slab = *TriangleMesh::create(box().vertices, box().triangles);
    ObjectAttributes plain;
    ObjectAttributes rich;
    rich.stiffening_per_m = 40.0;
    rich.recoveryTime_s = 0.2;
    rich.recoveryShare = 0.6;
    rich.roughness_m = 3e-5;
    rich.roughnessWavelength_m = 0.003;
    rich.friction = 0.25;
    rich.viscosity_Ns_per_m = 1.5;
    const std::tuple<const char*, const TriangleMesh*, const ObjectAttributes*, double> cases[] = {
        {"organ, plain", &organ, &plain, 0.0},
        {"organ, rich", &organ, &rich, 0.002},
        {"slab, rich", &slab, &rich, 0.001}};
    for (const auto& [name, mesh, attributes, radius_m] : cases) {
        lines.add(QString::fromLatin1(name));
        const MeshContact contact(*attributes, radius_m);
        MeshContactState state;
        Vec3 before = Vec3::Zero(), sum = Vec3::Zero(), surfaced = Vec3::Zero(), normals = Vec3::Zero();
        double energy = 0.0, depth = 0.0, tracks = 0.0;
        const double height = mesh == &slab ? 0.0 : 0.0245;
        for (int tick = 0; tick < 1500; ++tick) {
            const double t = core::kTickSeconds * tick;
            const Vec3 p(0.012 * std::sin(3.0 * t), 0.009 * std::sin(4.3 * t),
                         height + radius_m + 0.002 -
                             0.0045 * std::sin(2.0 * t) *
                                 (tick < 900 ? 1.0 : 1.4 + 0.4 * std::sin(40.0 * t)));
            const MeshResponse r = contact.respond(
                *mesh, p, tick == 0 ? Vec3(Vec3::Zero()) : Vec3((p - before) / core::kTickSeconds),
                static_cast<std::uint64_t>(tick), state);
            before = p;
            sum += r.contact.force;
            surfaced += r.surfaced;
            normals += r.foot.normal;
            energy += r.contact.energy_J;
            depth += r.contact.depth_m;
            tracks += static_cast<double>(r.foot.track) * (1 + tick % 50);
            if ((tick + 1) % 50 != 0)
                continue;
            lines.add(QStringLiteral("  after %1 ticks").arg(tick + 1),
                      {sum.x(), sum.y(), sum.z(), surfaced.x(), surfaced.y(), surfaced.z(), normals.x(),
                       normals.y(), normals.z(), energy, depth, tracks});
            sum.setZero();
            surfaced.setZero();
            normals.setZero();
            energy = depth = tracks = 0.0;
        }
    }
    hold(QStringLiteral("gone over"), lines);
}

QTEST_APPLESS_MAIN(TestKeptMeshes)
#include "test_kept_meshes.moc"
