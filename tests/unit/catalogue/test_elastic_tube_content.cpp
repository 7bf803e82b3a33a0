// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/canonical_json.h"
#include "catalogue/catalogue.h"
#include "catalogue/schema.h"
#include "core/languages.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "support/content_copy.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <cmath>
#include <set>

using namespace chiron;
using namespace chiron::catalogue;
using Parameters = simulation::ElasticTubeParameters;
using simulation::TubeTask;

namespace {

const Catalogue& shipped() {
    static const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue;
}

const Parameters& parametersOf(const ExerciseLevel& level) {
    return level.parameters.as<Parameters>();
}

/// Every number of the struct but the object's.
std::vector<double> numbers(const Parameters& p) {
    return {p.stiffnessLow_N_per_m,
            p.stiffnessHigh_N_per_m,
            p.restLength_m,
            p.radius_m,
            p.baseX_m,
            p.baseY_m,
            p.baseSpread_m,
            p.tearRatio,
            p.overStretchRatio,
            p.targetLow_N,
            p.targetHigh_N,
            p.band_N,
            p.markRatio,
            p.markTolerance,
            p.targetX_m,
            p.targetY_m,
            p.targetZ_m,
            p.targetRadius_m,
            p.gripShare,
            p.hold_s,
            p.graspReach_m,
            p.graspAngle_rad,
            p.releaseAngle_rad,
            p.instrumentsApart_m,
            p.foldStiffness_N_per_m,
            p.retractionLow_N,
            p.retractionHigh_N,
            double(p.trials),
            p.trialLimit_s,
            p.betweenTrials_s,
            p.maximumForce_N,
            p.yield.force_N,
            p.yield.fall_s,
            double(p.task)};
}

} // namespace

class TestElasticTubeContent : public QObject {
    Q_OBJECT
private slots:
    void sixLevels();
    void everyLevelSaysWhatItGates();
    void objectReachesTheStruct();
    void everyKeyReachesTheStruct();
    void schemaDefaultsAreTheStructs();
    void olderContentKeepsItsMeaning();
    void faults_data();
    void faults();
};

void TestElasticTubeContent::sixLevels() {
    const auto& levels = shipped().find("elastic_tube")->levels;
    QCOMPARE(levels.size(), std::size_t{6});
    const char* ids[] = {"hold_tension", "to_the_mark", "stiffening_tube",
                         "two_handed",   "transfer",    "behind_a_fold"};
    const TubeTask tasks[] = {TubeTask::hold,      TubeTask::stretch,  TubeTask::hold,
                              TubeTask::twoHanded, TubeTask::transfer, TubeTask::twoHanded};
    for (std::size_t i = 0; i < 6; ++i) {
        QCOMPARE(levels[i].id, std::string(ids[i]));
        QCOMPARE(parametersOf(levels[i]).task, tasks[i]);
        QCOMPARE(parametersOf(levels[i]).tools(), i < 3 ? 1 : i < 5 ? 2 : 3);
        QCOMPARE(levels[i].mounting.size(), i < 5 ? std::size_t{0} : std::size_t{3});
        QCOMPARE(parametersOf(levels[i]).tube.stiffening_per_m > 0.0, i == 2);
        QVERIFY(!levels[i].needsForce);
        for (const std::string& language : core::languageIds())
            QVERIFY(levels[i].title.contains(language) && levels[i].objective.contains(language) &&
                    levels[i].measured.contains(language));
    }
}

// No level passes who damaged the tissue, lost it again and again, or did not get done; a target tension is
// gated where there is one.
void TestElasticTubeContent::everyLevelSaysWhatItGates() {
    for (const ExerciseLevel& level : shipped().find("elastic_tube")->levels) {
        const Parameters& p = parametersOf(level);
        std::map<std::string, scoring::Gate> gates;
        for (const auto& gate : level.gates)
            gates[gate.metric] = gate;
        QCOMPARE(*gates["procedure_completed"].minimum, 100.0);
        QCOMPARE(*gates["over_stretches"].maximum, 0.0);
        QVERIFY(gates.contains("drops") && gates.contains("force_time_over_limit"));
        const bool tension = p.task == TubeTask::hold || p.task == TubeTask::twoHanded;
        QCOMPARE(gates.contains("retraction_time_in_band") && gates.contains("retraction_max"), p.hasFold());
        QCOMPARE(gates.contains("tension_error_rms"), tension);
        if (tension)
            QVERIFY(*gates["tension_error_rms"].maximum <=
                    p.band_N); // at most as far off as the band is wide
        QCOMPARE(gates.contains("time_in_band"), p.task != TubeTask::transfer);
        if (p.task != TubeTask::transfer)
            QVERIFY(*gates["time_in_band"].minimum >= 0.8 * p.hold_s - 1e-9 &&
                    *gates["time_in_band"].minimum < p.hold_s);
    }
}

