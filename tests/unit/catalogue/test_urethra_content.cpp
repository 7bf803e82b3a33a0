// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/canonical_json.h"
#include "catalogue/catalogue.h"
#include "core/units.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "support/content_copy.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::catalogue;
using Parameters = simulation::UrethraInsertionParameters;

namespace {

const QString kLevel = QStringLiteral("exercises/urethra_insertion/levels/stricture.json");

const Catalogue& shipped() {
    static const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue;
}

const Parameters& parametersOf(const ExerciseLevel& level) {
    return level.parameters.as<Parameters>();
}

QJsonObject json(const std::string& text) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
}

bool near(double a, double b) {
    return a == b || std::abs(a - b) <= 1e-12 * std::max(1.0, std::abs(b));
}

/// Every number of the struct, in one order.
std::vector<double> numbers(const Parameters& p) {
    const auto& a = p.anatomy;
    std::vector<double> n{a.curvature_per_m,
                          a.straight_m,
                          a.pivotSpan_m,
                          a.zEnd_m,
                          a.radius_m,
                          a.wallStiffness_N_per_m3,
                          a.wallStiffening_per_m,
                          a.friction,
                          a.viscosity_Ns_per_m2,
                          a.wallRetardation_s,
                          a.freeLength_m,
                          a.freeBlend_m,
                          a.freeHold_N_per_m,
                          a.angularStiffness_Nm_per_rad,
                          a.angularCorner_m,
                          a.bladderRadius_m,
                          a.bladderStiffness_N_per_m,
                          a.bladderOpening_rad,
                          a.bladderOpeningEdge_rad,
                          p.endoscope.radius_m,
                          p.endoscope.beak_m,
                          p.endoscope.behind_m,
                          p.endoscope.fieldOfView_rad,
                          p.forces.count_m,
                          p.forces.maximumStep_m,
                          p.forces.maximumDamping_Ns_per_m,
                          double(p.forces.basicSections),
                          double(p.forces.sections == simulation::ForceSections::p1Basic),
                          double(p.mesh.n),
                          double(p.mesh.w),
                          double(p.mesh.perPatch),
                          double(p.mesh.movingSections),
                          p.pose.p_WA.x(),
                          p.pose.p_WA.y(),
                          p.pose.p_WA.z(),
                          p.goalDepth_m,
                          double(p.withdraws),
                          p.landmarkHalfAngle_rad,
                          p.landmarkDistance_m,
                          p.landmarkHold_s,
                          p.landmarkSpeed_m_per_s,
                          p.trialLimit_s,
                          p.maximumForce_N,
                          p.maximumTorque_Nm,
                          p.lateralLimit_N,
                          double(p.depthOfField),
                          double(p.depthOfFieldFixed),
                          p.meatus_m,
                          p.yield.force_N,
                          p.yield.fall_s,
                          p.yield.torque_Nm};
    n.push_back(double(a.changeCount));
    for (std::size_t i = 0; i < a.changeCount; ++i)
        n.insert(n.end(), {a.changes[i].centre_m, a.changes[i].length_m, a.changes[i].edge_m,
                           a.changes[i].radius_m, a.changes[i].stiffnessFactor, a.changes[i].frictionFactor});
    n.push_back(double(p.landmarks.size()));
    for (const auto& landmark : p.landmarks)
        n.insert(n.end(), {landmark.polar_rad, landmark.azimuth_rad});
    return n;
}

} // namespace

class TestUrethraContent : public QObject {
    Q_OBJECT
private slots:
    void fiveLevels();
    void presetsReachTheStruct();
    void everyParameterKeyReachesTheStruct();
    void schemaDefaultsAreTheStructs();
    void levelOverridesItsPreset();
    void resolvedLevelNeedsNoPreset();
    void olderContentKeepsItsMeaning();
    void faults_data();
    void faults();
    void aThinEndoscopeIsAllowed();
};

