// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "catalogue/named_content.h"
#include "catalogue/tissue_content.h"
#include "core/languages.h"
#include "core/units.h"
#include "support/content_copy.h"

#include <QJsonDocument>
#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::catalogue;

namespace {

const QString kOvary = QStringLiteral("objects/ovary.json");
const QString kDome = QStringLiteral("meshes/bumpy_dome.json");
const QString kProstate = QStringLiteral("tissues/prostate.json");

/// Parameters of a made-up kind: an object, and a mesh that has no default.
const QByteArray kSchema = R"({
    "title": "A kind", "description": "Made up.", "type": "object",
    "properties": {
        "tube": {"$ref": "object_attributes.json", "default": {"object": "fallopian_tube"}, "description": "What is held."},
        "bed": {"$ref": "mesh_source.json", "description": "What it lies on."},
        "length_mm": {"type": "number", "unit": "mm", "minimum": 1, "maximum": 2, "default": 1, "description": "Of it."}
    }
})";

struct Filled {
    QJsonObject resolved;
    Problems problems;
    QString told() const {
        QString all;
        for (const Problem& problem : problems)
            all += problem.path + QStringLiteral(": ") + problem.found + QStringLiteral(": ") +
                   problem.expected + u'\n';
        return all;
    }
};

/// As a level's parameters are: filled in from content, then checked against the schema with its defaults.
Filled fill(const QByteArray& parameters) {
    ContentCopy copy;
    copy.write(QStringLiteral("schema/made_up.json"), kSchema);
    const QString directory = QString::fromStdString(copy.directory());
    const auto schema = readSchema(directory + QStringLiteral("/schema"), QStringLiteral("made_up"));
    const auto named = NamedContent::read(directory);
    Filled out;
    if (!schema || !named)
        return out;
    const QString path = QStringLiteral("$.parameters");
    out.resolved = named->filledIn(QJsonDocument::fromJson(parameters).object(), *schema, path, out.problems);
    out.resolved = validated(out.resolved, *schema, path, out.problems).toObject();
    return out;
}

simulation::ObjectAttributes tubeOf(Filled& filled) {
    return readObject(ObjectReader(filled.resolved["tube"].toObject(), QStringLiteral("$.parameters.tube"),
                                   filled.problems));
}

} // namespace

class TestObjectContent : public QObject {
    Q_OBJECT
private slots:
    void objectsAreLoadedInSi();
    void everyObjectSaysWhereItsNumbersComeFrom();
    void meshesAreLoaded();
    void faultsOfAFile_data();
    void faultsOfAFile();
    void defaultIsFilledIn();
    void nameAloneIsEnough();
    void givenNumbersGoOverTheNamedOnes();
    void faultsOfALevel_data();
    void faultsOfALevel();
    void tissuesAreLoadedInSi();
    void storedFaultsAreToldWithTheirPlace_data();
    void storedFaultsAreToldWithTheirPlace();
    void storedNumbersNeedNoContent();
    void storedKeysOfNewerProgramsAreRefused();
    void storedMeshIsReadWhole();
    void meshesThatCannotBe();
    void storedSurfacesAreChecked();
};

void TestObjectContent::objectsAreLoadedInSi() {
    ContentCopy copy;
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    const ContentObject* ovary = catalogue->findObject("ovary");
    QVERIFY(ovary != nullptr);
    const auto& a = ovary->attributes;
    QCOMPARE(a.id, std::string("ovary"));
    QCOMPARE(a.mass_kg, 0.010); // P2
    QCOMPARE(a.stiffness_N_per_m, 300.0);
    QCOMPARE(a.roughness_m, 40e-6);
    QCOMPARE(a.roughnessWavelength_m, 0.003);
    QCOMPARE(a.roughnessSeed, std::uint64_t{7});
    QCOMPARE(a.recoveryTime_s, 0.3);
    // P2: an ovary has mass, deformability, roughness and friction
    QVERIFY(a.mass_kg > 0.0 && a.recoveryShare > 0.0 && a.roughness_m > 0.0 && a.friction > 0.0);
    // P2: mass of the tube neglected, force proportional to the stretch
    const ContentObject* tube = catalogue->findObject("fallopian_tube");
    QVERIFY(tube != nullptr && tube->attributes.mass_kg == 0.0 && tube->attributes.stiffening_per_m == 0.0);
    for (const char* id : {"sphere", "plane", "organ"})
        QVERIFY2(catalogue->findObject(id) != nullptr, id);
    QVERIFY(catalogue->findObject("spleen") == nullptr);
}

