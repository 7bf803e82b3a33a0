// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "support/content_copy.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using namespace chiron;
using namespace chiron::catalogue;

namespace {

const QString kLevel = QStringLiteral("exercises/sphere_apex/levels/decoy_dimple.json");

} // namespace

class TestContentFaults : public QObject {
    Q_OBJECT
private slots:
    void crossChecks_data();
    void crossChecks();
    void softOrgans_data();
    void softOrgans();
    void missingFolderAndFiles();
    void levelNumbersWithoutGap();
    void allFaultsOfAFileTogether();
    void badSchemaIsRefused();
};

void TestContentFaults::crossChecks_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("path");
    const auto row = [](const char* tag, const char* from, const char* to, const char* path) {
        QTest::newRow(tag) << QByteArray(from) << QByteArray(to) << QByteArray(path);
    };
    row("stiffness order", "\"stiffness_low_N_per_m\": 500", "\"stiffness_low_N_per_m\": 501",
        "$.parameters.stiffness_low_N_per_m: 501");
    row("friction order", "\"friction_low\": 0", "\"friction_low\": 0.1", "$.parameters.friction_low: 0.1");
    row("sphere leaves workspace", "\"centre_disc_radius_mm\": 40", "\"centre_disc_radius_mm\": 46",
        "$.parameters.centre_disc_radius_mm: 46 mm");
    row("dimple on the apex", "\"dimple_offset_mm\": 10", "\"dimple_offset_mm\": 8.9",
        "$.parameters.dimple_offset_mm: 8.9 mm");
    row("dimple off the ball", "\"dimple_offset_mm\": 10", "\"dimple_offset_mm\": 14.5",
        "$.parameters.dimple_radius_mm: 9 mm");
    row("unknown metric", "{\"id\": \"force_max\"", "{\"id\": \"force_most\"",
        "$.metrics[11].id: \"force_most\"");
    row("unknown version", "{\"id\": \"time\", \"version\": 1}", "{\"id\": \"time\", \"version\": 9}",
        "$.metrics[4].version: 9");
    row("metric twice", "{\"id\": \"force_mean\"", "{\"id\": \"force_max\"",
        "$.metrics[12].id: \"force_max\"");
    row("gate on what is not computed", "{\"metric\": \"apex_misses\"", "{\"metric\": \"tube_length\"",
        "$.gates[1].metric: \"tube_length\"");
    row("gate in another unit", "\"unit\": \"count\"", "\"unit\": \"mm\"", "$.gates[1].unit: \"mm\"");
    row("gate without end", "\"unit\": \"count\", \"maximum\": 1", "\"unit\": \"count\"",
        "$.gates[1].maximum: missing");
    row("gate upside down", "\"unit\": \"count\", \"maximum\": 1",
        "\"unit\": \"count\", \"minimum\": 2, \"maximum\": 1", "$.gates[1].minimum: 2");
    row("gated twice", "\"metric\": \"apex_misses\", \"unit\": \"count\"",
        "\"metric\": \"apex_error_mean\", \"unit\": \"% of R\"", "$.gates[1].metric: \"apex_error_mean\"");
    row("nothing seen, no force", "\"needs_force\": true", "\"needs_force\": false", "$.needs_force: false");
    row("mounting of a device that stands as it is built", "\"needs_force\": true,",
        "\"needs_force\": true, \"mounting\": [{\"turn_deg\": 5}],", "$.mounting: given");
    row("base turned too far", "\"needs_force\": true,",
        "\"needs_force\": true, \"mounting\": [{\"tilt_deg\": 46}],", "$.mounting[0].tilt_deg: 46");
    row("base without a shift in metres", "\"needs_force\": true,",
        "\"needs_force\": true, \"mounting\": [{\"shift_x_m\": 0.01}],",
        "$.mounting[0].shift_x_m: unknown key");
    row("variant shows the object", "\"cues\": [\"tool\", \"arrow\"", "\"cues\": [\"object\", \"arrow\"",
        "$.shown_force_variant.cues: \"object\"");
    row("unknown cue", "\"cues\": [\"tool\", \"arrow\"", "\"cues\": [\"tool\", \"arow\"",
        "$.shown_force_variant.cues[1]: \"arow\"");
    row("cue twice", "\"cues\": [\"tool\", \"arrow\"", "\"cues\": [\"tool\", \"tool\"",
        "$.shown_force_variant.cues[1]: \"tool\"");
    row("name of another file", "\"id\": \"decoy_dimple\"", "\"id\": \"dimple\"", "$.id: \"dimple\"");
    row("control character", "\"title\": \"Decoy dimple\"", "\"title\": \"Decoy\\u0007dimple\"",
        "$.title: \"Decoy\\u0007dimple\"");
    row("a text in no language", "\"title\": \"Decoy dimple\"", "\"title\": {}", "$.title: an object");
    row("a text without English", "\"title\": \"Decoy dimple\"", "\"title\": {\"de\": \"Delle\"}",
        "$.title.en: missing");
    row("a text with a stray key", "\"title\": \"Decoy dimple\"",
        "\"title\": {\"en\": \"Dimple\", \"German\": \"Delle\"}", "$.title.German: unknown key");
}

