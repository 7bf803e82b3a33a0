// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "catalogue/schema.h"
#include "core/languages.h"
#include "core/units.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "scoring/metric_catalogue.h"

#include <QDirIterator>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace chiron;
using namespace chiron::catalogue;

namespace {

const QString kContent = QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content");

const Catalogue& shipped() {
    static const auto catalogue = Catalogue::load(kContent.toStdString());
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue;
}

} // namespace

class TestContent : public QObject {
    Q_OBJECT
private slots:
    void shippedContentIsValid();
    void sphereApexHasItsSixLevels();
    void everyTextIsInEveryLanguage();
    void textsHaveNoStrayCharacters();
    void keysCarryTheirUnits();
    void blindLevelsTellNothing();
    void levelsHaveGatesOnTheirHeadlines();
    void everyPassMarkHasAdvice();
    void marksInTheSceneAreExplained();
    void urethraLevelsHaveTheirGates();
    void palpationLevelsHaveTheirGates();
    void marksAtRandomDoNotPassAPalpation_data();
    void marksAtRandomDoNotPassAPalpation();
    void tissueThatGivesWayFails();
    void onlyJsonAndReadmesAreShipped();
};

void TestContent::shippedContentIsValid() {
    const auto catalogue = Catalogue::load(kContent.toStdString());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    QVERIFY(catalogue->find("sphere_apex") != nullptr);
}

void TestContent::sphereApexHasItsSixLevels() {
    const auto& levels = shipped().find("sphere_apex")->levels;
    QCOMPARE(levels.size(), std::size_t{6});
    const auto parameters = [&](std::size_t i) {
        return levels[i].parameters.as<simulation::SphereApexParameters>();
    };
    QVERIFY(levels[0].cues.size() > 0 && levels[0].cues[0] == "object" && !levels[0].needsForce);
    // P2's condition: R = 20 mm, ten spheres, nothing to see.
    QCOMPARE(parameters(1).radius_m, 0.020);
    QCOMPARE(parameters(1).trials, 10);
    QCOMPARE(parameters(1).trialLimit_s, 60.0);
    QCOMPARE(parameters(1).stiffnessLow_N_per_m, 500.0);
    QCOMPARE(parameters(1).stiffnessHigh_N_per_m, 500.0);
    QCOMPARE(parameters(1).frictionHigh, 0.0);
    QCOMPARE(parameters(1).dimpleDepth_m, 0.0);
    QVERIFY(parameters(2).stiffnessLow_N_per_m < parameters(2).stiffnessHigh_N_per_m);
    QVERIFY(parameters(2).frictionLow < parameters(2).frictionHigh);
    QVERIFY(parameters(3).dimpleDepth_m > 0.0);
}

void TestContent::everyTextIsInEveryLanguage() {
    const auto complete = [](const Translated& text) {
        const auto languages = core::languageIds();
        return std::all_of(languages.begin(), languages.end(),
                           [&](const std::string& language) { return text.contains(language); });
    };
    for (const Exercise& exercise : shipped().exercises()) {
        QVERIFY(complete(exercise.title) && complete(exercise.objective));
        for (const ExerciseLevel& level : exercise.levels) {
            QVERIFY2(complete(level.title) && complete(level.objective) && complete(level.measured),
                     level.id.c_str());
            QVERIFY(!level.shownForce || complete(level.shownForce->note));
            for (const std::string& language : core::languageIds())
                QVERIFY2(language == "en" || level.title.at(language) != level.title.at("en"),
                         (level.id + " " + language).c_str());
        }
    }
}

