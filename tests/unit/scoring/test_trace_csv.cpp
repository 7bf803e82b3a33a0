// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_csv.h"

#include "core/random.h"

#include <QTemporaryDir>
#include <QtTest>
#include <bit>
#include <clocale>
#include <cmath>

using namespace chiron;
using namespace chiron::scoring;

namespace {

const std::string kPlain = "t_s,x_mm,y_mm,z_mm\n0,1,2,3\n0.001,1.5,2,3\n";

} // namespace

class TestTraceCsv : public QObject {
    Q_OBJECT
private slots:
    void plainFile();
    void everyColumn();
    void acceptsByteOrderMarkCrlfAndTrailingLines_data();
    void acceptsByteOrderMarkCrlfAndTrailingLines();
    void ignoresLocale();
    void writesExactDecimals();
    void roundTripKeepsBits();
    void missingFileIsNotFound();
    void readsFiles();
};

void TestTraceCsv::plainFile() {
    const auto rows = readTraceCsv(kPlain, "plain.csv");
    QVERIFY(rows.has_value());
    QCOMPARE(rows->rows.size(), std::size_t{2});
    QCOMPARE(rows->rows[1].t_s, 0.001);
    QCOMPARE(rows->rows[1].p_WT_m.x(), 0.0015);
    QVERIFY(!rows->columns.orientation && !rows->columns.tissue && !rows->columns.buttons);
    QVERIFY(rows->rows[0].q_WT.coeffs() == core::Quat::Identity().coeffs());
}

void TestTraceCsv::everyColumn() {
    TraceColumns columns;
    columns.orientation = columns.jaw = columns.buttons = columns.tool = columns.tissue = columns.commanded =
        columns.measured = columns.trial = columns.phase = columns.paused = columns.mark = columns.target =
            columns.forceLimit = true;
    QCOMPARE(traceCsvHeader(columns),
             std::string(
                 "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw_deg,buttons,tool,fx_N,fy_N,fz_N,commanded_fx_N,"
                 "commanded_fy_N,commanded_fz_N,measured_fx_N,measured_fy_N,measured_fz_N,trial,phase,paused,"
                 "marked,timed_out,mark_in_contact,mark_x_mm,mark_y_mm,mark_z_mm,target_x_mm,target_y_mm,"
                 "target_radius_mm,force_limit_N\n"));
    const std::string row =
        "0.5,1,2,3,0,1,0,0,90,5,2,0.1,0.2,0.3,1.1,1.2,1.3,2.1,2.2,2.3,4,between,1,1,0,1,7,8,9,"
        "10,11,20,3.5\n";
    const auto read = readTraceCsv(traceCsvHeader(columns) + row, "all.csv");
    QVERIFY2(read.has_value(), read ? "" : read.error().message.c_str());
    const TraceRow& r = read->rows.at(0);
    QCOMPARE(r.q_WT.x(), 1.0);
    QVERIFY(std::abs(r.jaw_rad - 1.5707963267948966) < 1e-15);
    QCOMPARE(r.buttons, 5u);
    QCOMPARE(int(r.tool), 2);
    QCOMPARE(r.tissue_N.y(), 0.2);
    QCOMPARE(r.commanded_N.z(), 1.3);
    QCOMPARE(r.measured_N.x(), 2.1);
    QCOMPARE(r.trial, 3);
    QVERIFY(r.phase == core::TrialPhase::between && r.paused && r.marked && !r.timedOut && r.markInContact);
    QCOMPARE(r.p_WMark_m.y(), 0.008);
    QCOMPARE(r.target_m.x(), 0.010);
    QCOMPARE(r.targetRadius_m, 0.020);
    QCOMPARE(r.forceLimit_N, 3.5);
}

void TestTraceCsv::acceptsByteOrderMarkCrlfAndTrailingLines_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("BOM") << QByteArray("\xef\xbb\xbft_s,x_mm,y_mm,z_mm\n0,1,2,3\n1,1,2,3\n");
    QTest::newRow("CRLF") << QByteArray("t_s,x_mm,y_mm,z_mm\r\n0,1,2,3\r\n1,1,2,3\r\n");
    QTest::newRow("no newline at the end") << QByteArray("t_s,x_mm,y_mm,z_mm\n0,1,2,3\n1,1,2,3");
    QTest::newRow("empty lines at the end") << QByteArray("t_s,x_mm,y_mm,z_mm\n0,1,2,3\n1,1,2,3\n\n\r\n");
    QTest::newRow("other order") << QByteArray("z_mm,t_s,y_mm,x_mm\n3,0,2,1\n3,1,2,1\n");
    QTest::newRow("exponents") << QByteArray("t_s,x_mm,y_mm,z_mm\n0,1e0,0.2E1,30e-1\n1.0,1,2,3\n");
}