void TestObjectContent::everyObjectSaysWhereItsNumbersComeFrom() {
    ContentCopy copy;
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY(catalogue.has_value());
    for (const ContentObject& object : catalogue->objects()) {
        QVERIFY2(object.source.find("P2") != std::string::npos ||
                     object.source.find("ssumption") != std::string::npos,
                 object.id.c_str());
        for (const std::string& language : core::languageIds())
            QVERIFY2(object.title.contains(language), object.id.c_str());
    }
}

void TestObjectContent::meshesAreLoaded() {
    ContentCopy copy;
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY(catalogue.has_value());
    const ContentMesh* dome = catalogue->findMesh("bumpy_dome");
    QVERIFY(dome != nullptr);
    QCOMPARE(dome->mesh.shape, simulation::MeshSource::Shape::dome);
    QCOMPARE(dome->mesh.halfAxisX_m, 0.020);
    QCOMPARE(dome->mesh.bumpHeight_m, 0.0003);
    const ContentMesh* organ = catalogue->findMesh("organ");
    QVERIFY(organ != nullptr && organ->mesh.shape == simulation::MeshSource::Shape::ellipsoid);
}

void TestObjectContent::faultsOfAFile_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char* tag, const QString& file, const char* from, const char* to,
                        const char* message) {
        QTest::newRow(tag) << file << QByteArray(from) << QByteArray(to) << QByteArray(message);
    };
    row("negative stiffness", kOvary, "\"stiffness_N_per_m\": 300", "\"stiffness_N_per_m\": -300",
        "$.attributes.stiffness_N_per_m: -300: expected a number, 0 to 2000 N/m");
    row("a text for a number", kOvary, "\"mass_g\": 10", "\"mass_g\": \"10 g\"",
        "$.attributes.mass_g: \"10 g\"");
    row("unknown attribute", kOvary, "\"friction\"", "\"fricton\"", "did you mean \"friction\"?");
    row("wavelength under 1 mm", kOvary, "\"roughness_wavelength_mm\": 3", "\"roughness_wavelength_mm\": 0.5",
        "$.attributes.roughness_wavelength_mm: 0.5");
    row("too steep for its wavelength", kOvary, "\"roughness_um\": 40", "\"roughness_um\": 299",
        "$.attributes.roughness_um: 299: expected at most 289 µm at this wavelength");
    row("share without time", kOvary, "\"recovery_s\": 0.3", "\"recovery_s\": 0",
        "$.attributes.recovery_share: 0.5");
    row("no source", kOvary, "\"source\"", "\"sauce\"", "$.source: missing");
    row("another's name", kOvary, "\"id\": \"ovary\"", "\"id\": \"overy\"",
        "$.id: \"overy\": expected the name of its file");
    row("an object of an object", kOvary, "\"mass_g\": 10", "\"object\": \"organ\"",
        "$.attributes.object: given: expected none");
    row("attributes no object", kOvary, "\"attributes\": {", "\"attributes\": [], \"x\": {",
        "$.attributes: an array of 0");
    row("unknown shape", kDome, "\"shape\": \"dome\"", "\"shape\": \"cube\"", "$.shape.shape: \"cube\"");
    row("elevation without its height", kProstate,
        "{\"x_mm\": -10, \"y_mm\": 0, \"radius_x_mm\": 20, \"radius_y_mm\": 26, \"height_mm\": 6}",
        "{\"x_mm\": -10, \"y_mm\": 0, \"radius_x_mm\": 20, \"radius_y_mm\": 26}",
        "$.properties.bumps[0].height_mm: missing");
    row("elevation without a half axis", kProstate, "{\"x_mm\": -10, \"y_mm\": 0, \"radius_x_mm\": 20, ",
        "{\"x_mm\": -10, \"y_mm\": 0, ", "$.properties.bumps[0].radius_x_mm: missing");
    row("unknown key of an elevation", kProstate, "{\"x_mm\": -10,", "{\"x_cm\": -10,",
        "$.properties.bumps[0].x_cm: unknown key");
    row("too many layers", kProstate, "{\"name\": \"gland\", \"thickness_mm\": 40, \"modulus_kPa\": 17}",
        "{\"name\": \"a\", \"modulus_kPa\": 17}, {\"name\": \"b\", \"modulus_kPa\": 17}, "
        "{\"name\": \"c\", \"modulus_kPa\": 17}, {\"name\": \"d\", \"modulus_kPa\": 17}, "
        "{\"name\": \"e\", \"modulus_kPa\": 17}",
        "$.properties.layers");
    row("layer without a modulus", kProstate, ", \"modulus_kPa\": 17", "",
        "$.properties.layers[0].modulus_kPa: missing");
    row("modulus out of range", kProstate, "\"modulus_kPa\": 17", "\"modulus_kPa\": 501",
        "$.properties.layers[0].modulus_kPa: 501: expected a number, 0.5 to 500 kPa");
    row("fibres turned too far", kProstate, "\"fibre_turn_deg\": 90", "\"fibre_turn_deg\": 181",
        "$.properties.fibre_turn_deg: 181: expected a number, -180 to 180 deg");
    row("unknown law", kProstate, "\"friction\": 0.15", "\"contact\": \"glued\"",
        "$.properties.contact: \"glued\"");
    row("too sharp a surface", kProstate, "\"radius_x_mm\": 20, \"radius_y_mm\": 26, \"height_mm\": 6",
        "\"radius_x_mm\": 2, \"radius_y_mm\": 2, \"height_mm\": 6",
        "$.properties.bumps: a surface that bends");
    row("bumps shorter than the mesh", kDome, "\"edge_mm\": 1.0", "\"edge_mm\": 2.5",
        "$.shape.bump_wavelength_mm: 8");
}

