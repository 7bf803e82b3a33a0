// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"

#include "core/random.h"

#include <QTemporaryDir>
#include <QtTest>
#include <bit>
#include <clocale>

using namespace chiron;
using namespace chiron::scoring;

namespace {

const std::string kPlain = "t_s,x_mm,y_mm,z_mm\n0,1,2,3\n0.001,1.5,2,3\n";

/// A file with three good rows of the columns given, for damaging.
std::string withCell(const std::string& header, const std::string& row) {
    return header + "\n" + row + "\n";
}

} // namespace

class TestTraceCsv : public QObject {
    Q_OBJECT
private slots:
    void plainFile();
    void everyColumn();
    void acceptsByteOrderMarkCrlfAndTrailingLines_data();
    void acceptsByteOrderMarkCrlfAndTrailingLines();
    void ignoresLocale();
    void malformed_data();
    void malformed();
    void hugeLines();
    void binaryJunkNeverCrashes();
    void truncationsNeverCrash();
    void writesExactDecimals();
    void roundTripKeepsBits();
    void marksFromButtons();
    void marksFromButtonsEndSphereApexOnly();
    void trialsAndPhases();
    void changingTargetIsRefused();
    void noRunningRowIsRefused();
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
             std::string("t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz,jaw_deg,buttons,tool,fx_N,fy_N,fz_N,commanded_fx_N,"
                         "commanded_fy_N,commanded_fz_N,measured_fx_N,measured_fy_N,measured_fz_N,trial,phase,paused,"
                         "marked,timed_out,mark_in_contact,mark_x_mm,mark_y_mm,mark_z_mm,target_x_mm,target_y_mm,"
                         "target_radius_mm,force_limit_N\n"));
    const std::string row = "0.5,1,2,3,0,1,0,0,90,5,2,0.1,0.2,0.3,1.1,1.2,1.3,2.1,2.2,2.3,4,between,1,1,0,1,7,8,9,"
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

