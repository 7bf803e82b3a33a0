// SPDX-License-Identifier: GPL-3.0-or-later
// The truth of a trial as each exercise's own struct: from its named values and back, and what is said of a
// field that is missing or impossible.

#include "curriculum/exercises/elastic_tube/scoring/tube_truth.h"
#include "curriculum/exercises/object_handling/scoring/handling_truth.h"
#include "curriculum/exercises/palpation/scoring/palpation_truth.h"
#include "scoring/truth_reader.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::scoring;

namespace {

TubeTruth tube() {
    TubeTruth truth;
    truth.target_N = 1.2;
    truth.band_N = 0.15;
    truth.retractionLow_N = 0.6;
    truth.retractionHigh_N = 1.0;
    truth.overStretch_m = 0.0315;
    truth.tear_m = 0.0405;
    truth.hold_s = 3.0;
    truth.task = 2;
    return truth;
}

HandlingTruth handling() {
    HandlingTruth truth;
    truth.targetX_m = 0.01;
    truth.targetY_m = -0.02;
    truth.targetRadius_m = 0.014;
    truth.squeezeLimit_N = 1.5;
    truth.task = 1;
    truth.objects = 3;
    truth.heaviest = 2;
    truth.masses_kg = {0.02, 0.03, 0.05};
    return truth;
}

PalpationTruth palpation() {
    PalpationTruth truth;
    truth.lumps = {{core::Vec3(0.01, 0.02, 0.001), 0.012, 0.0075, 4},
                   {core::Vec3(-0.02, 0.0, 0.002), 0.015, 0.01, 1}};
    truth.areaHalf_m = {0.03, 0.025};
    truth.regionColumns = 4;
    truth.regionRows = 2;
    truth.hitRadius_m = 0.011;
    truth.bandLow_N = 0.8;
    truth.bandHigh_N = 2.5;
    truth.coverForce_N = 0.5;
    truth.introduction = true;
    truth.asksSize = true;
    return truth;
}

QStringList namesOf(const std::vector<NamedValue>& values) {
    QStringList names;
    for (const NamedValue& value : values)
        names << QString::fromStdString(value.id);
    return names;
}

std::vector<NamedValue> with(std::vector<NamedValue> values, const char* id, double value) {
    for (NamedValue& each : values)
        if (each.id == id)
            each.value = value;
    return values;
}

std::vector<NamedValue> without(std::vector<NamedValue> values, const char* id) {
    std::erase_if(values, [id](const NamedValue& value) { return value.id == id; });
    return values;
}

/// Refused, with the field in the message.
template <class Truth> bool blames(const core::Result<Truth>& read, const char* field) {
    return !read && read.error().code == core::ErrorCode::badInput &&
           read.error().message.find('"' + std::string(field) + '"') != std::string::npos;
}

} // namespace

class TestTrialTruth : public QObject {
    Q_OBJECT
private slots:
    void valuesGiveTheTruthBack();
    void theNamesKeepTheirOrder();
    void whatIsNotRecordedIsEmpty();
    void aFaultNamesItsField();
    void theFirstFaultIsTold();
    void anImpossibleTruthLeavesMetricsWithoutValue();
};

void TestTrialTruth::valuesGiveTheTruthBack() {
    QVERIFY(*tubeTruthOf(valuesOf(tube())) == tube());
    TubeTruth mark;
    mark.mark_m = 0.018;
    mark.markTolerance_m = 0.0018;
    QVERIFY(*tubeTruthOf(valuesOf(mark)) == mark);
    QVERIFY(*handlingTruthOf(valuesOf(handling())) == handling());
    const std::vector<NamedValue> stored = valuesOf(palpation());
    const auto read = palpationTruthOf(stored);
    QVERIFY(read);
    const std::vector<NamedValue> again = valuesOf(*read);
    QCOMPARE(namesOf(again), namesOf(stored));
    for (std::size_t i = 0; i < stored.size(); ++i)
        QCOMPARE(again[i].value, stored[i].value);
    QCOMPARE(read->lumps.size(), std::size_t{2});
    QCOMPARE(read->lumps[1].hardness, 1);
    QVERIFY(read->introduction && read->asksSize && !read->asksHardness);
}

