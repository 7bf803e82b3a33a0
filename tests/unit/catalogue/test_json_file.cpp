// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/canonical_json.h"
#include "catalogue/json_file.h"
#include "catalogue/schema.h"

#include <QJsonArray>
#include <QtTest>
#include <cmath>

using namespace chiron::catalogue;

namespace {

QByteArray messageOf(const QByteArray& text) {
    const auto file = JsonFile::parse(text, QStringLiteral("f.json"));
    return file ? QByteArray() : QByteArray::fromStdString(file.error().message);
}

} // namespace

class TestJsonFile : public QObject {
    Q_OBJECT
private slots:
    void refuses_data();
    void refuses();
    void acceptsByteOrderMark();
    void placesProblems();
    void manyProblemsAreCut();
    void canonicalForm_data();
    void canonicalForm();
    void canonicalNumbersReadBackAlike();
    void sha256MatchesPublishedVector();
    void suggestsTheNearestKey();
};

void TestJsonFile::refuses_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("start");
    QTest::newRow("empty") << QByteArray() << QByteArray("f.json:1:1: $: ");
    QTest::newRow("array") << QByteArray("[1]") << QByteArray("f.json:1:1: $: an array");
    QTest::newRow("no comma") << QByteArray("{\"a\": 1\n \"b\": 2}") << QByteArray("f.json:2:");
    QTest::newRow("twice") << QByteArray("{\"a\": 1,\n  \"a\": 2}")
                           << QByteArray("f.json:2:8: $.a: given twice");
    QTest::newRow("twice, escaped") << QByteArray("{\"a\": 1, \"\\u0061\": 2}")
                                    << QByteArray("f.json:1:20: $.a: given twice");
    QTest::newRow("twice, inside") << QByteArray("{\"l\": [{}, {\"x\": 1, \"x\": 1}]}")
                                   << QByteArray("f.json:1:26: $.l[1].x: given twice");
    QTest::newRow("deep") << QByteArray("{\"a\": ") + QByteArray(40, '[') + QByteArray(40, ']') + '}'
                          << QByteArray("f.json:1:22: $.a[0]");
    QTest::newRow("very deep") << QByteArray("{\"a\": ") + QByteArray(200000, '[') << QByteArray("f.json:1:");
    QTest::newRow("Latin-1") << QByteArray("{\"a\": \"\xe4\"}")
                             << QByteArray("f.json:1:8: $: byte 0xe4: expected UTF-8");
    QTest::newRow("cut UTF-8") << QByteArray("{\"a\": \"\xc3")
                               << QByteArray("f.json:1:8: $: byte 0xc3: expected UTF-8");
    QTest::newRow("UTF-16") << QByteArray("\xff\xfe{\0}\0", 6) << QByteArray("f.json:1:1: $: byte 0xff");
    QTest::newRow("NaN") << QByteArray("{\"a\": NaN}") << QByteArray("f.json:1:");
    QTest::newRow("no digit before the point")
        << QByteArray("{\"a\": .5}") << QByteArray("f.json:1:7: $.a: .5");
    QTest::newRow("no digit after the point")
        << QByteArray("{\"a\": 1.}") << QByteArray("f.json:1:7: $.a: 1.");
    QTest::newRow("leading zero") << QByteArray("{\"a\": [01]}") << QByteArray("f.json:1:");
    QTest::newRow("plus sign") << QByteArray("{\"a\": +1}") << QByteArray("f.json:1:");
    QTest::newRow("unknown escape") << QByteArray("{\"a\": \"\\q\"}")
                                    << QByteArray("f.json:1:7: $.a: an unknown escape");
    QTest::newRow("comment") << QByteArray("{} // no") << QByteArray("f.json:1:");
    QTest::newRow("too long") << QByteArray((1 << 20) + 1, ' ')
                              << QByteArray("f.json:1:1: $: longer than 1 MiB");
}