void TestElasticTubeContent::objectReachesTheStruct() {
    const auto* object = shipped().findObject("fallopian_tube");
    QVERIFY(object != nullptr);
    const Parameters& first = parametersOf(*shipped().find("elastic_tube", 1));
    QCOMPARE(first.tube.id, std::string("fallopian_tube"));
    QCOMPARE(first.tube.stiffness_N_per_m, object->attributes.stiffness_N_per_m);
    QCOMPARE(first.tube.viscosity_Ns_per_m, object->attributes.viscosity_Ns_per_m);
    QCOMPARE(parametersOf(*shipped().find("elastic_tube", 3)).tube.stiffening_per_m, 60.0);
}

void TestElasticTubeContent::everyKeyReachesTheStruct() {
    const auto schema =
        readSchema(CHIRON_SOURCE_DIR "/curriculum/content/schema", QStringLiteral("elastic_tube_parameters"));
    QVERIFY(schema.has_value());
    QJsonObject document =
        QJsonDocument::fromJson(QByteArray::fromStdString(shipped().find("elastic_tube", 1)->resolvedJson))
            .object();
    const auto with = [&](const QString& key, const QJsonValue& value) {
        QJsonObject level = document["level"].toObject();
        QJsonObject parameters = level["parameters"].toObject();
        parameters[key] = value;
        level["parameters"] = parameters;
        QJsonObject changed = document;
        changed["level"] = level;
        const auto read = fromResolvedJson(canonicalJson(changed));
        return read ? numbers(parametersOf(*read)) : std::vector<double>{};
    };
    const std::vector<double> plain = numbers(parametersOf(*shipped().find("elastic_tube", 1)));
    for (const auto& [key, property] : schema->properties) {
        if (key == "tube")
            continue;
        const QJsonValue other =
            key == "task" ? QJsonValue("transfer") : QJsonValue(property->defaultValue.toDouble() + 7.0);
        const std::vector<double> changed = with(key, other);
        QCOMPARE(changed.size(), plain.size());
        int different = 0;
        for (std::size_t i = 0; i < plain.size(); ++i)
            different += plain[i] == changed[i] ? 0 : 1;
        QVERIFY2(different == 1, qPrintable(key + QStringLiteral(": %1").arg(different)));
    }
}

void TestElasticTubeContent::schemaDefaultsAreTheStructs() {
    const auto schema =
        readSchema(CHIRON_SOURCE_DIR "/curriculum/content/schema", QStringLiteral("elastic_tube_parameters"));
    QVERIFY(schema.has_value());
    QJsonObject parameters;
    for (const auto& [key, property] : schema->properties)
        if (key != "tube")
            parameters[key] = property->defaultValue;
    QJsonObject document =
        QJsonDocument::fromJson(QByteArray::fromStdString(shipped().find("elastic_tube", 1)->resolvedJson))
            .object();
    QJsonObject level = document["level"].toObject();
    level["parameters"] = parameters;
    document["level"] = level;
    const auto read = fromResolvedJson(canonicalJson(document));
    QVERIFY(read.has_value());
    const std::vector<double> filled = numbers(parametersOf(*read));
    const std::vector<double> own = numbers(Parameters{});
    for (std::size_t i = 0; i < own.size(); ++i)
        QVERIFY2(filled[i] == own[i] ||
                     std::abs(filled[i] - own[i]) <=
                         0.004 * std::abs(own[i]), // jaw angles are rounded to half degrees
                 qPrintable(QStringLiteral("%1: %2, %3").arg(i).arg(filled[i]).arg(own[i])));
}

void TestElasticTubeContent::olderContentKeepsItsMeaning() {
    QJsonObject document =
        QJsonDocument::fromJson(QByteArray::fromStdString(shipped().find("elastic_tube", 4)->resolvedJson))
            .object();
    QJsonObject level = document["level"].toObject();
    level["parameters"] = QJsonObject{};
    document["level"] = level;
    const auto old = fromResolvedJson(canonicalJson(document));
    QVERIFY(old.has_value());
    QVERIFY(numbers(parametersOf(*old)) == numbers(Parameters{}));
}

