// SPDX-License-Identifier: GPL-3.0-or-later
// A canal's columns in a trace file: exact both ways, so that a file scores as the session did, bit for bit.
#include "insertion_traces.h"

#include "core/random.h"
#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"

#include <QtTest>
#include <algorithm>
#include <bit>

using namespace chiron;
using namespace chiron::scoring;
using traces::CanalSample;
using traces::canalSession;
using traces::canalTrial;
using traces::ProcedureStage;
using traces::Vec3;

namespace {

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

/// A wild trial, nothing of it on a grid.
TrialTrace wildTrial(std::uint64_t seed) {
    core::Random random(seed);
    TrialTrace trial = canalTrial(4.0, 0.001, [&](double t) {
        return CanalSample{0.03 * t + 0.002 * std::sin(9.1 * t),
                           0.003 * random.uniform(),
                           0.4 * random.uniform(),
                           1.9 + 0.5 * std::sin(7.3 * t),
                           0.009 * random.uniform(),
                           t < 0.2   ? ProcedureStage::outside
                           : t < 3.0 ? ProcedureStage::insertion
                           : t < 3.5 ? ProcedureStage::inspection
                                     : ProcedureStage::withdrawal};
    });
    ToolTrace& tool = trial.tools.front();
    for (std::size_t i = 0; i < tool.t_s.size(); ++i) {
        tool.p_WT_m[i] += 1e-5 * Vec3(random.normal(), random.normal(), random.normal());
        tool.tissue_N[i] = Vec3(random.normal(), random.normal(), random.normal());
        tool.tissueTorque_Nm.push_back(0.02 * Vec3(random.normal(), random.normal(), random.normal()));
        tool.q_WT.push_back(
            core::Quat(1.0 + random.uniform(), random.normal(), random.normal(), random.normal())
                .normalized());
        tool.commanded_N.push_back(0.9 * tool.tissue_N[i]);
    }
    for (std::size_t i = 700; i < 900; ++i)
        tool.paused[i] = 1;
    insertionIn(trial).length_m = 0.1098765432109;
    insertionIn(trial).bend_m = 0.0401234567;
    insertionIn(trial).goal_m = 0.11987654321;
    insertionIn(trial).lateralLimit_N = 2.0003;
    insertionIn(trial).landmarkSeen_s = {3.1, kNever, 3.4567894, 3.3};
    trial.completed = true;
    return trial;
}

SessionTrace again(const SessionTrace& trace) {
    const auto rows = readTraceCsv(writeTraceCsv(rowsOf(trace)), "again.csv");
    if (!rows)
        qFatal("%s", rows.error().message.c_str());
    auto back = buildSessionTrace(*rows, trace.exercise);
    if (!back)
        qFatal("%s", back.error().message.c_str());
    return std::move(*back);
}

bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) { return same(x, y); });
}

const std::string kHeader =
    "t_s,x_mm,y_mm,z_mm,arc_mm,offset_mm,alignment_deg,lateral_N,axial_mNm,stage,landmarks_seen,"
    "completed,length_mm,bend_mm,goal_mm,lateral_limit_N,landmarks\n";

std::string row(const std::string& t_s, const std::string& canal = "1,0.5,2,0.1,0.25,insertion,0",
                const std::string& trial = "1,110,40,80,2,2") {
    return t_s + ",1,2,3," + canal + "," + trial + "\n";
}

} // namespace

class TestInsertionCsv : public QObject {
    Q_OBJECT
private slots:
    void columnsOfACanal();
    void everyMetricIsKeptBitForBit();
    void seriesAreKeptBitForBit();
    void eventsAreKeptBitForBit();
    void gridsAreIdempotent();
    void landmarksAreSeenAtASample();
    void otherExercisesHaveNoneOfIt();
    void writesExactDecimals();
    void refusals_data();
    void refusals();
};