void TestTraceCsv::acceptsByteOrderMarkCrlfAndTrailingLines() {
    QFETCH(QByteArray, text);
    const auto rows = readTraceCsv(text.toStdString(), "f.csv");
    QVERIFY2(rows.has_value(), rows ? "" : rows.error().message.c_str());
    QCOMPARE(rows->rows.size(), std::size_t{2});
    for (const auto& row : rows->rows)
        QVERIFY(row.p_WT_m == core::Vec3(0.001, 0.002, 0.003));
}

void TestTraceCsv::ignoresLocale() {
    for (const char* name : {"de_DE.UTF-8", "el_GR.UTF-8", "C.UTF-8", "C"}) {
        std::setlocale(LC_ALL, name); // where it is not installed, the test repeats the one before
        const auto rows = readTraceCsv(kPlain, "f.csv");
        QVERIFY(rows.has_value());
        QCOMPARE(rows->rows[1].p_WT_m.x(), 0.0015);
        QVERIFY(writeTraceCsv(*rows).find("0.001000,1.500000,") != std::string::npos);
    }
    std::setlocale(LC_ALL, "C");
}

void TestTraceCsv::writesExactDecimals() {
    TraceRows rows;
    rows.columns.tissue = true;
    TraceRow row;
    row.t_s = -0.000001;
    row.p_WT_m = core::Vec3(-1e-9, 0.123456789, -12.000000001);
    row.tissue_N = core::Vec3(-0.001, 4.0, 1234.567);
    rows.rows.push_back(row);
    row.t_s = 0.0;
    rows.rows.push_back(row);
    rows.rows.push_back(row); // a packet read twice is not written twice
    const std::string text = writeTraceCsv(rows);
    QCOMPARE(text, std::string("t_s,x_mm,y_mm,z_mm,fx_N,fy_N,fz_N\n"
                               "-0.000001,-0.000001,123.456789,-12000.000001,-0.001,4.000,1234.567\n"
                               "0.000000,-0.000001,123.456789,-12000.000001,-0.001,4.000,1234.567\n"));
}

void TestTraceCsv::roundTripKeepsBits() {
    core::Random random(4);
    TraceRows rows;
    rows.columns.orientation = rows.columns.tissue = rows.columns.tool = true;
    for (int i = 0; i < 5000; ++i) {
        TraceRow row;
        row.t_s = static_cast<double>(i * 1000 + static_cast<int>(random.below(900))) / 1e6;
        row.tool = static_cast<std::uint8_t>(i % 4);
        for (int axis = 0; axis < 3; ++axis) {
            row.p_WT_m[axis] = (static_cast<double>(random.below(400000000)) - 2e8) / 1e9;
            row.tissue_N[axis] = (static_cast<double>(random.below(8000)) - 4e3) / 1e3;
        }
        row.q_WT =
            core::Quat(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
        rows.rows.push_back(row);
    }
    const auto again = readTraceCsv(writeTraceCsv(rows), "round.csv");
    QVERIFY2(again.has_value(), again ? "" : again.error().message.c_str());
    QCOMPARE(again->rows.size(), rows.rows.size());
    const auto same = [](double a, double b) {
        return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b + 0.0);
    };
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        QVERIFY(same(again->rows[i].t_s, rows.rows[i].t_s));
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(same(again->rows[i].p_WT_m[axis], rows.rows[i].p_WT_m[axis]));
            QVERIFY(same(again->rows[i].tissue_N[axis], rows.rows[i].tissue_N[axis]));
        }
        QVERIFY(again->rows[i].q_WT.coeffs() == rows.rows[i].q_WT.coeffs());
    }
}

void TestTraceCsv::missingFileIsNotFound() {
    const auto missing = readTraceCsvFile("/no/such/trace.csv");
    QVERIFY(!missing);
    QVERIFY(missing.error().code == core::ErrorCode::notFound);
    QTemporaryDir folder;
    QVERIFY(!readTraceCsvFile(folder.path().toStdString()));
}

void TestTraceCsv::readsFiles() {
    QTemporaryDir folder;
    QFile file(folder.filePath("a.csv"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(kPlain.c_str());
    file.close();
    const auto rows = readTraceCsvFile(file.fileName().toStdString());
    QVERIFY(rows.has_value());
    QCOMPARE(rows->rows.size(), std::size_t{2});
}

QTEST_APPLESS_MAIN(TestTraceCsv)
#include "test_trace_csv.moc"
