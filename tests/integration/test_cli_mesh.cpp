// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "cli_process.h"
#include "simulation/geometry/mesh/mesh_import.h"
#include "support/content_copy.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using namespace chiron;

// Meshes from outside: checked, put right, refused with the place, and written as content that the catalogue
// takes.
class TestCliMesh : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void checkReports_data();
    void checkReports();
    void repairsAreTold();
    void refusedWithThePlace_data();
    void refusedWithThePlace();
    void importIsContent();
    void aLargeImportIsContentToo();
    void idsAreChecked();

private:
    QString file(const QString& name, const std::string& content) {
        QFile out(m_folder.filePath(name));
        if (!out.open(QIODevice::WriteOnly) || out.write(QByteArray::fromStdString(content)) < 0)
            qFatal("the test's own file could not be written");
        return out.fileName();
    }
    QTemporaryDir m_folder;
};

namespace {

simulation::MeshShape organ() {
    simulation::MeshSource source;
    source.shape = simulation::MeshSource::Shape::ellipsoid;
    source.halfAxisX_m = 0.020;
    source.halfAxisY_m = 0.015;
    source.halfAxisZ_m = 0.010;
    source.edge_m = 0.004;
    return *simulation::makeMeshShape(source);
}

QJsonObject object(const CliRun& run) {
    return QJsonDocument::fromJson(run.out).object();
}

const std::string kTetrahedron = "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 2 3 4\n";

} // namespace

void TestCliMesh::checkReports_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("OBJ") << "organ.obj" << QByteArray::fromStdString(simulation::writeObj(organ()));
    QTest::newRow("STL") << "organ.stl" << QByteArray::fromStdString(simulation::writeStl(organ()));
    QTest::newRow("binary STL") << "binary.stl"
                                << QByteArray::fromStdString(simulation::writeBinaryStl(organ()));
}

void TestCliMesh::checkReports() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    const QString path = file(name, bytes.toStdString());
    const CliRun run = runCli({"mesh", "check", path, "--json"});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    const QJsonObject report = object(run);
    QCOMPARE(report["triangles"].toInt(), static_cast<int>(organ().triangles.size()));
    QCOMPARE(report["vertices"].toInt(), static_cast<int>(organ().vertices.size()));
    QCOMPARE(report["shells"].toInt(), 1);
    const QJsonArray size = report["size_mm"].toArray();
    QVERIFY(std::abs(size[0].toDouble() - 40.0) < 1.0 && std::abs(size[2].toDouble() - 20.0) < 1.0);
    QVERIFY(std::abs(object(runCli({"mesh", "check", path, "--unit", "cm", "--json"}))["size_mm"]
                             .toArray()[0]
                             .toDouble() /
                         size[0].toDouble() -
                     10.0) < 1e-6);
    const CliRun words = runCli({"mesh", "check", path});
    QVERIFY2(words.out.contains(QByteArray::number(report["triangles"].toInt()) + " triangles"),
             words.out.constData());
}

void TestCliMesh::repairsAreTold() {
    const CliRun run = runCli({"mesh", "check", file("turned.obj", kTetrahedron + "f 1 3 4\n"),
                               "--json"}); // the last looks inwards
    QVERIFY2(run.exitCode == 0, run.err.constData());
    const QJsonArray findings = object(run)["findings"].toArray();
    QCOMPARE(findings.size(), 1);
    QVERIFY(findings[0]["put_right"].toBool());
    QVERIFY2(findings[0]["place"].toString().contains("line 8"), qPrintable(findings[0]["place"].toString()));
}

void TestCliMesh::refusedWithThePlace_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QStringList>("mentions");
    QTest::newRow("a hole") << QByteArray::fromStdString(kTetrahedron)
                            << QStringList{"given.obj: edge ", "expected"};
    QTest::newRow("no number") << QByteArray("v 0 0 0\nv 1 x 0\n") << QStringList{"given.obj: line 2"};
    QTest::newRow("no vertex") << QByteArray::fromStdString(kTetrahedron + "f 1 4 9\n")
                               << QStringList{"line 8"};
    QTest::newRow("neither") << QByteArray("hello\n") << QStringList{"OBJ or STL"};
    const QByteArray binary = QByteArray::fromStdString(simulation::writeBinaryStl(organ()));
    QTest::newRow("binary STL cut off")
        << binary.left(binary.size() - 7)
        << QStringList{QStringLiteral("byte %1").arg(binary.size() - 7), "cut off", "triangles"};
    const QByteArray textual = QByteArray::fromStdString(simulation::writeStl(organ()));
    QTest::newRow("STL as text, cut off") << textual.left(textual.size() / 2) << QStringList{"line "};
    QTest::newRow("empty") << QByteArray() << QStringList{"an empty file"};
}