void TestInsertionCsv::columnsOfACanal() {
    const std::string text = kHeader + row("0", "-1.5,0.5,2.25,0.1,0.25,outside,0") +
                             row("0.001", "1,0,0,0,0,insertion,2") + row("0.002", "2,0,0,0,0,completed,3");
    const auto rows = readTraceCsv(text, "c.csv");
    QVERIFY2(rows, rows ? "" : rows.error().message.c_str());
    QVERIFY(rows->columns.own == &canalColumns() && !rows->columns.torque && !rows->columns.orientation);
    const auto trace = buildSessionTrace(*rows, "urethra_insertion");
    QVERIFY2(trace, trace ? "" : trace.error().message.c_str());
    const TrialTrace& trial = trace->trials.at(0);
    QVERIFY(trial.own && trial.completed && trial.tools[0].q_WT.empty() &&
            trial.tools[0].tissueTorque_Nm.empty());
    const InsertionSeries& series = insertionIn(trial);
    QCOMPARE(series.s_m, (std::vector<double>{-0.0015, 0.001, 0.002}));
    QCOMPARE(series.offset_m[0], 0.0005);
    QVERIFY(std::abs(series.alignment_rad[0] - 2.25 * 3.14159265358979 / 180.0) < 1e-15);
    QCOMPARE(series.lateral_N[0], 0.1);
    QCOMPARE(series.axialTorque_Nm[0], 0.00025);
    QCOMPARE(series.stage, (std::vector<std::uint8_t>{0, 1, 4}));
    QCOMPARE(series.length_m, 0.110);
    QCOMPARE(series.bend_m, 0.040);
    QCOMPARE(series.goal_m, 0.080);
    QCOMPARE(series.lateralLimit_N, 2.0);
    QCOMPARE(series.landmarkSeen_s, (std::vector<double>{0.002, 0.001})); // the second one first
}

void TestInsertionCsv::everyMetricIsKeptBitForBit() {
    TrialTrace second = wildTrial(2);
    for (double& t_s : second.tools[0].t_s)
        t_s += 10.0;
    for (double& seen_s : insertionIn(second).landmarkSeen_s)
        seen_s += 10.0;
    const SessionTrace trace = canalSession({wildTrial(1), second});
    const SessionTrace back = again(trace);
    std::vector<MetricRequest> all;
    for (const MetricDefinition& metric : metricCatalogue())
        all.push_back({std::string(metric.id), metric.version});
    const auto a = calculateScore(trace, all, {}, true);
    const auto b = calculateScore(back, all, {}, true);
    QVERIFY(a && b);
    int defined = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        QVERIFY2(a->metrics[i].value.has_value() == b->metrics[i].value.has_value(), all[i].id.c_str());
        if (!a->metrics[i].value)
            continue;
        ++defined;
        QVERIFY2(same(*a->metrics[i].value, *b->metrics[i].value), all[i].id.c_str());
        for (std::size_t trial = 0; trial < 2; ++trial)
            QVERIFY2(a->trials[trial][i].value == b->trials[trial][i].value, all[i].id.c_str());
    }
    QCOMPARE(defined,
             static_cast<int>(all.size()) - 46); // all but those of the apex, the tube, loose objects,
                                                 // findings, and the prediction of a soft organ
    QVERIFY(*a->metrics[0].value > 0.0);
}

void TestInsertionCsv::seriesAreKeptBitForBit() {
    const SessionTrace trace = canalSession(wildTrial(3));
    const auto a = onStoredGrids(trace)->trials[0];
    const auto b = onStoredGrids(again(trace))->trials[0];
    QVERIFY(b.own && b.completed == a.completed);
    QVERIFY(same(insertionIn(a).s_m, insertionIn(b).s_m));
    QVERIFY(same(insertionIn(a).offset_m, insertionIn(b).offset_m));
    QVERIFY(same(insertionIn(a).alignment_rad, insertionIn(b).alignment_rad));
    QVERIFY(same(insertionIn(a).lateral_N, insertionIn(b).lateral_N));
    QVERIFY(same(insertionIn(a).axialTorque_Nm, insertionIn(b).axialTorque_Nm));
    QCOMPARE(insertionIn(a).stage, insertionIn(b).stage);
    QVERIFY(same(insertionIn(a).length_m, insertionIn(b).length_m) &&
            same(insertionIn(a).bend_m, insertionIn(b).bend_m));
    QVERIFY(same(insertionIn(a).goal_m, insertionIn(b).goal_m) &&
            same(insertionIn(a).lateralLimit_N, insertionIn(b).lateralLimit_N));
    QVERIFY(std::isnan(insertionIn(b).landmarkSeen_s[1]));
    QVERIFY(same(insertionIn(a).landmarkSeen_s[2], insertionIn(b).landmarkSeen_s[2]));
    for (std::size_t i = 0; i < a.tools[0].t_s.size(); ++i) {
        QVERIFY(a.tools[0].q_WT[i].coeffs() == b.tools[0].q_WT[i].coeffs());
        QVERIFY(a.tools[0].tissueTorque_Nm[i] == b.tools[0].tissueTorque_Nm[i]);
    }
}