/// Exported columns and stored trials have them in this order.
void TestTrialTruth::theNamesKeepTheirOrder() {
    QCOMPARE(namesOf(valuesOf(tube())),
             (QStringList{"target_N", "band_N", "retraction_low_N", "retraction_high_N", "over_stretch_m",
                          "tear_m", "hold_s", "task"}));
    QCOMPARE(namesOf(valuesOf(handling())),
             (QStringList{"target_x_m", "target_y_m", "target_radius_m", "squeeze_limit_N", "task", "objects",
                          "heaviest", "mass_0_kg", "mass_1_kg", "mass_2_kg"}));
    PalpationTruth one = palpation();
    one.lumps.resize(1);
    QCOMPARE(namesOf(valuesOf(one)),
             (QStringList{"lumps", "introduction", "lump_0_x_m", "lump_0_y_m", "lump_0_z_m", "lump_0_depth_m",
                          "lump_0_radius_m", "lump_0_hardness", "area_half_x_m", "area_half_y_m",
                          "region_columns", "region_rows", "hit_radius_m", "band_low_N", "band_high_N",
                          "cover_force_N", "asks_size", "asks_hardness"}));
    one.introduction = false; // sessions before it existed have no such name
    QVERIFY(!namesOf(valuesOf(one)).contains(QStringLiteral("introduction")));
}

void TestTrialTruth::whatIsNotRecordedIsEmpty() {
    QVERIFY(*tubeTruthOf({}) == TubeTruth{});
    QVERIFY(*handlingTruthOf({}) == HandlingTruth{});
    const auto noTarget = tubeTruthOf(without(valuesOf(tube()), "target_N"));
    QVERIFY(noTarget && !noTarget->target_N && noTarget->band_N == 0.15);
    // As in a trace file, where an empty field is no number.
    const auto notFinite = tubeTruthOf(with(valuesOf(tube()), "target_N", std::nan("")));
    QVERIFY(notFinite && !notFinite->target_N);
    const PalpationBand band = palpationBandOf(std::vector<NamedValue>{{"band_low_N", 0.8}});
    QVERIFY(band.low_N == 0.8 && !band.high_N);
}

void TestTrialTruth::aFaultNamesItsField() {
    QVERIFY(blames(tubeTruthOf(with(valuesOf(tube()), "task", -1.0)), "task"));
    QVERIFY(blames(handlingTruthOf(with(valuesOf(handling()), "objects", 1e12)), "objects"));
    QVERIFY(blames(handlingTruthOf(with(valuesOf(handling()), "heaviest", -2.0)), "heaviest"));
    const std::vector<NamedValue> good = valuesOf(palpation());
    for (const char* needed : {"lumps", "lump_0_x_m", "lump_1_radius_m", "lump_1_hardness", "area_half_x_m",
                               "area_half_y_m", "region_columns", "region_rows", "hit_radius_m"})
        QVERIFY2(blames(palpationTruthOf(without(good, needed)), needed), needed);
    for (const auto& [field, value] : {std::pair<const char*, double>{"lumps", 7.0},
                                       {"lump_0_radius_m", -0.001},
                                       {"lump_0_hardness", 6.0},
                                       {"area_half_x_m", 0.0},
                                       {"region_rows", 1e9},
                                       {"hit_radius_m", -1.0}})
        QVERIFY2(blames(palpationTruthOf(with(good, field, value)), field), field);
    QCOMPARE(palpationTruthOf(with(good, "region_columns", 65.0)).error().message,
             std::string("truth \"region_columns\": found 65, expected a whole number from 1 to 64"));
    QCOMPARE(palpationTruthOf(without(good, "hit_radius_m")).error().message,
             std::string("truth \"hit_radius_m\": found nothing, expected a number of 0 or more"));
}

void TestTrialTruth::theFirstFaultIsTold() {
    const std::vector<NamedValue> values{{"a", 1.0}, {"b", -1.0}, {"a", 2.0}};
    TruthReader read(values);
    QCOMPARE(read.number("a"), 1.0); // the first of a name
    QVERIFY(read.done());
    QCOMPARE(read.atLeast(0.0, "b"), -1.0);
    QCOMPARE(read.count("c", 3, 5), 3);
    QVERIFY(!read.done());
    QVERIFY(read.done().error().message.find("\"b\"") != std::string::npos);
}

/// Nothing is measured against half a truth.
void TestTrialTruth::anImpossibleTruthLeavesMetricsWithoutValue() {
    TrialTrace trial;
    trial.truth = with(valuesOf(tube()), "task", -1.0);
    QVERIFY(tubeTruthIn(trial) == TubeTruth{});
    trial.truth = with(valuesOf(handling()), "objects", -1.0);
    QVERIFY(handlingTruthIn(trial) == HandlingTruth{});
}

QTEST_APPLESS_MAIN(TestTrialTruth)
#include "test_trial_truth.moc"