void TestCliMesh::refusedWithThePlace() {
    QFETCH(QByteArray, bytes);
    QFETCH(QStringList, mentions);
    const QString path = file("given.obj", bytes.toStdString());
    for (const QStringList& words : {QStringList{"mesh", "check", path},
                                     {"mesh", "check", path, "--json"},
                                     {"mesh", "import", path, "--id", "x"}}) {
        const QString fault = refusalFault(runCli(words), 3, mentions);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }
}

/// What import prints is a file of content/meshes, and a level may name it.
void TestCliMesh::importIsContent() {
    const QString path = file("organ.obj", simulation::writeObj(organ()));
    const CliRun run = runCli({"mesh", "import", path, "--id", "my_organ"});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    QCOMPARE(run.out, runCli({"mesh", "import", path, "--id", "my_organ", "--json"}).out);
    const ContentCopy copy;
    copy.write(QStringLiteral("meshes/my_organ.json"), run.out);
    const auto catalogue = catalogue::Catalogue::load(copy.directory());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    const catalogue::ContentMesh* mesh = catalogue->findMesh("my_organ");
    QVERIFY(mesh != nullptr);
    const auto made = simulation::makeMesh(mesh->mesh);
    QVERIFY(made.has_value());
    QCOMPARE(made->triangles().size(), organ().triangles.size());
    QVERIFY(std::abs(made->highest().x() - 0.020) < 1e-3);
    QCOMPARE(mesh->source, std::string("Imported from organ.obj."));
}

/// As large as content may be: what import prints every later read of the catalogue takes.
void TestCliMesh::aLargeImportIsContentToo() {
    simulation::MeshSource source;
    source.shape = simulation::MeshSource::Shape::ellipsoid;
    source.halfAxisX_m = source.halfAxisY_m = source.halfAxisZ_m = 0.060;
    source.edge_m = 0.001;
    const auto shape = simulation::makeMeshShape(source);
    QVERIFY(shape.has_value());
    QVERIFY2(shape->triangles.size() > 60'000 && shape->triangles.size() < 100'000,
             qPrintable(QString::number(shape->triangles.size())));
    const CliRun run =
        runCli({"mesh", "import", file("large.obj", simulation::writeObj(*shape)), "--id", "large"});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    QVERIFY(run.out.size() > 1 << 20);
    const ContentCopy copy;
    copy.write(QStringLiteral("meshes/large.json"), run.out);
    const auto catalogue = catalogue::Catalogue::load(copy.directory());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    QVERIFY(catalogue->findMesh("large") != nullptr);
}

void TestCliMesh::idsAreChecked() {
    const QString path = file("organ.obj", simulation::writeObj(organ()));
    for (const QString& id : {QStringLiteral("My organ"), QStringLiteral("1st"), QStringLiteral("../x"),
                              QStringLiteral("_x"), QStringLiteral("x{"), QStringLiteral("x`"),
                              QStringLiteral("x:"), QStringLiteral("x/"), QString(41, QLatin1Char('x'))}) {
        const QString fault =
            refusalFault(runCli({"mesh", "import", path, "--id", id}), 3, {"--id", "lower-case letters"});
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }
    for (const QString& id :
         {QStringLiteral("a_0"), QStringLiteral("z9_az"), QString(40, QLatin1Char('x'))}) {
        const CliRun run = runCli({"mesh", "import", path, "--id", id});
        QVERIFY2(run.exitCode == 0 && run.out.contains(id.toUtf8()), run.err.constData());
    }
    QCOMPARE(runCli({"mesh", "import", path}).exitCode, 2);
}

QTEST_GUILESS_MAIN(TestCliMesh)
#include "test_cli_mesh.moc"
