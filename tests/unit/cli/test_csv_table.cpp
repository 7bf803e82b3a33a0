// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/csv_table.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace chiron;

namespace {
using Rows = std::vector<QStringList>;

cli::CsvTable parsed(const QString& text) {
    auto table = cli::parseCsvTable(text, QStringLiteral("t.csv"));
    if (!table)
        qFatal("%s", table.error().message.c_str());
    return *table;
}
} // namespace

// What people hand in: cells in quotes, other separators, notes, and where it is wrong.
class TestCsvTable : public QObject {
    Q_OBJECT
private slots:
    void quotesHoldSeparatorsQuotesAndLines();
    void separatorIsTheHeadings();
    void notesAndEmptyLinesSayNothing();
    void linesAreThoseOfTheFile();
    void numbers();
    void refusesWithThePlace_data();
    void refusesWithThePlace();
};

void TestCsvTable::quotesHoldSeparatorsQuotesAndLines() {
    const auto table =
        parsed(QStringLiteral("\"name, first\",says\n\"Ada, B.\",\"a \"\"quoted\"\" "
                              "word\"\nUma,\"two\r\nlines; one cell\"\nTim,\"\"\n\"\"\"\",x\n"));
    QCOMPARE(table.header, (QStringList{"name, first", "says"}));
    QVERIFY(
        (table.rows ==
         Rows{{"Ada, B.", "a \"quoted\" word"}, {"Uma", "two\nlines; one cell"}, {"Tim", ""}, {"\"", "x"}}));
    QCOMPARE(table.cell(1, table.column("says")), QStringLiteral("two\nlines; one cell"));
    QCOMPARE(table.column("name"), -1);
    // Half a cell in quotes is one cell still.
    QVERIFY((parsed("a,b\nx\"1,2\"y,3\n").rows == Rows{{"x1,2y", "3"}}));
}

void TestCsvTable::separatorIsTheHeadings() {
    QVERIFY((parsed("a;b\n1,5;2\n").rows == Rows{{"1,5", "2"}}));
    QVERIFY((parsed("a\tb\n1;5\t2\n").rows == Rows{{"1;5", "2"}}));
    QVERIFY((parsed("a;b,c\n1;5,2\n").rows == Rows{{"1;5", "2"}})); // a comma goes first
    QVERIFY((parsed("a\n 1 \n").rows == Rows{{"1"}}));
    QCOMPARE(parsed(QString(QChar(0xFEFF)) + "a,b\n1,2\n").header, (QStringList{"a", "b"}));
}

void TestCsvTable::notesAndEmptyLinesSayNothing() {
    const auto table = parsed("# a note with one \" in it\na,b\n\n1,2\n,\n#,\n# 3,4\n5,6\r\n");
    QVERIFY((table.rows == Rows{{"1", "2"}, {"5", "6"}}));
    QVERIFY((table.lines == std::vector<int>{4, 8}));
    QCOMPARE(table.headerLine, 2);
}

void TestCsvTable::linesAreThoseOfTheFile() {
    const auto table = parsed("a,b\n\"1\n1\n1\",2\n3,x\n");
    QVERIFY((table.lines == std::vector<int>{2, 5}));
    QCOMPARE(table.fault(1, 1, QStringLiteral("a number")).value().message,
             std::string("t.csv:5: column b: \"x\": expected a number"));
}

void TestCsvTable::numbers() {
    const auto table = parsed("a\n-1.5e-3\nn/a\nNA\nnan\n-Inf\n+infinity\n");
    QCOMPARE(*table.number(0, 0), -1.5e-3);
    for (const std::size_t row : {std::size_t{1}, std::size_t{2}, std::size_t{3}})
        QVERIFY(std::isnan(*table.number(row, 0)));
    QCOMPARE(*table.number(4, 0), -std::numeric_limits<double>::infinity());
    QCOMPARE(*table.number(5, 0), std::numeric_limits<double>::infinity());
    const auto wrong = parsed("a;b\n1,5;0x4\n");
    QVERIFY(!wrong.number(0, 0) && !wrong.number(0, 1));
    QVERIFY(wrong.number(0, 0).error().message.find("t.csv:2: column a: \"1,5\"") == 0);
}

void TestCsvTable::refusesWithThePlace_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    QTest::newRow("nothing") << ""
                             << "t.csv:1: empty";
    QTest::newRow("notes alone") << "# a\n# b\n"
                                 << "t.csv:1: empty";
    QTest::newRow("no rows") << "a,b\n"
                             << "t.csv:2: no rows";
    QTest::newRow("short row") << "a,b\n1,2\n3\n"
                               << "t.csv:3: 1 cells; expected 2";
    QTest::newRow("long row") << "a,b\n1,2,3\n"
                              << "t.csv:2: 3 cells; expected 2";
    QTest::newRow("separator that no quote holds") << "a,b\n\"1\",2,\"3\"\n"
                                                   << "t.csv:2: 3 cells; expected 2";
    QTest::newRow("heading twice") << "a,b,a\n1,2,3\n"
                                   << "t.csv:1: heading \"a\"";
    QTest::newRow("heading without a name") << "a,,b\n1,2,3\n"
                                            << "t.csv:1: heading \"\"";
    QTest::newRow("quote that is never closed") << "a,b\n1,\"2\n3,4\n"
                                                << "t.csv:2: a quote is not closed";
    QTest::newRow("cut off within a quote") << "a,b\n1,2\n3,\"4"
                                            << "t.csv:3: a quote is not closed";
}

void TestCsvTable::refusesWithThePlace() {
    QFETCH(QString, text);
    QFETCH(QString, message);
    const auto table = cli::parseCsvTable(text, QStringLiteral("t.csv"));
    QVERIFY(!table);
    QVERIFY2(table.error().message.find(message.toStdString()) == 0, table.error().message.c_str());
    QCOMPARE(table.error().code, core::ErrorCode::badInput);
}

QTEST_GUILESS_MAIN(TestCsvTable)
#include "test_csv_table.moc"