void TestTraceCsv::malformed_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("place"); // line:column
    QTest::addColumn<QByteArray>("mentions");
    const std::string plain = "t_s,x_mm,y_mm,z_mm";
    const auto add = [](const char* tag, const std::string& text, const char* place, const char* mentions) {
        QTest::newRow(tag) << QByteArray::fromStdString(text) << QByteArray(place) << QByteArray(mentions);
    };
    add("empty", "", "1:1", "empty file");
    add("only BOM", "\xef\xbb\xbf", "1:1", "empty file");
    add("only newline", "\n", "1:1", "\"\"");
    add("only header", plain + "\n", "1:1", "no rows");
    add("header without newline", plain, "1:1", "no rows");
    add("header and empty lines", plain + "\n\n\n", "2:1", "");
    add("no header", "0,1,2,3\n1,1,2,3\n", "1:1", "\"0\"");
    add("unknown column", plain + ",speed\n0,1,2,3,4\n", "1:5", "\"speed\"");
    add("misspelt column", "t_s,x_mm,y_mm,Z_mm\n0,1,2,3\n", "1:4", "\"Z_mm\"");
    add("wrong unit", "t_ms,x_mm,y_mm,z_mm\n0,1,2,3\n", "1:1", "\"t_ms\"");
    add("space in header", "t_s, x_mm,y_mm,z_mm\n0,1,2,3\n", "1:2", "\" x_mm\"");
    add("duplicate column", plain + ",x_mm\n0,1,2,3,4\n", "1:5", "once");
    add("no time", "x_mm,y_mm,z_mm\n1,2,3\n", "1:1", "t_s");
    add("no z", "t_s,x_mm,y_mm\n0,1,2\n", "1:1", "z_mm");
    add("half an orientation", plain + ",qw,qx\n0,1,2,3,1,0\n", "1:1", "qy");
    add("half a force", plain + ",fx_N\n0,1,2,3,1\n", "1:1", "fy_N");
    add("half a target", plain + ",target_x_mm\n0,1,2,3,1\n", "1:1", "target_y_mm");
    add("half a mark", plain + ",marked\n0,1,2,3,1\n", "1:1", "timed_out");
    add("trailing comma in header", plain + ",\n0,1,2,3\n", "1:5", "\"\"");
    add("semicolons", "t_s;x_mm;y_mm;z_mm\n0;1;2;3\n", "1:1", "t_s;x_mm");
    add("tabs", "t_s\tx_mm\ty_mm\tz_mm\n0\t1\t2\t3\n", "1:1", "\\x09");
    add("old Mac line ends", "t_s,x_mm,y_mm,z_mm\r0,1,2,3\r", "1:4", "z_mm\\x0d0");
    add("UTF-16", std::string("\xff\xfet\0_\0s\0", 8), "1:1", "\\xff\\xfe");
    add("NUL in header", std::string("t_s\0,x_mm", 9), "1:1", "\\x00");
    add("quoted header", "\"t_s\",x_mm,y_mm,z_mm\n0,1,2,3\n", "1:1", "t_s");
    const auto row = [&](const char* tag, const std::string& cells, const char* place, const char* mentions) {
        add(tag, plain + "\n0,0,0,0\n" + cells + "\n", place, mentions);
    };
    row("word", "1,left,2,3", "3:2", "\"left\"");
    row("empty cell", "1,,2,3", "3:2", "\"\"");
    row("space before", "1, 1,2,3", "3:2", "\" 1\"");
    row("space after", "1,1 ,2,3", "3:2", "\"1 \"");
    row("unit in cell", "1,1mm,2,3", "3:2", "\"1mm\"");
    row("decimal comma", "1,1,5,2,3", "3:5", "4 values");
    row("thousands", "1,1.000.000,2,3", "3:2", "1.000.000");
    row("plus sign", "1,+1,2,3", "3:2", "+1");
    row("hexadecimal", "1,0x10,2,3", "3:2", "0x10");
    row("nan", "1,nan,2,3", "3:2", "nan");
    row("inf", "1,1,inf,3", "3:3", "inf");
    row("minus infinity", "1,1,2,-infinity", "3:4", "-infinity");
    row("overflow", "1,1e999,2,3", "3:2", "1e999");
    row("underflow is no number", "1,1e-999,2,3", "3:2", "1e-999");
    row("too far", "1,1000001,2,3", "3:2", "-1e6 to 1e6");
    row("time too late", "1e8,1,2,3", "3:1", "seconds");
    row("nan time", "nan,1,2,3", "3:1", "nan");
    row("same time", "0,1,2,3", "3:1", "later");
    row("same microsecond", "0.0000004,1,2,3", "3:1", "later");
    row("time back", "-1,1,2,3", "3:1", "later");
    row("too few values", "1,1,2", "3:4", "4 values");
    row("too many values", "1,1,2,3,4", "3:5", "4 values");
    row("trailing comma", "1,1,2,3,", "3:5", "4 values");
    row("empty line inside", "\n1,1,2,3", "3:1", "empty line");
    row("NUL in cell", std::string("1,\0,2,3", 7), "3:2", "\\x00");
    row("quoted", "1,\"1\",2,3", "3:2", "1");
    row("comment", "# note", "3:1", "# note");
    row("second header", plain, "3:1", "t_s");
    row("terminal escape", "1,\x1b[31m,2,3", "3:2", "\\x1b");
    row("UTF-8 digits", "1,\xd9\xa1,2,3", "3:2", "\\xd9");
    row("minus sign of typographers", "1,\xe2\x88\x92" "1,2,3", "3:2", "\\xe2");
    const auto extra = [&](const char* tag, const std::string& names, const std::string& values, const char* place,
                           const char* mentions) {
        add(tag, withCell(plain + "," + names, "0,0,0,0," + values), place, mentions);
    };
    extra("zero quaternion", "qw,qx,qy,qz", "0,0,0,0", "2:5", "quaternion");
    extra("long quaternion", "qw,qx,qy,qz", "1,0.1,0,0", "2:5", "quaternion");
    extra("quaternion part out of range", "qw,qx,qy,qz", "2,0,0,0", "2:5", "-1.01 to 1.01");
    extra("jaw out of range", "jaw_deg", "361", "2:5", "degrees");
    extra("negative buttons", "buttons", "-1", "2:5", "whole number");
    extra("half a button", "buttons", "0.5", "2:5", "whole number");
    extra("too many buttons", "buttons", "4294967296", "2:5", "4294967295");
    extra("fifth tool", "tool", "4", "2:5", "0 to 3");
    extra("negative tool", "tool", "-1", "2:5", "0 to 3");
    extra("trial zero", "trial", "0", "2:5", "1 to 65536");
    extra("trial too high", "trial", "65537", "2:5", "1 to 65536");
    extra("phase as number", "phase", "2", "2:5", "running");
    extra("phase misspelt", "phase", "Running", "2:5", "running");
    extra("paused yes", "paused", "yes", "2:5", "0 or 1");
    extra("paused two", "paused", "2", "2:5", "0 or 1");
    extra("force nan", "fx_N,fy_N,fz_N", "0,nan,0", "2:6", "newtons");
    extra("target radius zero", "target_x_mm,target_y_mm,target_radius_mm", "0,0,0", "2:7", "1e-6");
    extra("limit zero", "force_limit_N", "0", "2:5", "0.001");
}

