// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "core/languages.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "support/content_copy.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <map>

using namespace chiron;
using namespace chiron::catalogue;
using Parameters = simulation::ObjectHandlingParameters;
using simulation::HandlingTask;

namespace {

const Catalogue& shipped() {
    static const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue;
}

const Parameters& parametersOf(int number) {
    return shipped().find("object_handling", number)->parameters.as<Parameters>();
}

const QString kFolder = QStringLiteral("exercises/object_handling/levels/");

} // namespace

/// The levels of object handling, as content.
class TestObjectHandlingContent : public QObject {
    Q_OBJECT
private slots:
    void levelsAreWhatTheySay() {
        for (const ExerciseLevel& level : shipped().find("object_handling")->levels) {
            const Parameters& p = level.parameters.as<Parameters>();
            for (const std::string& language : core::languageIds())
                QVERIFY(level.title.contains(language) && level.objective.contains(language) &&
                        level.measured.contains(language));
            QCOMPARE(p.task == HandlingTask::weigh, level.number == 3);
            QCOMPARE(p.tools(), 1);
            QCOMPARE(level.needsForce, level.number == 3);
            QCOMPARE(level.shownForce.has_value(), level.number == 3);
            std::map<std::string, scoring::Gate> gates;
            for (const auto& gate : level.gates)
                gates[gate.metric] = gate;
            QCOMPARE(*gates["procedure_completed"].minimum, 100.0);
            QVERIFY(gates.contains(level.number == 1 ? "squeeze_max" : "squeeze_time_over_limit") &&
                    gates.contains("force_time_over_limit"));
            QCOMPARE(gates.contains("weighing_correct"), level.number == 3);
            QCOMPARE(p.cues.size(), level.cues.size());
        }
    }

    void objectsReachTheStruct() {
        QCOMPARE(parametersOf(1).object.id, std::string("ovary"));
        QCOMPARE(parametersOf(1).object.mass_kg, 0.010); // P2
        QCOMPARE(parametersOf(1).bed.id, std::string("plane"));
        QCOMPARE(parametersOf(2).object.friction, 0.15); // changed by the level
        QCOMPARE(parametersOf(2).object.stiffness_N_per_m, parametersOf(1).object.stiffness_N_per_m);
        QCOMPARE(parametersOf(3).object.id, std::string("cystic_ovary"));
        QCOMPARE(parametersOf(3).objects, 3);
        QCOMPARE(parametersOf(3).massHigh_kg, 0.045);
    }

    // A weighing level shows nothing that tells the weight.
    void weighingIsFelt() {
        const ExerciseLevel& level = *shipped().find("object_handling", 3);
        for (const char* cue : {"arrow", "bars", "numbers", "plots", "sound"})
            QVERIFY(std::find(level.cues.begin(), level.cues.end(), cue) == level.cues.end());
    }

