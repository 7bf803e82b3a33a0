// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/canonical_json.h"
#include "catalogue/catalogue.h"
#include "support/content_copy.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <tuple>

using namespace chiron;
using namespace chiron::catalogue;
using simulation::SphereApexParameters;

namespace {

const QString kLevel = QStringLiteral("exercises/sphere_apex/levels/decoy_dimple.json");

auto fields(const SphereApexParameters& p) {
    return std::tie(p.radius_m, p.planeHeight_m, p.centreDiscRadius_m, p.workspaceRadius_m, p.stiffnessLow_N_per_m,
                    p.stiffnessHigh_N_per_m, p.stiffnessVariation, p.stiffnessWavelength_m, p.damping_Ns_per_m,
                    p.frictionLow, p.frictionHigh, p.bristleStiffness_N_per_m, p.dimpleDepth_m, p.dimpleRadius_m,
                    p.dimpleOffset_m, p.trials, p.trialLimit_s, p.betweenTrials_s, p.maximumForce_N, p.cues);
}

const SphereApexParameters& parametersOf(const ExerciseLevel& level) {
    return std::get<SphereApexParameters>(level.parameters);
}

QJsonObject json(const std::string& text) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
}

} // namespace

class TestCatalogue : public QObject {
    Q_OBJECT
private slots:
    void valuesReachTheStruct();
    void everyParameterKeyReachesTheStruct();
    void resolvedLevelRebuildsItself();
    void resolvedLevelReadsNoFile();
    void resolvedLevelHasEveryDefault();
    void olderContentKeepsItsMeaning();
    void damagedResolvedLevelIsRefused_data();
    void damagedResolvedLevelIsRefused();
    void spellingChangesNoDigest();
    void crossChecks_data();
    void crossChecks();
    void missingFolderAndFiles();
    void levelNumbersWithoutGap();
    void newLevelNeedsOnlyItsFile();
    void allFaultsOfAFileTogether();
    void badSchemaIsRefused();
    void contentFolderIsFound();
};

void TestCatalogue::valuesReachTheStruct() {
    const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    const ExerciseLevel* level = catalogue->find("sphere_apex", 4);
    QVERIFY(level != nullptr);
    QCOMPARE(level->id, std::string("decoy_dimple"));
    QCOMPARE(level->exercise, std::string("sphere_apex"));
    QCOMPARE(parametersOf(*level).radius_m, 0.020);
    QCOMPARE(parametersOf(*level).dimpleDepth_m, 0.002);
    QCOMPARE(parametersOf(*level).trials, 10);
    QVERIFY(level->needsForce && level->shownForce.has_value() && level->cues.empty());
    QCOMPARE(level->gates.at(0).metric, std::string("apex_error_mean"));
    QCOMPARE(level->gates.at(0).maximum.value(), 20.0);
    QCOMPARE(level->metrics.at(0).version, 1);
    QCOMPARE(textIn(level->title, "de"), std::string("Täuschende Delle"));
    QCOMPARE(textIn(level->title, "fr"), std::string("Decoy dimple"));
    QCOMPARE(catalogue->find("sphere_apex", 0), nullptr);
    QCOMPARE(catalogue->find("sphere_apex", 5), nullptr);
    QCOMPARE(catalogue->find("sphere", 1), nullptr);
}

// Each key of the schema, set to something else, must change the struct: none is read and dropped.
void TestCatalogue::everyParameterKeyReachesTheStruct() {
    const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    const std::string stored = catalogue->find("sphere_apex", 1)->resolvedJson;
    const auto before = fromResolvedJson(stored);
    QJsonObject document = json(stored);
    QJsonObject level = document["level"].toObject();
    const QJsonObject parameters = level["parameters"].toObject();
    QCOMPARE(parameters.size(), qsizetype{19}); // all of SphereApexParameters but the cues
    for (const QString& key : parameters.keys()) {
        QJsonObject changed = parameters;
        changed[key] = parameters[key].toDouble() + 1.0;
        level["parameters"] = changed;
        document["level"] = level;
        const auto after = fromResolvedJson(canonicalJson(document));
        QVERIFY2(after.has_value(), qPrintable(key));
        QVERIFY2(fields(parametersOf(*after)) != fields(parametersOf(*before)), qPrintable(key));
    }
}