void TestTraceCsv::malformed() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, place);
    QFETCH(QByteArray, mentions);
    const auto rows = readTraceCsv(text.toStdString(), "bad.csv");
    QVERIFY(!rows.has_value());
    const QByteArray message = QByteArray::fromStdString(rows.error().message);
    QVERIFY2(message.startsWith("bad.csv:" + place + ": "), message.constData());
    QVERIFY2(message.contains(mentions), message.constData());
    QVERIFY2(message.contains(": expected "), message.constData());
    QVERIFY(rows.error().code == core::ErrorCode::badInput);
    for (const char c : message)
        QVERIFY(static_cast<unsigned char>(c) >= 0x20);
}

void TestTraceCsv::hugeLines() {
    std::string names = "t_s";
    for (int i = 0; i < 1000000; ++i)
        names += ",x_mm";
    const auto header = readTraceCsv(names + "\n0\n", "wide.csv");
    QVERIFY(!header && header.error().message.size() < 1000);
    const auto commas = readTraceCsv(std::string("t_s,x_mm,y_mm,z_mm\n0,1,2,3") + std::string(1000000, ',') + "\n", "w.csv");
    QVERIFY(!commas && commas.error().message.starts_with("w.csv:2:5: ") && commas.error().message.size() < 1000);
    const auto digits = readTraceCsv("t_s,x_mm,y_mm,z_mm\n0," + std::string(1000000, '9') + ",2,3\n", "d.csv");
    QVERIFY(!digits && digits.error().message.starts_with("d.csv:2:2: ") && digits.error().message.size() < 1000);
}

void TestTraceCsv::binaryJunkNeverCrashes() {
    core::Random random(77);
    for (int i = 0; i < 2000; ++i) {
        std::string junk = i % 2 == 0 ? kPlain : std::string();
        const auto length = random.below(200);
        for (std::uint64_t k = 0; k < length; ++k)
            junk.insert(junk.begin() + static_cast<std::ptrdiff_t>(random.below(junk.size() + 1)),
                        static_cast<char>(random.below(256)));
        const auto rows = readTraceCsv(junk, "junk.csv");
        if (!rows)
            QVERIFY(rows.error().message.starts_with("junk.csv:"));
    }
}

void TestTraceCsv::truncationsNeverCrash() {
    for (std::size_t n = 0; n < kPlain.size(); ++n) {
        const auto rows = readTraceCsv(std::string_view(kPlain).substr(0, n), "cut.csv");
        QVERIFY(rows.has_value() || rows.error().message.starts_with("cut.csv:"));
    }
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
        row.q_WT = core::Quat(random.normal(), random.normal(), random.normal(), random.normal()).normalized();
        rows.rows.push_back(row);
    }
    const auto again = readTraceCsv(writeTraceCsv(rows), "round.csv");
    QVERIFY2(again.has_value(), again ? "" : again.error().message.c_str());
    QCOMPARE(again->rows.size(), rows.rows.size());
    const auto same = [](double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b + 0.0); };
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        QVERIFY(same(again->rows[i].t_s, rows.rows[i].t_s));
        for (int axis = 0; axis < 3; ++axis) {
            QVERIFY(same(again->rows[i].p_WT_m[axis], rows.rows[i].p_WT_m[axis]));
            QVERIFY(same(again->rows[i].tissue_N[axis], rows.rows[i].tissue_N[axis]));
        }
        QVERIFY(again->rows[i].q_WT.coeffs() == rows.rows[i].q_WT.coeffs());
    }
}

