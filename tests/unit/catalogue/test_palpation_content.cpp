// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "core/languages.h"
#include "modules/exercises/palpation/simulation/palpation_plan.h"
#include "simulation/palpation/tissue_contact.h"
#include "support/content_copy.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::catalogue;
using Parameters = simulation::PalpationParameters;

namespace {

const Catalogue& shipped() {
    static const auto catalogue = Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue;
}

const Parameters& parametersOf(int number) {
    return shipped().find("palpation", number)->parameters.as<Parameters>();
}

bool hasCue(const ExerciseLevel& level, const char* cue) {
    return std::find(level.cues.begin(), level.cues.end(), cue) != level.cues.end();
}

const QString kLevels = QStringLiteral("exercises/palpation/levels/");

} // namespace

/// The levels of palpation and the tissues, as content.
class TestPalpationContent : public QObject {
    Q_OBJECT
private slots:
    void levelsAreWhatTheySay() {
        const auto& levels = shipped().find("palpation")->levels;
        QCOMPARE(levels.size(), std::size_t{5});
        for (const ExerciseLevel& level : levels) {
            const Parameters& p = level.parameters.as<Parameters>();
            for (const std::string& language : core::languageIds())
                QVERIFY(level.title.contains(language) && level.objective.contains(language) &&
                        level.measured.contains(language));
            QCOMPARE(hasCue(level, "object"), level.number == 1);
            QCOMPARE(level.needsForce, level.number != 1);
            QCOMPARE(level.shownForce.has_value(), level.number != 1);
            QVERIFY(p.catchTrials >= 1); // lump-free trials belong to every set
            QVERIFY(p.trials >= 4 && p.trials <= 10 && p.trialLimit_s <= 90.0);
            QCOMPARE(p.hands, level.number == 4 ? 2 : 1);
            QCOMPARE(p.fingers, level.number == 5 ? 2 : 1);
            QCOMPARE(p.asksSize, level.number == 3);
            QCOMPARE(p.asksHardness, level.number == 3);
        }
    }

    // A level whose lump is hidden tells nothing of it: no bar, no arrow, no number, no plot.
    void hiddenIsFelt() {
        for (const ExerciseLevel& level : shipped().find("palpation")->levels)
            for (const char* cue : {"arrow", "bars", "numbers", "plots"})
                QCOMPARE(hasCue(level, cue), level.number == 1);
    }

    // d′ needs 20 regions with a lump and 20 without.
    void enoughRegionsForDPrime() {
        for (const int number : {4, 5}) {
            const Parameters& p = parametersOf(number);
            int enough = 0;
            for (std::uint64_t seed = 0; seed < 200; ++seed) {
                int signal = 0, all = 0;
                for (const auto& trial : simulation::planPalpationTrials(p, seed)) {
                    signal += trial.lumps;
                    all += p.regionColumns * p.regionRows;
                }
                QVERIFY(all - signal >= 20);
                enough += signal >= 20 ? 1 : 0;
            }
            QVERIFY2(enough >= (number == 5 ? 200 : 190), qPrintable(QString::number(enough)));
        }
    }

    void tissuesReachTheStruct() {
        const auto& pad = parametersOf(1).tissue;
        QCOMPARE(pad.stiffness_N_per_m, 650.0); // P3
        QVERIFY(pad.shape.bumps.empty());
        const ContentTissue* prostate = shipped().findTissue("prostate");
        QVERIFY(prostate != nullptr && !prostate->source.empty());
        const auto& organ = parametersOf(3).tissue;
        QCOMPARE(organ.layers.at(0).modulus_Pa, 17e3);
        QCOMPARE(organ.shape.bumps.size(), std::size_t{2});
        QCOMPARE(organ.shape.bumps[1].centre_m.x(), 0.010);
        QVERIFY(std::abs(organ.fibreDirection.y() - 1.0) < 1e-12);
        const simulation::TissueContact contact(organ); // models.md §3: 227 N/m
        QVERIFY(std::abs(contact.normalStiffness_N_per_m() - 226.7) < 0.1);
        const auto& breast = parametersOf(4).tissue;
        QCOMPARE(breast.layers.size(), std::size_t{2});
        QCOMPARE(breast.regions.at(0).name, std::string("areola"));
        QCOMPARE(breast.regions.at(0).gain, 0.35);
        QCOMPARE(shipped().findTissue("spleen"), nullptr);
    }