void TestJsonFile::refuses() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, start);
    const QByteArray message = messageOf(text);
    QVERIFY2(message.startsWith(start), message.left(200).constData());
    QVERIFY(message.contains(": expected "));
}

void TestJsonFile::acceptsByteOrderMark() {
    QVERIFY(JsonFile::parse("\xef\xbb\xbf{\"a\": 1}", QStringLiteral("f.json")).has_value());
}

void TestJsonFile::placesProblems() {
    const auto file = JsonFile::parse("{\n  \"a\": {\"odd key\": [10, 20]}\n}", QStringLiteral("f.json"));
    QVERIFY(file.has_value());
    const QString path = elementPath(memberPath(memberPath("$", "a"), "odd key"), 1);
    QCOMPARE(path, QStringLiteral("$.a[\"odd key\"][1]"));
    const auto error = file->error({{path, "20", "less"}, {"$.a.gone", "missing", "it"}});
    QCOMPARE(QString::fromStdString(error.message),
             QStringLiteral("f.json:2:25: $.a[\"odd key\"][1]: 20: expected less\n"
                            "f.json:2:8: $.a.gone: missing: expected it"));
}

void TestJsonFile::manyProblemsAreCut() {
    const auto file = JsonFile::parse("{}", QStringLiteral("f.json"));
    const auto error = file->error(Problems(50, {"$", "x", "y"}));
    QCOMPARE(QString::fromStdString(error.message).count(u'\n'), 20);
    QVERIFY(error.message.ends_with("and 30 more"));
}

void TestJsonFile::canonicalForm_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("canonical");
    QTest::newRow("sorted, no spaces")
        << QByteArray("{ \"b\" : [ 1 , true , null ] , \"B\":{}, \"a\" : \"x\" }")
        << QByteArray("{\"B\":{},\"a\":\"x\",\"b\":[1,true,null]}");
    QTest::newRow("numbers") << QByteArray("{\"n\":[1.0,1e2,0.1000,-0.0,1E-7,123456789012345680000]}")
                             << QByteArray("{\"n\":[1,100,0.1,0,1e-07,123456789012345683968]}");
    QTest::newRow("texts") << QByteArray("{\"t\":\"\\u00e4\\/\\\"\\\\\\n\\u0001\"}")
                           << QByteArray("{\"t\":\"\xc3\xa4/\\\"\\\\\\u000a\\u0001\"}");
}

void TestJsonFile::canonicalForm() {
    QFETCH(QByteArray, text);
    QFETCH(QByteArray, canonical);
    const auto file = JsonFile::parse(text, QStringLiteral("f.json"));
    QVERIFY(file.has_value());
    QCOMPARE(QByteArray::fromStdString(canonicalJson(file->root())), canonical);
    QCOMPARE(QByteArray::fromStdString(canonicalJson(JsonFile::parse(canonical, "g.json")->root())),
             canonical);
}

void TestJsonFile::canonicalNumbersReadBackAlike() {
    for (const double x : {0.1, 1.0 / 3.0, 1e300, 5e-324, 0.02, 123456.789, -2.5e-9}) {
        const auto file =
            JsonFile::parse(QByteArray::fromStdString(canonicalJson(QJsonObject{{"x", x}})), "f.json");
        QCOMPARE(file->root()["x"].toDouble(), x);
    }
}

// FIPS 180-2, appendix B.1.
void TestJsonFile::sha256MatchesPublishedVector() {
    QCOMPARE(sha256Hex("abc"),
             std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
}

void TestJsonFile::suggestsTheNearestKey() {
    const std::vector<QString> known{"radius_mm", "trials", "friction_low"};
    QVERIFY(didYouMean("raduis_mm", known).contains("\"radius_mm\""));
    QVERIFY(didYouMean("friction_lo", known).contains("\"friction_low\""));
    QVERIFY(didYouMean("something_else", known).isEmpty());
    QVERIFY(didYouMean(QString(100000, u'x'), known).isEmpty());
}

QTEST_APPLESS_MAIN(TestJsonFile)
#include "test_json_file.moc"