void TestCatalogue::resolvedLevelRebuildsItself() {
    const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    for (const ExerciseLevel& level : catalogue->exercises().at(0).levels) {
        const auto again = fromResolvedJson(level.resolvedJson);
        QVERIFY2(again.has_value(), again ? "" : again.error().message.c_str());
        QVERIFY(fields(parametersOf(*again)) == fields(parametersOf(level)));
        QCOMPARE(again->resolvedJson, level.resolvedJson);
        QCOMPARE(again->resolvedSha256, level.resolvedSha256);
        QCOMPARE(level.resolvedSha256, sha256Hex(level.resolvedJson));
        QCOMPARE(again->id, level.id);
        QCOMPARE(again->number, level.number);
        QVERIFY(again->title == level.title && again->objective == level.objective && again->cues == level.cues);
        QCOMPARE(again->needsForce, level.needsForce);
        QCOMPARE(again->shownForce.has_value(), level.shownForce.has_value());
        QCOMPARE(again->gates.size(), level.gates.size());
        QCOMPARE(again->metrics.size(), level.metrics.size());
    }
}

void TestCatalogue::resolvedLevelReadsNoFile() {
    ContentCopy copy;
    const auto before = Catalogue::load(copy.directory());
    const std::string stored = before->find("sphere_apex", 4)->resolvedJson;
    QByteArray text = copy.read(kLevel);
    text.replace("\"dimple_depth_mm\": 2", "\"dimple_depth_mm\": 1");
    copy.write(kLevel, text);
    const auto after = Catalogue::load(copy.directory());
    QVERIFY(after->find("sphere_apex", 4)->resolvedSha256 != before->find("sphere_apex", 4)->resolvedSha256);
    QDir(QString::fromStdString(copy.directory())).removeRecursively();
    const auto again = fromResolvedJson(stored);
    QVERIFY(again.has_value());
    QCOMPARE(parametersOf(*again).dimpleDepth_m, 0.002);
}

void TestCatalogue::resolvedLevelHasEveryDefault() {
    ContentCopy copy;
    QJsonObject level = QJsonDocument::fromJson(copy.read(kLevel)).object();
    level["parameters"] = QJsonObject{};
    copy.write(kLevel, QJsonDocument(level).toJson());
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    SphereApexParameters defaults; // the schema's defaults are the struct's
    QVERIFY(fields(parametersOf(*catalogue->find("sphere_apex", 4))) == fields(defaults));
    const QJsonObject resolved = json(catalogue->find("sphere_apex", 4)->resolvedJson);
    QCOMPARE(resolved["level"].toObject()["parameters"].toObject().size(), qsizetype{19});
}

// A key made after a session was stored is not in it; the struct's default stands for what the code did then.
void TestCatalogue::olderContentKeepsItsMeaning() {
    const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QJsonObject document = json(catalogue->find("sphere_apex", 2)->resolvedJson);
    QJsonObject level = document["level"].toObject();
    QJsonObject parameters = level["parameters"].toObject();
    parameters.remove("dimple_depth_mm");
    level["parameters"] = parameters;
    document["level"] = level;
    const auto old = fromResolvedJson(canonicalJson(document));
    QVERIFY(old.has_value());
    QCOMPARE(parametersOf(*old).dimpleDepth_m, 0.0);
}

void TestCatalogue::damagedResolvedLevelIsRefused_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("mentions");
    const auto row = [](const char* tag, const char* from, const char* to, const char* mentions) {
        QTest::newRow(tag) << QByteArray(from) << QByteArray(to) << QByteArray(mentions);
    };
    row("newer format", "\"format\":1", "\"format\":2", "$.format");
    row("unknown exercise", "{\"id\":\"sphere_apex\"", "{\"id\":\"cube_apex\"", "$.exercise.id");
    row("unknown parameter", "\"friction_low\"", "\"friction_loww\"", "$.parameters.friction_loww");
    row("text for number", "\"radius_mm\":20", "\"radius_mm\":\"20\"", "$.parameters.radius_mm");
    row("half a trial", "\"trials\":10", "\"trials\":10.5", "$.parameters.trials");
    row("no number", "\"number\":1,", "", "$.number");
    row("no English", "\"en\":\"Visible sphere\"", "\"xx\":\"Visible sphere\"", "$.title.en");
    row("not JSON", "{\"exercise\"", "{{\"exercise\"", "stored content:1:");
}