    // The median furrow of the prostate: lower than either lobe, and lobes of about 50 x 40 mm.
    void organHasTwoLobes() {
        const simulation::TissueSurface surface(parametersOf(3).tissue.shape);
        const double furrow = surface.heightAt({0.0, 0.0}).z_m;
        QVERIFY(furrow < surface.heightAt({0.010, 0.0}).z_m - 0.0005);
        QVERIFY(furrow < surface.heightAt({-0.010, 0.0}).z_m - 0.0005);
        QVERIFY(surface.heightAt({0.0, 0.0}).z_m > surface.heightAt({0.030, 0.0}).z_m + 0.003);
    }

    void resolvedContentStandsAlone() {
        for (const ExerciseLevel& level : shipped().find("palpation")->levels) {
            const auto again = fromResolvedJson(level.resolvedJson);
            QVERIFY2(again, again ? "" : again.error().message.c_str());
            const Parameters& p = again->parameters.as<Parameters>();
            const Parameters& q = level.parameters.as<Parameters>();
            QCOMPARE(p.tissue.layers.size(), q.tissue.layers.size());
            QCOMPARE(p.tissue.regions.size(), q.tissue.regions.size());
            QCOMPARE(p.kinds.size(), q.kinds.size());
            QCOMPARE(p.areaHalf_m, q.areaHalf_m);
            QCOMPARE(p.tissue.contactRadius_m, q.tissue.contactRadius_m);
        }
    }