void TestInsertionCsv::eventsAreKeptBitForBit() {
    const SessionTrace trace = canalSession(wildTrial(4));
    const auto a = insertionEvents(onStoredGrids(trace)->trials[0]);
    const auto b = insertionEvents(onStoredGrids(again(trace))->trials[0]);
    QVERIFY(a.trauma.size() > 1);
    QCOMPARE(a.trauma.size(), b.trauma.size());
    QCOMPARE(a.reversals.size(), b.reversals.size());
    for (std::size_t i = 0; i < a.trauma.size(); ++i)
        QVERIFY(same(a.trauma[i].begin_s, b.trauma[i].begin_s) &&
                same(a.trauma[i].end_s, b.trauma[i].end_s) && same(a.trauma[i].value, b.trauma[i].value));
}

void TestInsertionCsv::gridsAreIdempotent() {
    core::Random random(8);
    for (int i = 0; i < 100000; ++i) {
        const double angle_rad = 3.14159265358979 * random.uniform();
        const double once = onMicrodegrees(angle_rad);
        QVERIFY(same(once, onMicrodegrees(once)));
        QVERIFY(std::abs(once - angle_rad) <= 0.51e-6 * 3.14159265358979 / 180.0);
        const double torque_Nm = 0.2 * (random.uniform() - 0.5);
        QVERIFY(same(onTorqueGrid(torque_Nm), onTorqueGrid(onTorqueGrid(torque_Nm))));
        QVERIFY(std::abs(onTorqueGrid(torque_Nm) - torque_Nm) <= 0.501e-5);
    }
}

void TestInsertionCsv::landmarksAreSeenAtASample() {
    auto trial = canalTrial(0.01, 0.001, [](double) { return CanalSample{0.05}; });
    insertionIn(trial).landmarkSeen_s = {0.0034, 0.003, 0.0, 0.0101, kNever};
    const auto seen = insertionIn(traces::onGrids(trial)).landmarkSeen_s;
    QCOMPARE(seen[0], 0.004); // between two samples: the later one
    QCOMPARE(seen[1], 0.003);
    QCOMPARE(seen[2], 0.0);
    QVERIFY(std::isnan(seen[3]) && std::isnan(seen[4]));
}

void TestInsertionCsv::otherExercisesHaveNoneOfIt() {
    const auto sphere =
        traces::session(traces::sampled(0.1, 0.001, [](double t) { return Vec3(t, 0.0, 0.0); }));
    const TraceRows rows = rowsOf(sphere);
    QVERIFY(rows.columns.own == nullptr && !rows.columns.torque && !rows.columns.orientation);
    QCOMPARE(
        traceCsvHeader(rows.columns),
        std::string(
            "t_s,x_mm,y_mm,z_mm,tool,fx_N,fy_N,fz_N,trial,paused,marked,timed_out,mark_in_contact,mark_x_mm,"
            "mark_y_mm,mark_z_mm,force_limit_N\n"));
    QVERIFY(!again(sphere).trials[0].own);
}