void TestContentFaults::crossChecks() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QByteArray, path);
    ContentCopy copy;
    QByteArray text = copy.read(kLevel);
    QVERIFY(text.contains(from));
    copy.write(kLevel, text.replace(from, to));
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY(!catalogue.has_value());
    const QByteArray message = QByteArray::fromStdString(catalogue.error().message);
    QVERIFY2(message.startsWith(copy.path(kLevel).toUtf8() + ':'), message.constData());
    QVERIFY2(message.contains(' ' + path), message.constData());
    QVERIFY(message.contains(": expected "));
}

void TestContentFaults::softOrgans_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("path");
    const auto row = [](const char* tag, const char* from, const char* to, const char* path) {
        QTest::newRow(tag) << QByteArray(from) << QByteArray(to) << QByteArray(path);
    };
    row("answers later than the next question", "\"slow_period_ms\": 33", "\"slow_period_ms\": 32",
        "$.parameters.slow_latency_ms: 33");
    row("answers too soon to blend", "\"slow_latency_ms\": 33", "\"slow_latency_ms\": 19",
        "$.parameters.slow_latency_ms: 19");
    row("too fine to be simulated", "\"mesh_edge_mm\": 1.5", "\"mesh_edge_mm\": 0.6",
        "$.parameters.mesh_edge_mm: 0.6 mm");
    // within what this schema allows, but no organ can be made of it: told when it is loaded, not when it is
    // touched
    row("cannot be made", "\"organ_deepest_mm\": 8", "\"organ_deepest_mm\": 60",
        "$.parameters.surface: a dome that cannot be made");
}

void TestContentFaults::softOrgans() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QByteArray, path);
    const QString level = QStringLiteral("exercises/sphere_apex/levels/soft_organ.json");
    const QString schema = QStringLiteral("schema/sphere_apex_parameters.json");
    ContentCopy copy;
    QJsonObject wider = QJsonDocument::fromJson(copy.read(schema)).object();
    QJsonObject properties = wider["properties"].toObject();
    QJsonObject deepest = properties["organ_deepest_mm"].toObject();
    deepest["maximum"] = 100;
    properties["organ_deepest_mm"] = deepest;
    wider["properties"] = properties;
    copy.write(schema, QJsonDocument(wider).toJson());
    QByteArray text = copy.read(level);
    QVERIFY(text.contains(from));
    copy.write(level, text.replace(from, to));
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY(!catalogue.has_value());
    const QByteArray message = QByteArray::fromStdString(catalogue.error().message);
    QVERIFY2(message.startsWith(copy.path(level).toUtf8() + ':') && message.contains(path),
             message.constData());
}