void TestObjectContent::faultsOfAFile() {
    QFETCH(QString, file);
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QByteArray, message);
    ContentCopy copy;
    QByteArray text = copy.read(file);
    QVERIFY2(text.contains(from), from.constData());
    copy.write(file, text.replace(from, to));
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY(!catalogue.has_value());
    const QByteArray told = QByteArray::fromStdString(catalogue.error().message);
    QVERIFY2(told.startsWith(copy.path(file).toUtf8() + ':'), told.constData());
    QVERIFY2(told.contains(message), told.constData());
}

void TestObjectContent::defaultIsFilledIn() {
    Filled filled = fill("{}");
    QVERIFY2(filled.problems.empty(), qPrintable(filled.told()));
    const QJsonObject tube = filled.resolved[QStringLiteral("tube")].toObject();
    QCOMPARE(tube[QStringLiteral("object")].toString(), QStringLiteral("fallopian_tube"));
    QCOMPARE(tube[QStringLiteral("stiffness_N_per_m")].toDouble(), 60.0);
    QCOMPARE(tube[QStringLiteral("roughness_seed")].toInt(), 1); // the schema's own default
    QVERIFY2(!filled.resolved.contains("bed"), "no default, not given");
    QCOMPARE(filled.resolved["length_mm"].toInt(), 1);
    QCOMPARE(tubeOf(filled).viscosity_Ns_per_m, 0.2);
}

void TestObjectContent::nameAloneIsEnough() {
    Filled filled = fill(R"({"tube": "ovary", "bed": "organ"})");
    QVERIFY2(filled.problems.empty(), qPrintable(filled.told()));
    const auto tube = tubeOf(filled);
    QCOMPARE(tube.id, std::string("ovary"));
    QCOMPARE(tube.mass_kg, 0.010);
    Problems problems;
    const auto bed = readMesh(ObjectReader(filled.resolved["bed"].toObject(), QStringLiteral("$"), problems));
    QVERIFY(problems.empty());
    QCOMPARE(bed.id, std::string("organ"));
    QCOMPARE(bed.halfAxisX_m, 0.045);
}

void TestObjectContent::givenNumbersGoOverTheNamedOnes() {
    Filled filled =
        fill(R"({"tube": {"object": "fallopian_tube", "stiffness_N_per_m": 90, "stiffening_per_m": 30}})");
    QVERIFY2(filled.problems.empty(), qPrintable(filled.told()));
    const auto tube = tubeOf(filled);
    QCOMPARE(tube.stiffness_N_per_m, 90.0);
    QCOMPARE(tube.stiffening_per_m, 30.0);
    QCOMPARE(tube.friction, 0.25); // the object's own
}