void TestInsertionCsv::writesExactDecimals() {
    TraceRows rows;
    rows.columns.torque = rows.columns.completed = true;
    rows.columns.own = &canalColumns();
    TraceRow r;
    r.tissueTorque_Nm = Vec3(-0.00001, 0.15, 0.00123);
    // arc, offset, alignment, lateral, axial, stage, landmarks seen; length, bend, goal, limit, landmarks
    r.own = {-0.010000001, 0.001234567, onMicrodegrees(12.345678 * 3.14159265358979323846 / 180.0),
             2.001,        0.00999,     static_cast<double>(ProcedureStage::withdrawal),
             5.0,          0.11,        0.04,
             0.12,         2.0,         3.0};
    rows.rows.push_back(r);
    QCOMPARE(writeTraceCsv(rows),
             "t_s,x_mm,y_mm,z_mm,tx_mNm,ty_mNm,tz_mNm," + kHeader.substr(kHeader.find("arc_mm")) +
                 "0.000000,0.000000,0.000000,0.000000,-0.01,150.00,1.23,-10.000001,1.234567,12.345678,"
                 "2.001,9.99,withdrawal,5,0,110.000000,40.000000,120.000000,2.000,3\n");
}

void TestInsertionCsv::refusals_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("place");
    const auto one = [](const std::string& canal, const std::string& trial = "1,110,40,80,2,2") {
        return QByteArray::fromStdString(kHeader + row("0", canal, trial));
    };
    QTest::newRow("negative offset") << one("1,-0.5,2,0.1,0.25,insertion,0")
                                     << QByteArray("offset_mm \"-0.5\"");
    QTest::newRow("angle over 180") << one("1,0.5,181,0.1,0.25,insertion,0")
                                    << QByteArray("degrees, 0 to 180");
    QTest::newRow("negative lateral force")
        << one("1,0.5,2,-0.1,0.25,insertion,0") << QByteArray("lateral_N");
    QTest::newRow("negative torque") << one("1,0.5,2,0.1,-1,insertion,0") << QByteArray("millinewton metres");
    QTest::newRow("unknown stage") << one("1,0.5,2,0.1,0.25,resting,0") << QByteArray("stage \"resting\"");
    QTest::newRow("stage as a number")
        << one("1,0.5,2,0.1,0.25,1,0") << QByteArray("outside, insertion, inspection");
    QTest::newRow("no length") << one("1,0.5,2,0.1,0.25,insertion,0", "1,0,40,80,2,2")
                               << QByteArray("length_mm");
    QTest::newRow("no limit") << one("1,0.5,2,0.1,0.25,insertion,0", "1,110,40,80,0,2")
                              << QByteArray("lateral_limit_N");
    QTest::newRow("33 landmarks") << one("1,0.5,2,0.1,0.25,insertion,0", "1,110,40,80,2,33")
                                  << QByteArray("0 to 32");
    QTest::newRow("not finite") << one("nan,0.5,2,0.1,0.25,insertion,0") << QByteArray("arc_mm");
    QTest::newRow("half a group") << QByteArray("t_s,x_mm,y_mm,z_mm,tx_mNm\n0,1,2,3,4\n")
                                  << QByteArray("no column \"ty_mNm\"");
    for (const auto& [name, trial] : {std::pair{"completed", "0,110,40,80,2,2"},
                                      {"length_mm", "1,111,40,80,2,2"},
                                      {"bend_mm", "1,110,41,80,2,2"},
                                      {"goal_mm", "1,110,40,81,2,2"},
                                      {"lateral_limit_N", "1,110,40,80,3,2"},
                                      {"landmarks", "1,110,40,80,2,1"}})
        QTest::newRow(name) << QByteArray::fromStdString(kHeader + row("0") +
                                                         row("0.001", "1,0.5,2,0.1,0.25,insertion,0", trial))
                            << QByteArray(name) + " changes at t_s 0.001";
}

void TestInsertionCsv::refusals() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, place);
    const auto rows = readTraceCsv(text.toStdString(), "r.csv");
    const auto trace = rows ? buildSessionTrace(*rows, "urethra_insertion")
                            : core::Result<SessionTrace>(tl::unexpected(rows.error()));
    QVERIFY(!trace);
    QVERIFY(trace.error().code == core::ErrorCode::badInput);
    QVERIFY2(trace.error().message.find(place.toStdString()) != std::string::npos,
             trace.error().message.c_str());
}

QTEST_APPLESS_MAIN(TestInsertionCsv)
#include "test_insertion_csv.moc"