void TestContentFaults::missingFolderAndFiles() {
    QVERIFY(!Catalogue::load("/no/such/folder"));
    for (const char* file :
         {"exercises/sphere_apex/exercise.json", "schema/level.json", "schema/exercise.json",
          "schema/sphere_apex_parameters.json", "schema/translated_text.json", "schema/cues.json"}) {
        ContentCopy copy;
        QFile::remove(copy.path(file));
        const auto catalogue = Catalogue::load(copy.directory());
        QVERIFY2(!catalogue.has_value(), file);
        QVERIFY(catalogue.error().message.find(file) != std::string::npos);
    }
    ContentCopy unknown;
    QDir().rename(unknown.path("exercises/sphere_apex"), unknown.path("exercises/cube_apex"));
    QVERIFY(Catalogue::load(unknown.directory()).error().message.find("$.id") != std::string::npos);
}

void TestContentFaults::levelNumbersWithoutGap() {
    ContentCopy copy;
    QFile::remove(copy.path("exercises/sphere_apex/levels/haptics_alone.json"));
    const auto gap = Catalogue::load(copy.directory());
    QVERIFY(!gap && gap.error().message.find("varied_material.json: $.number: 3") != std::string::npos);
    for (const char* level : {"visible", "varied_material", "decoy_dimple"})
        QFile::remove(copy.path(QStringLiteral("exercises/sphere_apex/levels/%1.json").arg(level)));
    QVERIFY(!Catalogue::load(copy.directory()));
}

void TestContentFaults::allFaultsOfAFileTogether() {
    ContentCopy copy;
    QByteArray text = copy.read(kLevel);
    text.replace("\"radius_mm\": 20", "\"raduis_mm\": 20")
        .replace("\"trials\": 10", "\"trials\": 0")
        .replace("\"needs_force\": true", "\"needs_force\": 1");
    copy.write(kLevel, text);
    const auto catalogue = Catalogue::load(copy.directory());
    const QString message = QString::fromStdString(catalogue.error().message);
    QVERIFY(message.contains(
        "$.parameters.raduis_mm: unknown key: expected a key of the schema; did you mean \"radius_mm\"?"));
    QVERIFY(message.contains("$.parameters.trials: 0: expected a whole number, 1 to 32"));
    QVERIFY(message.contains("$.needs_force: 1: expected true or false"));
    QCOMPARE(message.count(u'\n'), 2);
}

void TestContentFaults::badSchemaIsRefused() {
    const std::vector<std::pair<QByteArray, QByteArray>> changes{
        {"\"unit\": \"mm\"", "\"unit\": \"\""},     // a number without unit
        {"\"maximum\": 50,", ""},                   // or without range
        {"\"default\": 20", "\"default\": 60"},     // a default out of it
        {"\"default\": 20", "\"pattern\": \".*\""}, // a keyword we have not
        {"\"type\": \"object\"", "\"type\": \"thing\""}};
    for (const auto& [from, to] : changes) {
        ContentCopy copy;
        const QString file = QStringLiteral("schema/sphere_apex_parameters.json");
        QByteArray text = copy.read(file);
        QVERIFY2(text.contains(from), from.constData());
        copy.write(file, text.replace(from, to));
        const auto catalogue = Catalogue::load(copy.directory());
        QVERIFY2(!catalogue.has_value(), to.constData());
        QVERIFY2(catalogue.error().message.find("sphere_apex_parameters.json:") != std::string::npos,
                 catalogue.error().message.c_str());
    }
    ContentCopy circle;
    circle.write("schema/cues.json", "{\"$ref\": \"cues.json\", \"description\": \"x\"}");
    QVERIFY(!Catalogue::load(circle.directory()));
}

QTEST_APPLESS_MAIN(TestContentFaults)
#include "test_content_faults.moc"