void TestCatalogue::damagedResolvedLevelIsRefused() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QByteArray, mentions);
    const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QByteArray text = QByteArray::fromStdString(catalogue->find("sphere_apex", 1)->resolvedJson);
    QVERIFY(text.contains(from));
    text.replace(from, to);
    const auto level = fromResolvedJson(text.toStdString());
    QVERIFY(!level.has_value());
    QVERIFY2(level.error().message.find(mentions.toStdString()) != std::string::npos, level.error().message.c_str());
}

void TestCatalogue::spellingChangesNoDigest() {
    ContentCopy copy;
    const auto before = Catalogue::load(copy.directory());
    copy.write(kLevel, QJsonDocument::fromJson(copy.read(kLevel)).toJson(QJsonDocument::Compact));
    QByteArray spelled = copy.read(kLevel);
    spelled.replace("\"radius_mm\":20", " \"radius_mm\" : 2.0e1");
    copy.write(kLevel, spelled);
    const auto after = Catalogue::load(copy.directory());
    QVERIFY(after.has_value());
    QCOMPARE(after->find("sphere_apex", 4)->resolvedSha256, before->find("sphere_apex", 4)->resolvedSha256);
}

void TestCatalogue::crossChecks_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("path");
    const auto row = [](const char* tag, const char* from, const char* to, const char* path) {
        QTest::newRow(tag) << QByteArray(from) << QByteArray(to) << QByteArray(path);
    };
    row("stiffness order", "\"stiffness_low_N_per_m\": 500", "\"stiffness_low_N_per_m\": 501", "$.parameters.stiffness_low_N_per_m: 501");
    row("friction order", "\"friction_low\": 0", "\"friction_low\": 0.1", "$.parameters.friction_low: 0.1");
    row("sphere leaves workspace", "\"centre_disc_radius_mm\": 40", "\"centre_disc_radius_mm\": 46", "$.parameters.centre_disc_radius_mm: 46 mm");
    row("dimple on the apex", "\"dimple_offset_mm\": 10", "\"dimple_offset_mm\": 5.9", "$.parameters.dimple_offset_mm: 5.9 mm");
    row("dimple off the ball", "\"dimple_offset_mm\": 10", "\"dimple_offset_mm\": 14.5", "$.parameters.dimple_radius_mm: 6 mm");
    row("unknown metric", "{\"id\": \"sparc\"", "{\"id\": \"spark\"", "$.metrics[9].id: \"spark\"");
    row("unknown version", "{\"id\": \"time\", \"version\": 1}", "{\"id\": \"time\", \"version\": 9}", "$.metrics[3].version: 9");
    row("metric twice", "{\"id\": \"ldlj\"", "{\"id\": \"sparc\"", "$.metrics[10].id: \"sparc\"");
    row("gate on what is not computed", "{\"metric\": \"apex_misses\"", "{\"metric\": \"tube_length\"", "$.gates[1].metric: \"tube_length\"");
    row("gate in another unit", "\"unit\": \"count\"", "\"unit\": \"mm\"", "$.gates[1].unit: \"mm\"");
    row("gate without end", "\"unit\": \"count\", \"maximum\": 1", "\"unit\": \"count\"", "$.gates[1].maximum: missing");
    row("gate upside down", "\"unit\": \"count\", \"maximum\": 1", "\"unit\": \"count\", \"minimum\": 2, \"maximum\": 1", "$.gates[1].minimum: 2");
    row("gated twice", "\"metric\": \"apex_misses\", \"unit\": \"count\"", "\"metric\": \"apex_error_mean\", \"unit\": \"% of R\"", "$.gates[1].metric: \"apex_error_mean\"");
    row("nothing seen, no force", "\"needs_force\": true", "\"needs_force\": false", "$.needs_force: false");
    row("variant shows the object", "\"cues\": [\"tool\", \"arrow\"", "\"cues\": [\"object\", \"arrow\"", "$.shown_force_variant.cues: \"object\"");
    row("unknown cue", "\"cues\": [\"tool\", \"arrow\"", "\"cues\": [\"tool\", \"arow\"", "$.shown_force_variant.cues[1]: \"arow\"");
    row("cue twice", "\"cues\": [\"tool\", \"arrow\"", "\"cues\": [\"tool\", \"tool\"", "$.shown_force_variant.cues[1]: \"tool\"");
    row("name of another file", "\"id\": \"decoy_dimple\"", "\"id\": \"dimple\"", "$.id: \"dimple\"");
    row("control character", "\"en\": \"Decoy dimple\"", "\"en\": \"Decoy\\u0007dimple\"", "$.title.en: \"Decoy\\u0007dimple\"");
}

