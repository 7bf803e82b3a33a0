// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/canonical_json.h"
#include "catalogue/catalogue.h"
#include "core/units.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "support/content_copy.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <tuple>

using namespace chiron;
using namespace chiron::catalogue;
using simulation::SphereApexParameters;

namespace {

const QString kLevel = QStringLiteral("exercises/sphere_apex/levels/decoy_dimple.json");

auto fields(const SphereApexParameters& p) {
    return std::tie(p.radius_m, p.planeHeight_m, p.centreDiscRadius_m, p.workspaceRadius_m,
                    p.stiffnessLow_N_per_m, p.stiffnessHigh_N_per_m, p.stiffnessVariation,
                    p.stiffnessWavelength_m, p.damping_Ns_per_m, p.frictionLow, p.frictionHigh,
                    p.bristleStiffness_N_per_m, p.dimpleDepth_m, p.dimpleRadius_m, p.dimpleOffset_m, p.trials,
                    p.trialLimit_s, p.betweenTrials_s, p.maximumForce_N, p.cues, p.surface, p.meshEdge_m,
                    p.bumpHeight_m, p.bumpWavelength_m, p.bumpSeed, p.roughness_m, p.roughnessWavelength_m,
                    p.organStiffness_N_per_m, p.organSpread_m, p.organMass_kg, p.organRecoveryTime_s,
                    p.organVolumeKeeping, p.organDeepest_m, p.slowPeriod_ms, p.slowLatency_ms,
                    p.yield.force_N, p.yield.fall_s);
}

const SphereApexParameters& parametersOf(const ExerciseLevel& level) {
    return level.parameters.as<SphereApexParameters>();
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
    void mountingIsKept();
    void resolvedLevelReadsNoFile();
    void resolvedLevelHasEveryDefault();
    void olderContentKeepsItsMeaning();
    void damagedResolvedLevelIsRefused_data();
    void damagedResolvedLevelIsRefused();
    void spellingChangesNoDigest();
    void newLevelNeedsOnlyItsFile();
    void contentFolderIsFound();
    void aTriedLevelHasFewerTrialsAndNothingElse();
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
    QCOMPARE(level->metrics.at(0).version, 1); // P2's own measure
    QCOMPARE(level->metrics.at(6).id, std::string("force_time_over_limit"));
    QCOMPARE(level->metrics.at(6).version, 2);
    QCOMPARE(textIn(level->title, "de"), std::string("Täuschende Delle"));
    QCOMPARE(textIn(level->title, "xx"), std::string("Decoy dimple"));
    QCOMPARE(catalogue->find("sphere_apex", 0), nullptr);
    QCOMPARE(catalogue->find("sphere_apex", 7), nullptr);
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
    QCOMPARE(parameters.size(), qsizetype{36}); // all of SphereApexParameters but the cues
    for (const QString& key : parameters.keys()) {
        QJsonObject changed = parameters;
        changed[key] =
            parameters[key].isString() ? QJsonValue("mesh") : QJsonValue(parameters[key].toDouble() + 1.0);
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
        QVERIFY(again->title == level.title && again->objective == level.objective &&
                again->cues == level.cues);
        QCOMPARE(again->needsForce, level.needsForce);
        QCOMPARE(again->shownForce.has_value(), level.shownForce.has_value());
        QCOMPARE(again->gates.size(), level.gates.size());
        QCOMPARE(again->metrics.size(), level.metrics.size());
    }
}

// P2's flexible mounting as content: origin, scale, mirror and turn of each base; stored content without it
// stands as it did.
void TestCatalogue::mountingIsKept() {
    const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QJsonObject document = json(catalogue->find("elastic_tube", 4)->resolvedJson);
    QJsonObject level = document["level"].toObject();
    level.remove("mounting"); // as of before there was one
    document["level"] = level;
    const auto before = fromResolvedJson(canonicalJson(document));
    QVERIFY(before && before->mounting.empty());
    const QJsonObject usual{{"shift_x_mm", 0},   {"shift_y_mm", 0}, {"shift_z_mm", 0}, {"scale", 1},
                            {"mirrored", false}, {"turn_deg", 0},   {"tilt_deg", 0},   {"roll_deg", 0}};
    const QJsonObject turned{{"shift_x_mm", 4},  {"shift_y_mm", -5}, {"shift_z_mm", 6}, {"scale", 2},
                             {"mirrored", true}, {"turn_deg", 10},   {"tilt_deg", -20}, {"roll_deg", 30}};
    level["mounting"] = QJsonArray{usual, turned};
    document["level"] = level;
    const auto after = fromResolvedJson(canonicalJson(document));
    QVERIFY2(after.has_value(), after ? "" : after.error().message.c_str());
    QCOMPARE(after->mounting.size(), std::size_t{2});
    QVERIFY(!after->mounting[0].turned() && after->mounting[0].scale == 1.0 &&
            !after->mounting[0].leftHanded);
    const core::BaseMounting& base = after->mounting[1];
    QVERIFY(std::abs(base.origin_m[0] - 0.004) < 1e-12 && std::abs(base.origin_m[1] + 0.005) < 1e-12 &&
            std::abs(base.origin_m[2] - 0.006) < 1e-12);
    QVERIFY(base.scale == 2.0 && base.leftHanded);
    QVERIFY(std::abs(base.turn_rad[0] - core::radFromDeg(10.0)) < 1e-12 &&
            std::abs(base.turn_rad[1] + core::radFromDeg(20.0)) < 1e-12 &&
            std::abs(base.turn_rad[2] - core::radFromDeg(30.0)) < 1e-12);
    QVERIFY(after->resolvedSha256 != before->resolvedSha256);
    QCOMPARE(fromResolvedJson(after->resolvedJson)->resolvedSha256, after->resolvedSha256);
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
    QCOMPARE(resolved["level"].toObject()["parameters"].toObject().size(), qsizetype{36});
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
    QVERIFY2(level.error().message.find(mentions.toStdString()) != std::string::npos,
             level.error().message.c_str());
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

void TestCatalogue::newLevelNeedsOnlyItsFile() {
    ContentCopy copy;
    QByteArray text = copy.read(kLevel);
    text.replace("\"decoy_dimple\"", "\"two_millimetres\"").replace("\"number\": 4", "\"number\": 7");
    copy.write("exercises/sphere_apex/levels/two_millimetres.json", text);
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    QCOMPARE(catalogue->find("sphere_apex", 7)->id, std::string("two_millimetres"));
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

void TestCatalogue::aTriedLevelHasFewerTrialsAndNothingElse() {
    const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QVERIFY2(catalogue, catalogue ? "" : catalogue.error().message.c_str());
    for (const Exercise& exercise : catalogue->exercises())
        for (const ExerciseLevel& level : exercise.levels) {
            const auto tried = withTrials(level, 3);
            QVERIFY2(tried, tried ? "" : tried.error().message.c_str());
            QJsonObject was = json(level.resolvedJson), now = json(tried->resolvedJson);
            const auto trialsOf = [](const QJsonObject& document) {
                return document["level"].toObject()["parameters"].toObject()["trials"].toInt();
            };
            QCOMPARE(trialsOf(now), std::min(3, trialsOf(was)));
            QCOMPARE(tried->resolvedSha256 == level.resolvedSha256, trialsOf(was) <= 3);
            for (QJsonObject* document : {&was, &now}) {
                QJsonObject inner = (*document)["level"].toObject();
                QJsonObject parameters = inner["parameters"].toObject();
                parameters.remove("trials");
                inner["parameters"] = parameters;
                (*document)["level"] = inner;
            }
            QCOMPARE(now, was);
        }
    const ExerciseLevel* apex = catalogue->find("sphere_apex", 1);
    QVERIFY(apex);
    QCOMPARE(parametersOf(*withTrials(*apex, 3)).trials, 3);
    QCOMPARE(withTrials(*apex, 0)->resolvedJson, apex->resolvedJson);
    QCOMPARE(withTrials(*apex, 1000)->resolvedJson, apex->resolvedJson);
}

QTEST_APPLESS_MAIN(TestCatalogue)
#include "test_catalogue.moc"