void TestContent::textsHaveNoStrayCharacters() {
    QDirIterator it(kContent, {"*.json"}, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        QFile file(it.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY2(!bytes.contains('\t') && !bytes.contains('\r') && bytes.endsWith("}\n"),
                 qPrintable(file.fileName()));
        QVERIFY(!bytes.contains("  \"\"") && !bytes.contains("TODO"));
    }
}

// architecture.md: keys carry units (`stiffness_N_per_m`).
void TestContent::keysCarryTheirUnits() {
    const std::map<QString, QString> suffix{{"mm", "_mm"},
                                            {"s", "_s"},
                                            {"N", "_N"},
                                            {"N/m", "_N_per_m"},
                                            {"N·s/m", "_N_s_per_m"},
                                            {"1/m", "_per_m"},
                                            {"N/m³", "_N_per_m3"},
                                            {"N·s/m²", "_N_s_per_m2"},
                                            {"N·m/rad", "_N_m_per_rad"},
                                            {"deg", "_deg"},
                                            {"Fr", "_Fr"},
                                            {"um", "_um"},
                                            {"g", "_g"},
                                            {"ms", "_ms"},
                                            {"mm/s", "_mm_per_s"},
                                            {"mN·m", "_mN_m"},
                                            {"Hz", "_Hz"}};
    for (const auto& exercise : shipped().exercises()) {
        const auto schema = readSchema(kContent + "/schema",
                                       QString::fromStdString(exercise.id) + QStringLiteral("_parameters"));
        QVERIFY(schema.has_value());
        for (const auto& [key, property] : schema->properties) {
            QVERIFY2(!property->defaultValue.isUndefined(), qPrintable(key));
            if (property->unit == "1" || property->unit.isEmpty())
                continue;
            QVERIFY2(suffix.contains(property->unit), qPrintable(property->unit));
            QVERIFY2(key.endsWith(suffix.at(property->unit)), qPrintable(key));
        }
    }
}

// A level whose object is hidden must give it away by nothing: the drawn tool's height, a bar, a sound.
void TestContent::blindLevelsTellNothing() {
    for (const ExerciseLevel& level : shipped().find("sphere_apex")->levels)
        if (std::find(level.cues.begin(), level.cues.end(), "object") == level.cues.end()) {
            QVERIFY2(level.cues.empty(), level.id.c_str());
            QVERIFY(level.needsForce);
            QVERIFY(level.shownForce.has_value());
        }
}

void TestContent::levelsHaveGatesOnTheirHeadlines() {
    for (const auto& exercise :
         shipped().exercises()) // what chance gives stands beside every score that has such a level
        for (const ExerciseLevel& level : exercise.levels)
            for (const auto& metric : level.metrics) {
                const std::string chance = metric.id + "_by_chance";
                const bool told = std::any_of(level.metrics.begin(), level.metrics.end(),
                                              [&](const auto& m) { return m.id == chance; });
                QVERIFY2(scoring::findMetric(chance) == nullptr || told, (level.id + ": " + chance).c_str());
            }
    for (const ExerciseLevel& level : shipped().find("sphere_apex")->levels) {
        std::set<std::string> gated;
        for (const auto& gate : level.gates)
            gated.insert(gate.metric);
        QVERIFY(gated.contains("apex_error_mean") && gated.contains("apex_misses"));
        QVERIFY(gated.contains("force_time_over_limit"));
        std::set<std::string> ofASphere{"time",
                                        "path_length",
                                        "path_inefficiency",
                                        "force_max",
                                        "force_mean",
                                        "force_p95",
                                        "force_rms",
                                        "force_peak_rate",
                                        "force_impulse_over_limit",
                                        "force_time_over_limit",
                                        "critical_errors",
                                        "apex_error_mean",
                                        "apex_error_mean_by_chance",
                                        "apex_error_sd",
                                        "apex_bias_x",
                                        "apex_bias_y",
                                        "apex_misses"};
        if (level.id == "soft_organ") // of two rates
            ofASphere.insert({"prediction_error_rms", "held_error_rms"});
        std::set<std::string> measured;
        for (const auto& metric : level.metrics)
            measured.insert(metric.id);
        QVERIFY2(measured == ofASphere, level.id.c_str());
    }
}

// No level passes who missed lumps, saw them everywhere, or pressed too hard; what is not asked for is not
// scored.
void TestContent::palpationLevelsHaveTheirGates() {
    for (const ExerciseLevel& level :
         shipped().find("palpation")->levels) // the base rate is measured by: nobody is told it
        for (const auto& [language, text] : level.objective)
            for (const char* told : {"one of them", "of the eight", "eine davon", "eines davon", "der acht",
                                     "από αυτ", "από τα οκτώ"})
                QVERIFY2(text.find(told) == std::string::npos, level.id.c_str());
    for (const ExerciseLevel& level : shipped().find("palpation")->levels) {
        std::map<std::string, scoring::Gate> gates;
        for (const auto& gate : level.gates)
            gates[gate.metric] = gate;
        QVERIFY2(gates["palpation_misses"].maximum && gates["palpation_false_alarms"].maximum,
                 level.id.c_str());
        QVERIFY2(gates["force_time_over_limit"].maximum, level.id.c_str());
        QVERIFY2(gates["critical_errors"].maximum == 0.0, level.id.c_str());
        QCOMPARE(gates.contains("coverage"),
                 level.number > 1); // hidden lumps: the whole area has to be searched
        std::set<std::string> asked;
        for (const auto& metric : level.metrics)
            asked.insert(metric.id);
        for (const char* id :
             {"palpation_hits", "palpation_misses", "palpation_false_alarms", "localisation_error",
              "coverage", "force_band_time", "searching_time", "pressing_time"})
            QVERIFY2(asked.contains(id), id);
        QCOMPARE(asked.contains("palpation_d_prime"), level.number > 1);
        QCOMPARE(asked.contains("hardness_order"), level.number == 3);
        QVERIFY2(!asked.contains("size_error"),
                 level.id.c_str()); // content/README.md: what a finger feels does not tell it
    }
}

namespace {

/// The probability that marks at random places find `hits` lumps before one false alarm too many.
double foundInTime(int hits, int mostFalse, double perMark) {
    double probability = hits <= 0 ? 1.0 : 0.0;
    const int marks = hits + mostFalse;
    double drawn = std::pow(1.0 - perMark, marks); // of k hits among that many marks
    for (int k = 0; hits > 0 && k <= marks; ++k) {
        probability += k >= hits ? drawn : 0.0;
        drawn *= static_cast<double>(marks - k) / (k + 1) * perMark / (1.0 - perMark);
    }
    return probability;
}

/// The probability that somebody who searches everywhere and marks places at random meets a level's limits on
/// hits, misses and false alarms.
double passesByChance(const simulation::PalpationParameters& p, int fewestFound, int mostMissed,
                      int mostFalse) {
    double reach_m = p.hitRadius_m;
    for (const simulation::LumpKind& kind : p.kinds)
        reach_m = std::max(reach_m, kind.radius_m);
    const int withLumps = p.trials - p.catchTrials;
    const double lumps = 0.5 * (p.lumpsLow + p.lumpsHigh) * withLumps / p.trials; // in a trial
    const double perMark =
        lumps * core::kPi * reach_m * reach_m / (4.0 * p.areaHalf_m.x() * p.areaHalf_m.y());
    std::vector<double> totals{1.0}; // the probability of each number of lumps
    for (int trial = 0; trial < withLumps; ++trial) {
        std::vector<double> more(totals.size() + static_cast<std::size_t>(p.lumpsHigh), 0.0);
        for (std::size_t total = 0; total < totals.size(); ++total)
            for (int k = p.lumpsLow; k <= p.lumpsHigh; ++k)
                more[total + static_cast<std::size_t>(k)] += totals[total] / (p.lumpsHigh - p.lumpsLow + 1);
        totals = std::move(more);
    }
    double passes = 0.0;
    for (std::size_t total = 0; total < totals.size(); ++total)
        passes += totals[total] * foundInTime(std::max(fewestFound, static_cast<int>(total) - mostMissed),
                                              mostFalse, perMark);
    return passes;
}

} // namespace

void TestContent::marksAtRandomDoNotPassAPalpation_data() {
    QTest::addColumn<int>("number");
    for (const ExerciseLevel& level : shipped().find("palpation")->levels)
        QTest::addRow("%d %s", level.number, level.id.c_str()) << level.number;
}

// What a limit on lumps has to exclude, whatever a scripted expert reaches.
void TestContent::marksAtRandomDoNotPassAPalpation() {
    QFETCH(int, number);
    const ExerciseLevel& level = *shipped().find("palpation", number);
    std::map<std::string, double> most, fewest;
    for (const scoring::Gate& gate : level.gates) {
        most[gate.metric] = gate.maximum.value_or(0.0);
        fewest[gate.metric] = gate.minimum.value_or(0.0);
    }
    const auto& p = level.parameters.as<simulation::PalpationParameters>();
    const int fewestFound = static_cast<int>(fewest["palpation_hits"]);
    const int mostMissed = static_cast<int>(most["palpation_misses"]);
    const double chance =
        passesByChance(p, fewestFound, mostMissed, static_cast<int>(most["palpation_false_alarms"]));
    QVERIFY2(chance < 0.01, qPrintable(QString::number(chance)));
    // Whoever marks nothing does not pass, however few lumps a session has.
    QVERIFY(fewestFound > 0 || p.lumpsLow * (p.trials - p.catchTrials) > mostMissed);
}

// Whoever breaks through tissue fails, on every level on which tissue can give way, however well the rest
// went.
void TestContent::tissueThatGivesWayFails() {
    for (const auto& exercise : shipped().exercises())
        for (const ExerciseLevel& level : exercise.levels) {
            const auto gate =
                std::find_if(level.gates.begin(), level.gates.end(),
                             [](const scoring::Gate& g) { return g.metric == "critical_errors"; });
            QVERIFY2(gate != level.gates.end() && gate->maximum == 0.0, level.id.c_str());
        }
}

namespace {
/// The most that the wall answers across to a shaft that is pushed on straight up to the level's goal, but
/// not beyond the canal.
double mostAcross_N(const simulation::UrethraInsertionParameters& p) {
    const simulation::UrethraForces forces(p.anatomy, p.endoscope, p.forces);
    const double goal_m = p.goalDepth_m > 0.0 ? p.goalDepth_m : forces.centreline().length_m();
    double most_N = 0.0;
    for (double z_m = 0.0; z_m < p.anatomy.zEnd_m; z_m += 0.0005) {
        const auto r = forces.respond(
            {core::Vec3(0.0, 0.0, z_m), core::Vec3::UnitZ(), core::Vec3::Zero(), core::Vec3::Zero()});
        if (r.foot.at.s_m < goal_m)
            most_N = std::max(most_N, r.lateral_A.norm());
    }
    return most_N;
}
} // namespace

// No level passes who hurt the wall, did not arrive, or was stopped by the clock.
/// Who misses a pass mark is told what to do differently, in every language; and no advice is for what no
/// level asks for.
void TestContent::everyPassMarkHasAdvice() {
    for (const Exercise& exercise : shipped().exercises()) {
        std::set<std::string> gated;
        for (const ExerciseLevel& level : exercise.levels)
            for (const scoring::Gate& gate : level.gates)
                gated.insert(gate.metric);
        for (const std::string& metric : gated) {
            const auto advice = std::find_if(exercise.advice.begin(), exercise.advice.end(),
                                             [&](const Advice& one) { return one.metric == metric; });
            QVERIFY2(advice != exercise.advice.end(), (exercise.id + ": " + metric).c_str());
            for (const std::string& language : core::languageIds())
                QVERIFY2(!advice->text.at(language).empty(), (exercise.id + ": " + metric).c_str());
        }
        QCOMPARE(exercise.advice.size(), gated.size());
        // Words about a result are no part of what was done: they are not stored with a session.
        for (const ExerciseLevel& level : exercise.levels)
            QVERIFY(level.resolvedJson.find("\"advice\"") == std::string::npos);
    }
}

/// Each mark once, in every language; test_scene_marks compares them with what the scenes draw.
void TestContent::marksInTheSceneAreExplained() {
    for (const Exercise& exercise : shipped().exercises()) {
        for (const ExerciseLevel& level : exercise.levels)
            QVERIFY(level.resolvedJson.find("\"legend\"") == std::string::npos);
        std::set<std::string> told;
        for (const LegendLine& line : exercise.legend) {
            QVERIFY2(told.insert(line.mark).second, (exercise.id + ": " + line.mark).c_str());
            for (const std::string& language : core::languageIds())
                QVERIFY2(!line.text.at(language).empty(), (exercise.id + ": " + line.mark).c_str());
        }
        QVERIFY2(!told.empty(), exercise.id.c_str());
    }
}

void TestContent::urethraLevelsHaveTheirGates() {
    for (const ExerciseLevel& level : shipped().find("urethra_insertion")->levels) {
        const auto& p = level.parameters.as<simulation::UrethraInsertionParameters>();
        std::map<std::string, scoring::Gate> gates;
        for (const auto& gate : level.gates)
            gates[gate.metric] = gate;
        QVERIFY(gates.contains("trauma_events") && gates.contains("force_time_over_limit") &&
                gates.contains("critical_errors"));
        QVERIFY(!gates.contains("offset_rms") &&
                !gates.contains("offset_max")); // where it hurts the wall says so; elsewhere it does not
        QVERIFY(gates.contains("time") && *gates["time"].maximum < p.trialLimit_s);
        QCOMPARE(*gates["procedure_completed"].minimum, 100.0);
        if (p.landmarks.empty())
            QCOMPARE(*gates["insertion_depth"].minimum, 1000.0 * p.goalDepth_m);
        else
            QCOMPARE(*gates["landmarks_seen"].minimum, 100.0);
        QCOMPARE(gates.contains("curve_alignment"), level.number > 1);
        QCOMPARE(gates.contains("alignment_rms"),
                 p.landmarks.empty()); // who looks round in the bladder is not aligned there
        QVERIFY2(
            mostAcross_N(p) > 4.0,
            level.id.c_str()); // who pushes straight in, neither steering nor turning, makes a critical error
    }
    const auto& levels = shipped().find("urethra_insertion")->levels;
    const auto stricter = [&](const char* metric) {
        const auto limit = [&](const ExerciseLevel& level) {
            return *std::find_if(level.gates.begin(), level.gates.end(), [&](const auto& gate) {
                        return gate.metric == metric;
                    })->maximum;
        };
        return limit(levels[4]) < limit(levels[2]);
    };
    QVERIFY(stricter("trauma_events") && stricter("time") &&
            stricter("force_time_over_limit")); // the last level asks for more than the third
}

void TestContent::onlyJsonAndReadmesAreShipped() {
    QDirIterator it(kContent, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        const QFileInfo file(it.next());
        QVERIFY2(file.suffix() == "json" || file.fileName() == "README.md", qPrintable(file.filePath()));
    }
}

QTEST_APPLESS_MAIN(TestContent)
#include "test_content.moc"