void TestObjectContent::faultsOfALevel_data() {
    QTest::addColumn<QByteArray>("parameters");
    QTest::addColumn<QString>("message");
    QTest::newRow("unknown object") << QByteArray(R"({"tube": "overy"})")
                                    << QStringLiteral(
                                           "sphere; did you mean \"ovary\"?\n"); // and nothing else
    QTest::newRow("a path") << QByteArray(R"({"tube": "../exercises/sphere_apex/exercise"})")
                            << QStringLiteral("$.parameters.tube: \"../exercises");
    QTest::newRow("unknown mesh") << QByteArray(R"({"bed": {"mesh": "liver"}})")
                                  << QStringLiteral("$.parameters.bed.mesh: \"liver\": one of bumpy_dome, ");
    QTest::newRow("out of range") << QByteArray(R"({"tube": {"object": "ovary", "friction": 3}})")
                                  << QStringLiteral("$.parameters.tube.friction: 3: a number, 0 to 2");
    QTest::newRow("unknown attribute") << QByteArray(R"({"tube": {"object": "ovary", "masss_g": 3}})")
                                       << QStringLiteral("$.parameters.tube.masss_g: unknown key");
    QTest::newRow("a number for a name")
        << QByteArray(R"({"tube": 7})") << QStringLiteral("$.parameters.tube: 7: an object");
    QTest::newRow("no name") << QByteArray(R"({"tube": {"object": 7}})")
                             << QStringLiteral("$.parameters.tube.object: 7: a text");
}

void TestObjectContent::faultsOfALevel() {
    QFETCH(QByteArray, parameters);
    QFETCH(QString, message);
    const Filled filled = fill(parameters);
    QVERIFY2(filled.told().contains(message), qPrintable(filled.told()));
    QCOMPARE(filled.problems.size(), std::size_t{1});
}

void TestObjectContent::tissuesAreLoadedInSi() {
    Problems problems;
    const QJsonObject json =
        QJsonDocument::fromJson(R"({"tissue": "pad", "plane_height_mm": -4, "fibre_turn_deg": 30,
            "bumps": [{"radius_x_mm": 20, "radius_y_mm": 26, "turn_deg": 33, "height_mm": 6}],
            "layers": [{"name": "skin", "thickness_mm": 1.7, "modulus_kPa": 60.3},
                       {"name": "fat", "modulus_kPa": 3}],
            "damping_across_N_s_per_m": 3, "contact": "p3_recast", "lump_law": "stiffness_times_depth",
            "distractors": [{"name": "rib", "x_mm": 7, "y_mm": -8, "radius_x_mm": 5, "radius_y_mm": 6,
                             "gain": 0.7}]})")
            .object();
    const auto tissue = readTissue(ObjectReader(json, QStringLiteral("$"), problems));
    QVERIFY(problems.empty());
    QVERIFY(tissue.shape.planeHeight_m == -4 / 1000.0);
    const double degree = core::kPi / 180.0; // angles of tissues are multiplied by it, to the bit
    QVERIFY(tissue.fibreDirection == core::Vec3(std::cos(30 * degree), std::sin(30 * degree), 0.0));
    QCOMPARE(tissue.shape.bumps.size(), std::size_t{1});
    const auto& bump = tissue.shape.bumps[0];
    QVERIFY(bump.centre_m == core::Vec2::Zero() && bump.radii_m == core::Vec2(20 / 1000.0, 26 / 1000.0));
    QVERIFY(bump.turn_rad == 33 * degree && bump.height_m == 6 / 1000.0);
    QCOMPARE(tissue.layers.size(), std::size_t{2}); // instead of the struct's own
    QCOMPARE(tissue.layers[0].name, std::string("skin"));
    QVERIFY(tissue.layers[0].thickness_m == 1.7 / 1000.0 && tissue.layers[0].modulus_Pa == 60.3 * 1000.0);
    QCOMPARE(tissue.layers[1].thickness_m, 0.1);
    QVERIFY(tissue.damping_Ns_per_m == core::Vec3(2.0, 3.0, 2.0));
    QVERIFY(tissue.contact == simulation::TissueContactLaw::p3Recast &&
            tissue.lumps == simulation::LumpLaw::stiffnessTimesDepth);
    QCOMPARE(tissue.regions.size(), std::size_t{1});
    QCOMPARE(tissue.regions[0].name, std::string("rib"));
    QVERIFY(tissue.regions[0].centre_m == core::Vec2(7 / 1000.0, -8 / 1000.0) &&
            tissue.regions[0].gain == 0.7);
}