    void faults_data() {
        QTest::addColumn<QString>("level");
        QTest::addColumn<QByteArray>("change");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const char* level, const char* change, const char* place) {
            QTest::newRow(name) << QString(level) << QByteArray(change) << QString(place);
        };
        row("task", "lift_and_place", R"({"task": "juggle"})", "$.parameters.task");
        row("no mass", "lift_and_place", R"({"object": {"object": "ovary", "mass_g": 0}})",
            "$.parameters.mass_low_g");
        row("low over high", "weigh", R"({"mass_low_g": 50})", "$.parameters.mass_low_g");
        row("no heaviest", "weigh", R"({"mass_low_g": 40})", "$.parameters.mass_high_g");
        row("one to weigh", "weigh", R"({"objects": 1})", "$.parameters.objects");
        row("two to place", "lift_and_place", R"({"objects": 2})", "$.parameters.objects");
        row("no room", "weigh", R"({"places_radius_mm": 15})", "$.parameters.places_radius_mm");
        row("short jaws", "lift_and_place", R"({"jaw_length_mm": 12})", "$.parameters.jaw_length_mm");
        row("no friction", "lift_and_place", R"({"object": {"object": "ovary", "friction": 0}})",
            "$.parameters.object.friction");
        row("cannot be held", "lift_and_place", R"({"squeeze_limit_N": 0.2})",
            "$.parameters.squeeze_limit_N");
        row("too stiff for its mass", "lift_and_place", R"({"object": {"object": "ovary", "mass_g": 2}})",
            "$.parameters.object.stiffness_N_per_m");
        row("too damped for its mass", "lift_and_place",
            R"({"bed": {"object": "plane", "damping_N_s_per_m": 9}})",
            "$.parameters.object.damping_N_s_per_m");
        row("pressed through", "lift_and_place",
            R"({"object": {"object": "ovary", "stiffness_N_per_m": 100}})",
            "$.parameters.object.stiffness_N_per_m");
        row("organ narrower than the field", "soft_organ", R"({"bed_mesh": {"mesh": "organ"}})",
            "$.parameters.bed_mesh");
        row("organ just too narrow", "soft_organ", R"({"places_radius_mm": 55})", "$.parameters.bed_mesh");
        row("answers later than the next question", "soft_organ", R"({"bed_rate_Hz": 40})",
            "$.parameters.bed_latency_ticks");
        row("answers too soon to blend", "soft_organ", R"({"bed_latency_ticks": 19})",
            "$.parameters.bed_latency_ticks");
        row("no organ", "soft_organ", R"({"bed_mesh": {"shape": "none"}})", "$.parameters.bed_mesh");
        row("unknown object", "lift_and_place", R"({"object": "spleen"})", "$.parameters.object");
        row("unknown key", "lift_and_place", R"({"colour": 3})", "$.parameters.colour");
        row("range", "lift_and_place", R"({"hold_s": 99})", "$.parameters.hold_s");
    }
    // Values exactly at a limit are accepted: the same mass at both ends, masses exactly mass_ratio apart, an
    // answer that comes exactly with the next question, and the shortest latency that leaves time to blend.
    void justWithin_data() {
        QTest::addColumn<QString>("level");
        QTest::addColumn<QByteArray>("change");
        const auto row = [](const char* name, const char* level, const char* change) {
            QTest::newRow(name) << QString(level) << QByteArray(change);
        };
        row("one mass", "lift_and_place", R"({"mass_low_g": 20, "mass_high_g": 20})");
        row("one heaviest", "weigh", R"({"mass_low_g": 32, "mass_high_g": 48, "mass_ratio": 1.5})");
        row("an answer at the next question", "soft_organ",
            R"({"bed_rate_Hz": 40, "bed_latency_ticks": 25})");
        row("an answer with time to blend", "soft_organ", R"({"bed_rate_Hz": 40, "bed_latency_ticks": 20})");
    }
    void justWithin() {
        QFETCH(QString, level);
        QFETCH(QByteArray, change);
        const auto catalogue = changed(level, change);
        QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    }

    void faults() {
        QFETCH(QString, level);
        QFETCH(QByteArray, change);
        QFETCH(QString, place);
        const auto catalogue = changed(level, change);
        QVERIFY(!catalogue.has_value());
        const QString told = QString::fromStdString(catalogue.error().message);
        QVERIFY2(told.contains(kFolder + level) && told.contains(place), qPrintable(told));
    }

private:
    static core::Result<Catalogue> changed(const QString& level, const QByteArray& change) {
        const ContentCopy copy;
        const QString file = kFolder + level + QStringLiteral(".json");
        QJsonObject json = QJsonDocument::fromJson(copy.read(file)).object();
        QJsonObject parameters = json["parameters"].toObject();
        const QJsonObject changes = QJsonDocument::fromJson(change).object();
        for (auto it = changes.begin(); it != changes.end(); ++it)
            parameters[it.key()] = it.value();
        json["parameters"] = parameters;
        copy.write(file, QJsonDocument(json).toJson());
        return Catalogue::load(copy.directory());
    }
};

QTEST_GUILESS_MAIN(TestObjectHandlingContent)
#include "test_object_handling_content.moc"