    void faults_data() {
        QTest::addColumn<QString>("level");
        QTest::addColumn<QByteArray>("change");
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* name, const char* level, const char* change, const char* place,
                            const char* expected) {
            QTest::newRow(name) << QString(level) << QByteArray(change) << QString(place)
                                << QString::fromUtf8(expected);
        };
        const char* one =
            R"({"lump_kinds": [{"radius_mm": %R, "depth_mm": %H, "ratio": 10, "hardness": 5}]})";
        const auto kind = [one](const char* radius, const char* depth) {
            return QByteArray(one).replace("%R", radius).replace("%H", depth);
        };
        const QString first = QStringLiteral("$.parameters.lump_kinds[0].");
        QTest::newRow("lump near the surface") << "visible_lump" << kind("9.1", "12") << first + "radius_mm"
                                               << "at most 0.75 times the depth of its middle, 9 mm";
        QTest::newRow("pad as wide as deep") << "visible_lump" << kind("5", "9") << first + "depth_mm"
                                             << "at least 10 mm";
        QTest::newRow("pressed onto the lump")
            << "size_and_hardness" << kind("7.5", "11") << first + "depth_mm"
            << "maximum_force_N presses a finger in by 8.8";
        row("shallow by its spread", "visible_lump", R"({"depth_spread_mm": 2.5})",
            "$.parameters.lump_kinds[0].radius_mm", "depth_mm less depth_spread_mm");
        row("low over high", "visible_lump", R"({"lumps_low": 2})", "$.parameters.lumps_low",
            "at most lumps_high, 1");
        row("only catch trials", "visible_lump", R"({"catch_trials": 4})", "$.parameters.catch_trials",
            "less than trials, 4");
        row("no room", "several_or_none", R"({"lumps_high": 6, "spacing_mm": 60})", "$.parameters.lumps_high",
            "no more fit");
        row("nothing beside the distractor", "several_or_none", R"({"region_columns": 1, "region_rows": 1})",
            "$.parameters.lumps_high", "at most 0");
        row("moved out of the area", "visible_lump",
            R"({"control_move_after_s": 5, "control_move_x_mm": 90})", "$.parameters.lumps_high",
            "before and after");
        row("bends too much for the depth", "size_and_hardness",
            R"({"tissue": {"tissue": "prostate", "layers": [{"name": "gland", "modulus_kPa": 10}]}})",
            "$.parameters.tissue.bumps", "maximum_force_N presses a finger in by 15");
        row("bends more than a pad", "visible_lump",
            R"({"tissue": {"tissue": "pad", "bumps": [{"radius_x_mm": 8, "radius_y_mm": 8, "height_mm": 5}]}})",
            "$.parameters.tissue.bumps", "contact_radius_mm");
        row("band upside down", "visible_lump", R"({"band_low_N": 3})", "$.parameters.band_low_N",
            "less than band_high_N, 2.5 N");
        row("band over the cap", "visible_lump", R"({"band_high_N": 4.2})", "$.parameters.band_high_N",
            "at most maximum_force_N, 4 N");
        row("covered by no press as asked", "visible_lump", R"({"cover_force_N": 3})",
            "$.parameters.cover_force_N", "at most band_low_N, 0.8 N");
        row("covered above the band's lower edge", "visible_lump", R"({"cover_force_N": 0.9})",
            "$.parameters.cover_force_N", "at most band_low_N, 0.8 N");
        row("soft distractors on each other", "visible_lump",
            R"({"tissue": {"tissue": "pad", "distractors": [{"name": "a", "radius_x_mm": 10, "radius_y_mm": 10, "gain": -0.5}, {"name": "b", "radius_x_mm": 10, "radius_y_mm": 10, "gain": -0.6}]}})",
            "$.parameters.tissue.distractors", "more than -1 in all");
        row("three hands", "visible_lump", R"({"hands": 3})", "$.parameters.hands", "1 to 2");
        row("unknown tissue", "visible_lump", R"({"tissue": "spleen"})", "$.parameters.tissue",
            "one of breast, pad, prostate");
        row("unknown property", "visible_lump", R"({"tissue": {"tissue": "pad", "colour": 3}})",
            "$.parameters.tissue.colour", "");
        row("unknown law", "visible_lump", R"({"tissue": {"tissue": "pad", "lump_law": "magic"}})",
            "$.parameters.tissue.lump_law", "inclusion");
        row("layer without modulus", "visible_lump",
            R"({"tissue": {"tissue": "pad", "layers": [{"name": "skin"}]}})",
            "$.parameters.tissue.layers[0].modulus_kPa", "");
        row("no layer", "visible_lump", R"({"tissue": {"tissue": "pad", "layers": []}})",
            "$.parameters.tissue.layers", "");
        row("five bumps", "visible_lump",
            R"({"tissue": {"tissue": "pad", "bumps": [{"radius_x_mm": 50, "radius_y_mm": 50, "height_mm": 1}, {"radius_x_mm": 50, "radius_y_mm": 50, "height_mm": 1}, {"radius_x_mm": 50, "radius_y_mm": 50, "height_mm": 1}, {"radius_x_mm": 50, "radius_y_mm": 50, "height_mm": 1}, {"radius_x_mm": 50, "radius_y_mm": 50, "height_mm": 1}]}})",
            "$.parameters.tissue.bumps", "");
        row("seven lumps", "visible_lump", R"({"lumps_high": 7})", "$.parameters.lumps_high", "0 to 6");
        row("hardness", "visible_lump",
            R"({"lump_kinds": [{"radius_mm": 5, "depth_mm": 12, "ratio": 10, "hardness": 6}]})",
            "$.parameters.lump_kinds[0].hardness", "1 to 5");
        row("unknown key", "visible_lump", R"({"colour": 3})", "$.parameters.colour", "");
    }
    void faults() {
        QFETCH(QString, level);
        QFETCH(QByteArray, change);
        QFETCH(QString, place);
        QFETCH(QString, expected);
        const ContentCopy copy;
        const QString file = kLevels + level + QStringLiteral(".json");
        QJsonObject json = QJsonDocument::fromJson(copy.read(file)).object();
        QJsonObject parameters = json["parameters"].toObject();
        const QJsonObject changes = QJsonDocument::fromJson(change).object();
        QVERIFY(!changes.isEmpty());
        for (auto it = changes.begin(); it != changes.end(); ++it)
            parameters[it.key()] = it.value();
        json["parameters"] = parameters;
        copy.write(file, QJsonDocument(json).toJson());
        const auto catalogue = Catalogue::load(copy.directory());
        QVERIFY(!catalogue.has_value());
        const QString told = QString::fromStdString(catalogue.error().message);
        QVERIFY2(told.contains(file) && told.contains(place) && told.contains(expected), qPrintable(told));
    }

    // A fault in a tissue is told in its own file.
    void faultInATissue() {
        const ContentCopy copy;
        QByteArray text = copy.read("tissues/prostate.json");
        QVERIFY(text.contains("\"modulus_kPa\": 17"));
        copy.write("tissues/prostate.json", text.replace("\"modulus_kPa\": 17", "\"modulus_kPa\": 1700"));
        const auto catalogue = Catalogue::load(copy.directory());
        QVERIFY(!catalogue.has_value());
        const QString told = QString::fromStdString(catalogue.error().message);
        QVERIFY2(told.contains("tissues/prostate.json") &&
                     told.contains("$.properties.layers[0].modulus_kPa"),
                 qPrintable(told));
    }
};

QTEST_GUILESS_MAIN(TestPalpationContent)
#include "test_palpation_content.moc"