void TestObjectContent::storedFaultsAreToldWithTheirPlace_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("problem");
    const auto row = [](const char* tag, const char* kind, const char* json, const char* problem) {
        QTest::newRow(tag) << QString::fromLatin1(kind) << QByteArray(json) << QString::fromUtf8(problem);
    };
    row("object: another type", "object", R"({"mass_g": "10"})", "$.mass_g: another type: expected a number");
    row("object: half a seed", "object", R"({"roughness_seed": 1.5})",
        "$.roughness_seed: 1.5: expected a whole number");
    row("object: no name", "object", R"({"object": 7})", "$.object: another type: expected a text");
    row("mesh: another shape", "mesh", R"({"shape": "cube"})",
        R"($.shape: "cube": expected "none", "dome", "ellipsoid" or "stored")");
    row("mesh: no list", "mesh", R"({"triangles": 3})",
        "$.triangles: another type: expected an array of whole numbers");
    row("mesh: negative index", "mesh", R"({"triangles": [0, -1]})",
        "$.triangles[1]: no whole number: expected a whole number");
    row("mesh: unknown key", "mesh", R"({"edge_cm": 1})",
        R"($.edge_cm: unknown key: expected a key of a mesh; did you mean "edge_mm"?)");
    row("tissue: another law", "tissue", R"({"contact": "glued"})",
        R"($.contact: "glued": expected "anchored" or "p3_recast")");
    row("tissue: unknown key", "tissue", R"({"layer": []})",
        R"($.layer: unknown key: expected a property of a tissue; did you mean "layers"?)");
    row("tissue: no list", "tissue", R"({"layers": 3})",
        "$.layers: another type: expected an array of objects");
    row("tissue: half an elevation", "tissue", R"({"bumps": [{"radius_x_mm": 3, "height_mm": 1}]})",
        "$.bumps[0].radius_y_mm: missing: expected a number");
    row("tissue: key of a layer", "tissue", R"({"layers": [{"name": "a", "modulus_kPa": 1, "modulus": 1}]})",
        R"($.layers[0].modulus: unknown key: expected a number of a layer)");
    row("tissue: key of a distractor", "tissue",
        R"({"distractors": [{"name": "a", "radius_x_mm": 3, "radius_y_mm": 3, "gain": 1, "gains": 1}]})",
        R"($.distractors[0].gains: unknown key: expected a number of a distractor; did you mean "gain"?)");
}

// A stored document is not checked against a schema again: the reader itself refuses what it cannot read.
void TestObjectContent::storedFaultsAreToldWithTheirPlace() {
    QFETCH(QString, kind);
    QFETCH(QByteArray, json);
    QFETCH(QString, problem);
    Problems problems;
    const ObjectReader reader(QJsonDocument::fromJson(json).object(), QStringLiteral("$"), problems);
    if (kind == QLatin1String("object"))
        readObject(reader);
    else if (kind == QLatin1String("mesh"))
        readMesh(reader);
    else
        readTissue(reader);
    QCOMPARE(problems.size(), std::size_t{1});
    QCOMPARE(problems[0].path + QStringLiteral(": ") + problems[0].found + QStringLiteral(": expected ") +
                 problems[0].expected,
             problem);
}

// What a session stored is read without any file: an object edited later changes nothing.
void TestObjectContent::storedNumbersNeedNoContent() {
    Filled filled = fill(R"({"tube": {"object": "ovary", "mass_g": 12}})");
    QVERIFY(filled.problems.empty());
    const QByteArray stored = QJsonDocument(filled.resolved).toJson();
    Problems problems;
    const QJsonObject again = QJsonDocument::fromJson(stored).object();
    const auto ovary = readObject(ObjectReader(again["tube"].toObject(), QStringLiteral("$"), problems));
    QVERIFY(problems.empty());
    QCOMPARE(ovary.mass_kg, 0.012);
    QCOMPARE(ovary.stiffening_per_m, 60.0);
    QCOMPARE(ovary.roughnessSeed, std::uint64_t{7});
}