void TestUrethraContent::fiveLevels() {
    const auto& levels = shipped().find("urethra_insertion")->levels;
    QCOMPARE(levels.size(), std::size_t{5});
    const char* ids[] = {"guided_straight", "bend", "standard", "stricture", "unguided"};
    for (std::size_t i = 0; i < 5; ++i)
        QCOMPARE(levels[i].id, std::string(ids[i]));
    const auto has = [&](std::size_t i, const char* cue) {
        return std::find(levels[i].cues.begin(), levels[i].cues.end(), cue) != levels[i].cues.end();
    };
    for (std::size_t i = 0; i < 5; ++i) {
        QVERIFY(has(i, "object") && !levels[i].needsForce);
        QCOMPARE(has(i, "guidance"), i < 4);
        QCOMPARE(has(i, "overview"), i < 4);
        QCOMPARE(parametersOf(levels[i]).depthOfFieldFixed, i == 4);
        QVERIFY(parametersOf(levels[i]).withdraws);
    }
    QCOMPARE(parametersOf(levels[0]).goalDepth_m, 0.060);
    QCOMPARE(parametersOf(levels[1]).goalDepth_m, 0.095);
    QVERIFY(parametersOf(levels[1]).goalDepth_m >
            parametersOf(levels[1]).anatomy.freeLength_m); // past the bend
    QVERIFY(parametersOf(levels[0]).landmarks.empty() && parametersOf(levels[1]).landmarks.empty());
    for (std::size_t i = 2; i < 5; ++i)
        QCOMPARE(parametersOf(levels[i]).landmarks.size(), std::size_t{5});
    QVERIFY(parametersOf(levels[4]).depthOfField && !parametersOf(levels[2]).depthOfField);
}

void TestUrethraContent::presetsReachTheStruct() {
    const Parameters& normal = parametersOf(*shipped().find("urethra_insertion", 3));
    QCOMPARE(normal.tissue, std::string("normal"));
    QCOMPARE(normal.anatomy.changeCount, std::size_t{0});
    QVERIFY(near(normal.anatomy.wallStiffness_N_per_m3, 3.0e6));
    const Parameters& narrow = parametersOf(*shipped().find("urethra_insertion", 4));
    QCOMPARE(narrow.tissue, std::string("stricture"));
    QCOMPARE(narrow.anatomy.changeCount, std::size_t{1});
    QVERIFY(near(narrow.anatomy.changes[0].radius_m, 0.0015));
    QVERIFY(near(narrow.anatomy.changes[0].stiffnessFactor, 15.0));
    QVERIFY(near(narrow.anatomy.changes[0].length_m, 0.012));
}

// Each key of the schema, set to something else, must change the struct: none is read and dropped.
void TestUrethraContent::everyParameterKeyReachesTheStruct() {
    const std::string stored = shipped().find("urethra_insertion", 4)->resolvedJson;
    const auto before = fromResolvedJson(stored);
    QJsonObject document = json(stored);
    QJsonObject level = document["level"].toObject();
    const QJsonObject parameters = level["parameters"].toObject();
    QCOMPARE(parameters.size(), qsizetype{50});
    for (const QString& key : parameters.keys()) {
        QJsonObject changed = parameters;
        const QJsonValue value = parameters[key];
        if (value.isDouble())
            changed[key] = value.toDouble() + 1.0;
        else if (value.isBool())
            changed[key] = !value.toBool();
        else if (value.isArray())
            changed[key] = QJsonArray{};
        else
            changed[key] = key == "tissue" ? "other" : "p1_basic";
        level["parameters"] = changed;
        document["level"] = level;
        const auto after = fromResolvedJson(canonicalJson(document));
        QVERIFY2(after.has_value(), qPrintable(key));
        QVERIFY2(numbers(parametersOf(*after)) != numbers(parametersOf(*before)) ||
                     parametersOf(*after).tissue != parametersOf(*before).tissue,
                 qPrintable(key));
    }
}

void TestUrethraContent::schemaDefaultsAreTheStructs() {
    ContentCopy copy;
    QJsonObject level = QJsonDocument::fromJson(copy.read(kLevel)).object();
    level["parameters"] = QJsonObject{};
    copy.write(kLevel, QJsonDocument(level).toJson());
    const QString tissue =
        QStringLiteral("exercises/urethra_insertion/presets/normal.json"); // sets more than the defaults
    QJsonObject preset = QJsonDocument::fromJson(copy.read(tissue)).object();
    preset["parameters"] = QJsonObject{};
    copy.write(tissue, QJsonDocument(preset).toJson());
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    const std::vector<double> read = numbers(parametersOf(*catalogue->find("urethra_insertion", 4)));
    const std::vector<double> defaults = numbers(Parameters{});
    QCOMPARE(read.size(), defaults.size());
    for (std::size_t i = 0; i < read.size(); ++i)
        QVERIFY2(near(read[i], defaults[i]),
                 qPrintable(QStringLiteral("%1: %2, %3").arg(i).arg(read[i]).arg(defaults[i])));
    const QJsonObject resolved =
        json(catalogue->find("urethra_insertion", 4)->resolvedJson)["level"].toObject();
    QCOMPARE(resolved["parameters"].toObject().size(), qsizetype{50});
}