void TestCatalogue::crossChecks() {
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

void TestCatalogue::missingFolderAndFiles() {
    QVERIFY(!Catalogue::load("/no/such/folder"));
    for (const char* file : {"exercises/sphere_apex/exercise.json", "schema/level.json", "schema/exercise.json",
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

void TestCatalogue::levelNumbersWithoutGap() {
    ContentCopy copy;
    QFile::remove(copy.path("exercises/sphere_apex/levels/haptics_alone.json"));
    const auto gap = Catalogue::load(copy.directory());
    QVERIFY(!gap && gap.error().message.find("varied_material.json: $.number: 3") != std::string::npos);
    for (const char* level : {"visible", "varied_material", "decoy_dimple"})
        QFile::remove(copy.path(QStringLiteral("exercises/sphere_apex/levels/%1.json").arg(level)));
    QVERIFY(!Catalogue::load(copy.directory()));
}

void TestCatalogue::newLevelNeedsOnlyItsFile() {
    ContentCopy copy;
    QByteArray text = copy.read(kLevel);
    text.replace("\"decoy_dimple\"", "\"two_millimetres\"").replace("\"number\": 4", "\"number\": 5");
    copy.write("exercises/sphere_apex/levels/two_millimetres.json", text);
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    QCOMPARE(catalogue->find("sphere_apex", 5)->id, std::string("two_millimetres"));
}

void TestCatalogue::allFaultsOfAFileTogether() {
    ContentCopy copy;
    QByteArray text = copy.read(kLevel);
    text.replace("\"radius_mm\": 20", "\"raduis_mm\": 20").replace("\"trials\": 10", "\"trials\": 0").replace("\"needs_force\": true", "\"needs_force\": 1");
    copy.write(kLevel, text);
    const auto catalogue = Catalogue::load(copy.directory());
    const QString message = QString::fromStdString(catalogue.error().message);
    QVERIFY(message.contains("$.parameters.raduis_mm: unknown key: expected a key of the schema; did you mean \"radius_mm\"?"));
    QVERIFY(message.contains("$.parameters.trials: 0: expected a whole number, 1 to 32"));
    QVERIFY(message.contains("$.needs_force: 1: expected true or false"));
    QCOMPARE(message.count(u'\n'), 2);
}

void TestCatalogue::badSchemaIsRefused() {
    const std::vector<std::pair<QByteArray, QByteArray>> changes{
        {"\"unit\": \"mm\"", "\"unit\": \"\""},                       // a number without unit
        {"\"maximum\": 50,", ""},                                   // or without range
        {"\"default\": 20", "\"default\": 60"},                       // a default out of it
        {"\"default\": 20", "\"pattern\": \".*\""},                   // a keyword we have not
        {"\"type\": \"object\"", "\"type\": \"thing\""}};
    for (const auto& [from, to] : changes) {
        ContentCopy copy;
        const QString file = QStringLiteral("schema/sphere_apex_parameters.json");
        QByteArray text = copy.read(file);
        QVERIFY2(text.contains(from), from.constData());
        copy.write(file, text.replace(from, to));
        const auto catalogue = Catalogue::load(copy.directory());
        QVERIFY2(!catalogue.has_value(), to.constData());
        QVERIFY2(catalogue.error().message.find("sphere_apex_parameters.json:") != std::string::npos, catalogue.error().message.c_str());
    }
    ContentCopy circle;
    circle.write("schema/cues.json", "{\"$ref\": \"cues.json\", \"description\": \"x\"}");
    QVERIFY(!Catalogue::load(circle.directory()));
}

void TestCatalogue::contentFolderIsFound() {
    ContentCopy copy;
    qunsetenv("CHIRON_CONTENT");
    QCOMPARE(findContentDirectory(copy.directory()).value(), copy.directory());
    QVERIFY(findContentDirectory().has_value()); // the source tree at least
    qputenv("CHIRON_CONTENT", QByteArray::fromStdString(copy.directory()));
    QCOMPARE(findContentDirectory().value(), copy.directory());
    qputenv("CHIRON_CONTENT", "/no/such/folder");
    const auto wrong = findContentDirectory(); // what was asked for is not replaced in silence
    QVERIFY(!wrong && wrong.error().message.find("/no/such/folder") != std::string::npos);
    qunsetenv("CHIRON_CONTENT");
}

QTEST_APPLESS_MAIN(TestCatalogue)
#include "test_catalogue.moc"