void TestObjectContent::storedKeysOfNewerProgramsAreRefused() {
    Problems problems;
    const auto object = readObject(ObjectReader(QJsonObject{{"object", "ovary"}, {"stickiness", 1}},
                                                QStringLiteral("$.tube"), problems));
    QCOMPARE(problems.size(), std::size_t{1});
    QCOMPARE(problems[0].path, QStringLiteral("$.tube.stickiness"));
    QCOMPARE(object.stiffness_N_per_m,
             simulation::ObjectAttributes{}.stiffness_N_per_m); // older content: the struct's own
}

void TestObjectContent::storedMeshIsReadWhole() {
    Filled filled = fill(R"({"bed": {"shape": "stored", "vertices_um": [0,0,0, 1000,0,0, 0,1000,0, 0,0,1000],
                                     "triangles": [0,2,1, 0,1,3, 1,2,3, 0,3,2]}})");
    QVERIFY2(filled.problems.empty(), qPrintable(filled.told()));
    Problems problems;
    const auto mesh =
        readMesh(ObjectReader(filled.resolved["bed"].toObject(), QStringLiteral("$"), problems));
    checkMesh(mesh, QStringLiteral("$"), problems);
    QVERIFY(problems.empty());
    QCOMPARE(mesh.vertices_um.size(), std::size_t{12});
    QCOMPARE(mesh.vertices_um[3], 1000);
    QCOMPARE(mesh.triangles[11], std::uint32_t{2});
}

void TestObjectContent::meshesThatCannotBe() {
    simulation::MeshSource mesh;
    mesh.shape = simulation::MeshSource::Shape::stored;
    Problems problems;
    checkMesh(mesh, QStringLiteral("$"), problems);
    QCOMPARE(problems.size(), std::size_t{2}); // neither vertices nor triangles
    mesh.vertices_um.assign(12, 0);
    mesh.triangles.assign(12, 0);
    mesh.triangles[7] = 4;
    problems.clear();
    checkMesh(mesh, QStringLiteral("$"), problems);
    QCOMPARE(problems.size(), std::size_t{1});
    QCOMPARE(problems[0].path, QStringLiteral("$.triangles[7]"));
    Filled wrong = fill(R"({"bed": {"shape": "stored", "vertices_um": [0, 0.5]}})");
    QVERIFY2(wrong.told().contains("$.parameters.bed.vertices_um[1]: 0.5"), qPrintable(wrong.told()));
}

// Whole triples of vertices that are there may still be no surface.
void TestObjectContent::storedSurfacesAreChecked() {
    simulation::MeshSource whole;
    whole.shape = simulation::MeshSource::Shape::stored;
    whole.vertices_um = {0, 0, 0, 1000, 0, 0, 0, 1000, 0, 0, 0, 1000, 500, 0, 0};
    whole.triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    const auto told = [](const simulation::MeshSource& mesh) {
        Problems problems;
        checkMesh(mesh, QStringLiteral("$"), problems);
        return problems.empty() ? QString() : problems[0].path + QStringLiteral(": ") + problems[0].found;
    };
    QCOMPARE(told(whole), QString());
    simulation::MeshSource open = whole;
    open.triangles[11] = 4; // the last one reaches a vertex of its own
    QVERIFY2(told(open).startsWith(QStringLiteral("$.triangles: edge ")), qPrintable(told(open)));
    simulation::MeshSource turned = whole;
    std::swap(turned.triangles[0], turned.triangles[1]);
    QVERIFY2(told(turned).startsWith(QStringLiteral("$.triangles: triangle 1")), qPrintable(told(turned)));
    simulation::MeshSource insideOut = whole;
    for (std::size_t t = 0; t < 12; t += 3)
        std::swap(insideOut.triangles[t], insideOut.triangles[t + 1]);
    QVERIFY(!told(insideOut).isEmpty());
    simulation::MeshSource flat = whole; // a sliver without area in an edge
    flat.triangles = {0, 2, 4, 4, 2, 1, 0, 1, 3, 0, 4, 1, 1, 2, 3, 0, 3, 2};
    QVERIFY(!told(flat).isEmpty());
}

QTEST_APPLESS_MAIN(TestObjectContent)
#include "test_object_content.moc"
