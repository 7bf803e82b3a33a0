// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_columns.h"
#include "scoring/trace_csv.h"

#include "core/random.h"

#include <QtTest>
#include <array>
#include <vector>

using namespace chiron;
using namespace chiron::scoring;

namespace {

const std::string kPlain = "t_s,x_mm,y_mm,z_mm\n0,1,2,3\n0.001,1.5,2,3\n";

void add(const char* tag, const std::string& text, const char* place, const char* mentions) {
    QTest::newRow(tag) << QByteArray::fromStdString(text) << QByteArray(place) << QByteArray(mentions);
}

const std::string kHeader = "t_s,x_mm,y_mm,z_mm";

void addHeaderCases() {
    add("empty", "", "1:1", "empty file");
    add("only BOM", "\xef\xbb\xbf", "1:1", "empty file");
    add("only newline", "\n", "1:1", "\"\"");
    add("only header", kHeader + "\n", "1:1", "no rows");
    add("header without newline", kHeader, "1:1", "no rows");
    add("header and empty lines", kHeader + "\n\n\n", "2:1", "");
    add("no header", "0,1,2,3\n1,1,2,3\n", "1:1", "\"0\"");
    add("unknown column", kHeader + ",speed\n0,1,2,3,4\n", "1:5", "\"speed\"");
    add("misspelt column", "t_s,x_mm,y_mm,Z_mm\n0,1,2,3\n", "1:4", "\"Z_mm\"");
    add("wrong unit", "t_ms,x_mm,y_mm,z_mm\n0,1,2,3\n", "1:1", "\"t_ms\"");
    add("space in header", "t_s, x_mm,y_mm,z_mm\n0,1,2,3\n", "1:2", "\" x_mm\"");
    add("duplicate column", kHeader + ",x_mm\n0,1,2,3,4\n", "1:5", "once");
    add("no time", "x_mm,y_mm,z_mm\n1,2,3\n", "1:1", "t_s");
    add("no z", "t_s,x_mm,y_mm\n0,1,2\n", "1:1", "z_mm");
    add("half an orientation", kHeader + ",qw,qx\n0,1,2,3,1,0\n", "1:1", "qy");
    add("half a force", kHeader + ",fx_N\n0,1,2,3,1\n", "1:1", "fy_N");
    add("half a target", kHeader + ",target_x_mm\n0,1,2,3,1\n", "1:1", "target_y_mm");
    add("half a mark", kHeader + ",marked\n0,1,2,3,1\n", "1:1", "timed_out");
    add("trailing comma in header", kHeader + ",\n0,1,2,3\n", "1:5", "\"\"");
    add("semicolons", "t_s;x_mm;y_mm;z_mm\n0;1;2;3\n", "1:1", "t_s;x_mm");
    add("tabs", "t_s\tx_mm\ty_mm\tz_mm\n0\t1\t2\t3\n", "1:1", "\\x09");
    add("old Mac line ends", "t_s,x_mm,y_mm,z_mm\r0,1,2,3\r", "1:4", "z_mm\\x0d0");
    add("UTF-16", std::string("\xff\xfet\0_\0s\0", 8), "1:1", "\\xff\\xfe");
    add("NUL in header", std::string("t_s\0,x_mm", 9), "1:1", "\\x00");
    add("quoted header", "\"t_s\",x_mm,y_mm,z_mm\n0,1,2,3\n", "1:1", "t_s");
}

void addRowCases() {
    const auto row = [](const char* tag, const std::string& cells, const char* place, const char* mentions) {
        add(tag, kHeader + "\n0,0,0,0\n" + cells + "\n", place, mentions);
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
    row("second header", kHeader, "3:1", "t_s");
    row("terminal escape", "1,\x1b[31m,2,3", "3:2", "\\x1b");
    row("UTF-8 digits", "1,\xd9\xa1,2,3", "3:2", "\\xd9");
    row("minus sign of typographers",
        "1,\xe2\x88\x92"
        "1,2,3",
        "3:2", "\\xe2");
}

void addColumnCases() {
    const auto extra = [](const char* tag, const std::string& names, const std::string& values,
                          const char* place, const char* mentions) {
        add(tag, kHeader + "," + names + "\n0,0,0,0," + values + "\n", place, mentions);
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

} // namespace

class TestMalformedTraceCsv : public QObject {
    Q_OBJECT
private slots:
    void malformed_data();
    void malformed();
    void columnsOfTwoExercises_data();
    void columnsOfTwoExercises();
    void hugeLines();
    void binaryJunkNeverCrashes();
    void truncationsNeverCrash();
};

void TestMalformedTraceCsv::malformed_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("place"); // line:column
    QTest::addColumn<QByteArray>("mentions");
    addHeaderCases();
    addRowCases();
    addColumnCases();
}

void TestMalformedTraceCsv::malformed() {
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

/// Two exercises of this test have columns of their own, and the second needs a shared one beside them.
void TestMalformedTraceCsv::columnsOfTwoExercises_data() {
    QTest::addColumn<QByteArray>("header");
    QTest::addColumn<QByteArray>("problem"); // empty: the file is read
    const auto row = [](const char* tag, const char* columns, const char* problem) {
        QTest::newRow(tag) << QByteArray::fromStdString(kHeader + columns) << QByteArray(problem);
    };
    row("of none", "", "");
    row("of the first", ",needle_N,needle_mm", "");
    row("of the second", ",heat_N,completed,failed,unfinished", "");
    row("of both", ",needle_N,needle_mm,heat_N,completed,failed,unfinished",
        "heat_N: expected only columns of one exercise: the file already has those of a needle");
    row("of both, the other way round", ",heat_N,completed,failed,unfinished,needle_mm,needle_N",
        "heat_N: expected only columns of one exercise: the file already has those of a needle");
    row("one of each", ",needle_mm,heat_N",
        "heat_N: expected only columns of one exercise: the file already has those of a needle");
    row("half of the first", ",needle_mm",
        "no column \"needle_N\": expected all columns of its group or none of them");
    row("the second without what it needs", ",heat_N",
        "no column \"completed\": expected it beside those of a burn");
}

void TestMalformedTraceCsv::columnsOfTwoExercises() {
    static constexpr std::array<OwnColumn, 2> kNeedleColumns{
        OwnColumn{"needle_N", ColumnKind::force, 0.0, 9.0, "newtons, 0 to 9", "z_mm"},
        OwnColumn{"needle_mm", ColumnKind::length, 0.0, 9.0, "millimetres, 0 to 9", "z_mm"}};
    static constexpr std::array<OwnColumn, 1> kHeatColumns{
        OwnColumn{"heat_N", ColumnKind::force, 0.0, 9.0, "newtons, 0 to 9", "z_mm"}};
    static constexpr OwnColumns kNeedle{"a needle", kNeedleColumns};
    static constexpr OwnColumns kHeat{"a burn", kHeatColumns, &TraceColumns::completed};
    std::vector<TraceColumn> known;
    for (const TraceColumn& column : traceColumns())
        if (column.owner == nullptr)
            known.push_back(column);
    for (const OwnColumns* owner : {&kNeedle, &kHeat})
        for (std::size_t place = 0; place < owner->columns.size(); ++place) {
            const OwnColumn& own = owner->columns[place];
            TraceColumn column{own.name, own.kind, nullptr, own.least, own.most, own.expected};
            column.owner = owner;
            column.place = place;
            known.push_back(column);
        }
    QFETCH(QByteArray, header);
    QFETCH(QByteArray, problem);
    QByteArray text = header + '\n';
    for (int row = 0; row < 2; ++row)
        text +=
            QByteArray::number(row) + QByteArray(",0").repeated(static_cast<int>(header.count(','))) + '\n';
    const auto rows = readTraceCsv(text.toStdString(), "two.csv", known);
    const QByteArray told = rows ? QByteArray() : QByteArray::fromStdString(rows.error().message);
    QCOMPARE(told, problem.isEmpty() ? problem : "two.csv:1:1: " + problem);
    if (!rows)
        return;
    const OwnColumns* owner = header.contains("needle") ? &kNeedle
                              : header.contains("heat") ? &kHeat
                                                        : nullptr;
    QVERIFY(rows->columns.own == owner);
    for (const TraceRow& row : rows->rows)
        QCOMPARE(row.own.size(), owner ? owner->columns.size() : 0);
}

void TestMalformedTraceCsv::hugeLines() {
    std::string names = "t_s";
    for (int i = 0; i < 1000000; ++i)
        names += ",x_mm";
    const auto header = readTraceCsv(names + "\n0\n", "wide.csv");
    QVERIFY(!header && header.error().message.size() < 1000);
    const auto commas =
        readTraceCsv(std::string("t_s,x_mm,y_mm,z_mm\n0,1,2,3") + std::string(1000000, ',') + "\n", "w.csv");
    QVERIFY(!commas && commas.error().message.starts_with("w.csv:2:5: ") &&
            commas.error().message.size() < 1000);
    const auto digits =
        readTraceCsv("t_s,x_mm,y_mm,z_mm\n0," + std::string(1000000, '9') + ",2,3\n", "d.csv");
    QVERIFY(!digits && digits.error().message.starts_with("d.csv:2:2: ") &&
            digits.error().message.size() < 1000);
}

void TestMalformedTraceCsv::binaryJunkNeverCrashes() {
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

void TestMalformedTraceCsv::truncationsNeverCrash() {
    for (std::size_t n = 0; n < kPlain.size(); ++n) {
        const auto rows = readTraceCsv(std::string_view(kPlain).substr(0, n), "cut.csv");
        QVERIFY(rows.has_value() || rows.error().message.starts_with("cut.csv:"));
    }
}

QTEST_APPLESS_MAIN(TestMalformedTraceCsv)
#include "test_malformed_trace_csv.moc"