void TestUrethraContent::levelOverridesItsPreset() {
    ContentCopy copy;
    QByteArray text = copy.read(kLevel);
    copy.write(kLevel,
               text.replace("\"tissue\": \"stricture\"", "\"tissue\": \"stricture\", \"friction\": 0.2"));
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    const Parameters& p = parametersOf(*catalogue->find("urethra_insertion", 4));
    QCOMPARE(p.anatomy.friction, 0.2);
    QCOMPARE(p.anatomy.changeCount, std::size_t{1});
}

// What a session stores is whole: a preset edited or removed later changes no old replay.
void TestUrethraContent::resolvedLevelNeedsNoPreset() {
    ContentCopy copy;
    const std::string stored = Catalogue::load(copy.directory())->find("urethra_insertion", 4)->resolvedJson;
    QDir(QString::fromStdString(copy.directory())).removeRecursively();
    const auto again = fromResolvedJson(stored);
    QVERIFY(again.has_value());
    QCOMPARE(parametersOf(*again).anatomy.changeCount, std::size_t{1});
    QCOMPARE(again->resolvedJson, stored);
}

void TestUrethraContent::olderContentKeepsItsMeaning() {
    QJsonObject document = json(shipped().find("urethra_insertion", 4)->resolvedJson);
    QJsonObject level = document["level"].toObject();
    level["parameters"] = QJsonObject{};
    document["level"] = level;
    const auto old = fromResolvedJson(canonicalJson(document));
    QVERIFY(old.has_value());
    QVERIFY(numbers(parametersOf(*old)) == numbers(Parameters{}));
}

void TestUrethraContent::faults_data() {
    QTest::addColumn<QByteArray>("keys");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char* tag, const char* keys, const char* message) {
        QTest::newRow(tag) << QByteArray(keys) << QByteArray(message);
    };
    row("zero radius", "\"rest_radius_mm\": 0",
        "$.parameters.rest_radius_mm: 0: expected a number, 0.3 to 8 mm");
    row("negative stiffness", "\"wall_stiffness_N_per_m3\": -1",
        "$.parameters.wall_stiffness_N_per_m3: -1: expected a number, 10000 to 1e+08 N/m³");
    row("n below 4", "\"mesh_points\": 3", "$.parameters.mesh_points: 3: expected a whole number, 5 to 129");
    row("n is 4, three distinct points", "\"mesh_points\": 4",
        "$.parameters.mesh_points: 4: expected a whole number, 5 to 129");
    row("n is 5, four distinct points", "\"mesh_points\": 5", "");
    row("a torque outside the body", "\"free_length_mm\": 4, \"free_blend_mm\": 4, \"angular_corner_mm\": 5",
        "$.parameters.angular_corner_mm: impossible: expected a urethra that can exist (in SI units: is "
        "0.005: a torque outside");
    row("a hold outside the body", "\"free_length_mm\": 20, \"free_blend_mm\": 21",
        "$.parameters.free_blend_mm: impossible: expected");
    row("the shortest free part",
        "\"straight_length_mm\": 0, \"bladder_neck_z_mm\": 87.7, \"free_length_mm\": 5, \"free_blend_mm\": "
        "5, \"angular_corner_mm\": 5",
        "");
    row("the bend behind the free part", "\"straight_length_mm\": 36",
        "$.parameters.straight_length_mm: impossible: expected a urethra that can exist (in SI units: is "
        "0.036: the curvature begins");
    row("canal out of the mechanism's reach", "\"bladder_neck_z_mm\": 145",
        "$.parameters.bladder_neck_z_mm: 145 mm: expected a canal within the mechanism's workspace; at a "
        "depth of ");
    row("bladder out of the mechanism's reach", "\"bladder_radius_mm\": 80",
        "$.parameters.bladder_radius_mm: 80 mm: expected a bladder within the mechanism's workspace; at a "
        "depth of ");
    row("anatomy elsewhere", "\"anatomy_x_mm\": 5", "$.parameters.anatomy_x_mm: unknown key");
    row("the device's data", "\"position_count_um\": 5", "$.parameters.position_count_um: unknown key");
    row("half a section", "\"mesh_sections\": 4.5",
        "$.parameters.mesh_sections: 4.5: expected a whole number");
    row("self-crossing",
        "\"centreline_curvature_per_m\": 100, \"endoscope_size_Fr\": 30, \"rest_radius_mm\": 8, "
        "\"bladder_opening_deg\": 30",
        "$.parameters.rest_radius_mm: impossible: expected a urethra that can exist (in SI units: the wall "
        "crosses itself");
    row("change outside the canal",
        "\"local_changes\": [{\"centre_mm\": 300, \"length_mm\": 12, \"edge_mm\": 4, \"radius_mm\": 1, "
        "\"stiffness_factor\": 2, "
        "\"friction_factor\": 1}]",
        "$.parameters.local_changes[0].centre_mm: impossible: expected");
    row("edge wider than the change",
        "\"local_changes\": [{\"centre_mm\": 70, \"length_mm\": 12, \"edge_mm\": 13, \"radius_mm\": 1, "
        "\"stiffness_factor\": 2, "
        "\"friction_factor\": 1}]",
        "$.parameters.local_changes[0].edge_mm: impossible: expected");
    row("change without its radius",
        "\"local_changes\": [{\"centre_mm\": 70, \"length_mm\": 12, \"edge_mm\": 4, \"stiffness_factor\": 2, "
        "\"friction_factor\": 1}]",
        "$.parameters.local_changes[0].radius_mm: missing: expected a number");
    row("free part longer than the canal", "\"bladder_neck_z_mm\": 60, \"free_length_mm\": 90",
        "$.parameters.free_length_mm: impossible: expected");
    row("neck too narrow", "\"bladder_opening_deg\": 3",
        "$.parameters.bladder_opening_deg: impossible: expected");
    row("bladder too small",
        "\"endoscope_size_Fr\": 30, \"bladder_radius_mm\": 15, \"bladder_opening_deg\": 40, \"friction\": "
        "0.2",
        "");
    row("goal beyond the bladder", "\"goal_depth_mm\": 300",
        "$.parameters.goal_depth_mm: 300 mm: expected at most");
    row("goal before the landmarks", "\"goal_depth_mm\": 80",
        "$.parameters.goal_depth_mm: 80 mm: expected in the bladder");
    row("looking past the picture", "\"field_of_view_deg\": 20, \"landmark_half_angle_deg\": 15",
        "$.parameters.landmark_half_angle_deg: 15: expected inside the picture");
    row("unknown preset", "\"tissue\": \"strictura\"",
        "$.parameters.tissue: \"strictura\": expected a preset of the exercise: normal, stricture, tight; "
        "did you mean \"stricture\"?");
    row("preset of another type", "\"tissue\": 7", "$.parameters.tissue: 7: expected a text");
    row("force sections", "\"force_sections\": \"coarse\"",
        "$.parameters.force_sections: \"coarse\": expected one of fine, p1_basic");
    row("misspelt key", "\"restradius_mm\": 2", "$.parameters.restradius_mm: unknown key");
    row("torque beyond the device", "\"maximum_torque_mN_m\": 151",
        "$.parameters.maximum_torque_mN_m: 151: expected");
    row("gives way within its limit of torque", "\"yield_torque_mN_m\": 150",
        "$.parameters.yield_torque_mN_m: 150: expected more than maximum_torque_mN_m = 150");
    row("gives way far beyond it", "\"yield_torque_mN_m\": 301, \"maximum_torque_mN_m\": 100",
        "$.parameters.yield_torque_mN_m: 301: expected more than maximum_torque_mN_m = 100, and at most 3 "
        "times that");
    row("never gives way under a torque", "\"yield_torque_mN_m\": 0", "");
    row("force beyond the device", "\"maximum_force_N\": 4.6", "$.parameters.maximum_force_N: 4.6: expected");
}