void TestElasticTubeContent::faults_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("keys");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char* tag, const char* file, const char* keys, const char* message) {
        QTest::newRow(tag) << QString(file) << QByteArray(keys) << QByteArray(message);
    };
    row("as it is", "hold_tension", R"("trials": 4)", "");
    row("an unknown task", "hold_tension", R"("task": "pull")",
        "$.parameters.task: \"pull\": expected one of");
    row("an unknown object", "hold_tension", R"("tube": "falopian_tube")",
        "did you mean \"fallopian_tube\"?");
    row("a misspelt key", "hold_tension", R"("band_n": 0.1)", "$.parameters.band_n: unknown key");
    row("band down to nothing", "hold_tension", R"("target_low_N": 0.15)",
        "$.parameters.band_N: 0.15 N: expected less than target_low_N");
    row("targets the wrong way round", "hold_tension", R"("target_low_N": 1.7)",
        "$.parameters.target_low_N: 1.7 N: expected at most");
    row("damaged before the band", "hold_tension", R"("target_high_N": 1.9)",
        "$.parameters.target_high_N: 1.9 N: expected at most 1.74 N");
    row("beyond the device", "stiffening_tube",
        R"("target_high_N": 3.9, "stiffness_low_N_per_m": 60, "stiffness_high_N_per_m": 60)",
        "$.parameters.target_high_N: 3.9 N: expected at most maximum_force_N - band_N");
    row("damaged after it tore", "hold_tension", R"("over_stretch_ratio": 2)",
        "$.parameters.over_stretch_ratio: 2: expected below tear_ratio");
    row("mark beyond the tear", "to_the_mark", R"("mark_ratio": 1.75)",
        "$.parameters.mark_ratio: 1.75: expected at most over_stretch_ratio");
    row("mark at a slack tube", "to_the_mark", R"("mark_ratio": 1.03)",
        "$.parameters.mark_ratio: 1.03: expected more than 1 + mark_tolerance");
    row("stiffness the wrong way round", "to_the_mark", R"("stiffness_low_N_per_m": 200)",
        "$.parameters.stiffness_low_N_per_m: 200: expected");
    row("nothing that pulls", "to_the_mark", R"("stiffness_low_N_per_m": 0)",
        "$.parameters.stiffness_low_N_per_m: 0: expected a stiffness");
    row("stiffer than the loop carries", "stiffening_tube",
        R"("tube": {"object": "fallopian_tube", "stiffening_per_m": 120})",
        "$.parameters.stiffness_high_N_per_m: ");
    row("a grip too near to the end", "transfer",
        R"("grip_share": 0.95, "stiffness_low_N_per_m": 150, "stiffness_high_N_per_m": 150)",
        "$.parameters.stiffness_high_N_per_m: ");
    row("a target out of reach", "transfer", R"("target_x_mm": -70)", "$.parameters.target_x_mm: ");
    row("a tube out of reach", "hold_tension", R"("rest_length_mm": 70)",
        "$.parameters.rest_length_mm: 70 mm: expected at most");
    row("a fold with the band the wrong way round", "behind_a_fold", R"("retraction_low_N": 1.2)",
        "$.parameters.retraction_low_N: 1.2 N: expected less than");
    row("a fold that is asked too much of", "behind_a_fold",
        R"("retraction_high_N": 5, "fold_stiffness_N_per_m": 100)",
        "$.parameters.retraction_high_N: 5 N: expected at most");
    row("a fold out of reach", "behind_a_fold", R"("fold_stiffness_N_per_m": 10)",
        "$.parameters.fold_stiffness_N_per_m: 10: expected at least 13.3");
    row("a jaw that never lets go", "hold_tension", R"("grasp_angle_deg": 25)",
        "$.parameters.release_angle_deg: 20: expected more than");
}

void TestElasticTubeContent::faults() {
    QFETCH(QString, file);
    QFETCH(QByteArray, keys);
    QFETCH(QByteArray, message);
    ContentCopy copy;
    const QString path = "exercises/elastic_tube/levels/" + file + ".json";
    QJsonObject level = QJsonDocument::fromJson(copy.read(path)).object();
    QJsonObject parameters = level["parameters"].toObject();
    const QJsonObject changes = QJsonDocument::fromJson('{' + keys + '}').object();
    QVERIFY(!changes.isEmpty());
    for (auto it = changes.begin(); it != changes.end(); ++it)
        parameters[it.key()] = it.value();
    level["parameters"] = parameters;
    copy.write(path, QJsonDocument(level).toJson());
    const auto catalogue = Catalogue::load(copy.directory());
    const QByteArray told = catalogue ? QByteArray() : QByteArray::fromStdString(catalogue.error().message);
    QVERIFY2(catalogue.has_value() == message.isEmpty(), told.constData());
    if (message.isEmpty())
        return;
    QVERIFY2(told.startsWith(copy.path(path).toUtf8() + ':'), told.constData());
    QVERIFY2(told.contains(message), told.constData());
}

QTEST_APPLESS_MAIN(TestElasticTubeContent)
#include "test_elastic_tube_content.moc"