void TestTraceCsv::marksFromButtons() {
    const std::string text = "t_s,x_mm,y_mm,z_mm,buttons,fx_N,fy_N,fz_N\n"
                             "0,0,0,0,1,0,0,0\n" // held from before: no mark
                             "1,1,0,0,0,0,0,0\n"
                             "2,2,0,0,2,0,0,0\n" // another button
                             "3,3,0,0,3,0,0,0.5\n"
                             "4,4,0,0,1,0,0,0\n";
    const auto trace = buildSessionTrace(*readTraceCsv(text, "m.csv"), "sphere_apex");
    QVERIFY(trace.has_value());
    const TrialTrace& trial = trace->trials.at(0);
    QVERIFY(trial.marked && trial.markInContact);
    QCOMPARE(trial.p_WMark_m.x(), 0.003);
    QCOMPARE(trial.tools.at(0).t_s.size(), std::size_t{4}); // up to and with the mark
    QVERIFY(!trial.apex.has_value());
}

void TestTraceCsv::marksFromButtonsEndSphereApexOnly() {
    const std::string text = "t_s,x_mm,y_mm,z_mm,buttons\n0,0,0,0,0\n1,1,0,0,1\n2,2,0,0,0\n";
    const auto rows = readTraceCsv(text, "m.csv");
    QCOMPARE(buildSessionTrace(*rows, "palpation")->trials[0].tools[0].t_s.size(), std::size_t{3});
    QCOMPARE(buildSessionTrace(*rows, "sphere_apex")->trials[0].tools[0].t_s.size(), std::size_t{2});
    const auto unmarked = buildSessionTrace(*readTraceCsv(kPlain, "p.csv"), "sphere_apex");
    QVERIFY(!unmarked->trials[0].marked && !unmarked->trials[0].timedOut);
    QCOMPARE(unmarked->trials[0].p_WMark_m.x(), 0.0015);
    QVERIFY(unmarked->trials[0].markInContact); // no forces in the file: not judged
}

void TestTraceCsv::trialsAndPhases() {
    const std::string text = "t_s,x_mm,y_mm,z_mm,tool,trial,phase\n"
                             "0,0,0,0,0,1,ready\n"
                             "1,1,0,0,0,1,running\n"
                             "1,5,0,0,1,1,running\n"
                             "2,2,0,0,0,1,between\n"
                             "3,3,0,0,0,2,running\n"
                             "4,4,0,0,0,2,finished\n";
    const auto trace = buildSessionTrace(*readTraceCsv(text, "t.csv"), "sphere_apex");
    QVERIFY(trace.has_value());
    QCOMPARE(trace->trials.size(), std::size_t{2});
    QCOMPARE(trace->trials[0].tools.size(), std::size_t{2});
    QCOMPARE(trace->trials[0].tools[0].t_s.size(), std::size_t{1});
    QCOMPARE(trace->trials[0].tools[1].p_WT_m[0].x(), 0.005);
    QCOMPARE(trace->trials[1].trial, 1);
}

void TestTraceCsv::changingTargetIsRefused() {
    const std::string text = "t_s,x_mm,y_mm,z_mm,target_x_mm,target_y_mm,target_radius_mm\n"
                             "0,0,0,0,1,2,20\n1,0,0,0,1,2.5,20\n";
    const auto trace = buildSessionTrace(*readTraceCsv(text, "t.csv"), "sphere_apex");
    QVERIFY(!trace && trace.error().message.find("trial 1") != std::string::npos);
}

void TestTraceCsv::noRunningRowIsRefused() {
    const auto trace = buildSessionTrace(*readTraceCsv("t_s,x_mm,y_mm,z_mm,phase\n0,0,0,0,idle\n", "i.csv"), "sphere_apex");
    QVERIFY(!trace && trace.error().message.starts_with("i.csv"));
    QVERIFY(!buildSessionTrace(TraceRows{}, "sphere_apex"));
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