void TestUrethraContent::faults() {
    QFETCH(QByteArray, keys);
    QFETCH(QByteArray, message);
    ContentCopy copy;
    QJsonObject level = QJsonDocument::fromJson(copy.read(kLevel)).object();
    QJsonObject parameters = level["parameters"].toObject();
    const QJsonObject changes = QJsonDocument::fromJson('{' + keys + '}').object();
    QVERIFY(!changes.isEmpty());
    for (auto it = changes.begin(); it != changes.end(); ++it)
        parameters[it.key()] = it.value();
    level["parameters"] = parameters;
    copy.write(kLevel, QJsonDocument(level).toJson());
    const auto catalogue = Catalogue::load(copy.directory());
    QCOMPARE(catalogue.has_value(), message.isEmpty());
    if (message.isEmpty())
        return;
    const QByteArray told = QByteArray::fromStdString(catalogue.error().message);
    QVERIFY2(told.startsWith(copy.path(kLevel).toUtf8() + ':'), told.constData());
    QVERIFY2(told.contains(message), told.constData());
}

void TestUrethraContent::aThinEndoscopeIsAllowed() {
    ContentCopy copy;
    QByteArray text = copy.read(kLevel);
    copy.write(kLevel,
               text.replace("\"tissue\": \"stricture\"", "\"tissue\": \"normal\", \"endoscope_size_Fr\": 8"));
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    const Parameters& p = parametersOf(*catalogue->find("urethra_insertion", 4));
    QVERIFY(p.endoscope.radius_m < p.anatomy.radius_m);
}

QTEST_APPLESS_MAIN(TestUrethraContent)
#include "test_urethra_content.moc"
