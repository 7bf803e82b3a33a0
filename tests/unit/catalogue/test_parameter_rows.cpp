// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the parameters of every exercise, of objects, meshes and tissues, and the schemas that are
// stored of them, and how a row reads and describes each type of parameter.
#include "catalogue/exercise_contents.h"
#include "catalogue/parameter_rows.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QSet>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace chiron;
using namespace chiron::catalogue;

namespace {

const QString kSchemaFolder = QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content/schema");

QString nameOf(const ExerciseContent& content) {
    return QString::fromUtf8(content.parametersSchema.data(),
                             static_cast<qsizetype>(content.parametersSchema.size()));
}

/// "line 7: "minimum": 0, where the rows give "minimum": 1"; empty where the texts are the same.
QString firstDifference(const QString& stored, const QString& made) {
    const QStringList old = stored.split(u'\n'), now = made.split(u'\n');
    for (qsizetype i = 0; i < std::max(old.size(), now.size()); ++i)
        if (old.value(i) != now.value(i) || (i < old.size()) != (i < now.size()))
            return QStringLiteral("line %1: %2, where the rows give %3")
                .arg(i + 1)
                .arg(old.value(i).trimmed(), now.value(i).trimmed());
    return {};
}

enum class Colour { red, green };

struct Place {
    double at_m = 0.25;
    int rank = 2;
    double height_m = 0.5;
    double width_m = 3.0;
};

struct Inner {
    bool on = true;
};

/// One member of each type.
struct Sample {
    double length_m = 0.0877;
    double most_N = std::numeric_limits<double>::infinity();
    int count = 3;
    std::uint64_t seed = 9;
    Inner inner;
    Colour colour = Colour::green;
    std::string id = "one";
    int named = 0;
    std::vector<Place> places{{}};
    double cosine = 1.0; ///< content has the angle
    double pressure_Pa = 2500.0;
    std::vector<std::int32_t> numbers;
};

int readNamed(const ObjectReader& json) {
    return json.integer("number");
}

const std::vector<ParameterRow<Place>>& placeRows() {
    using Row = ParameterRow<Place>;
    static const std::vector<Row> kRows{
        Row::number("at_mm", units::kMm, {0, 500}, &Place::at_m, "Where."),
        Row::whole("rank", {1, 9}, &Place::rank, "Which."),
        Row::number("height_mm", units::kMm, {0, 900}, &Place::height_m, "How high.").optional(),
        Row::number("width_mm", units::kMm, {0, 9000}, &Place::width_m, "How wide.")
            .withoutDefault()
            .optional()};
    return kRows;
}

const std::vector<ParameterRow<Sample>>& sampleRows() {
    using Row = ParameterRow<Sample>;
    static const std::vector<Row> kRows{
        Row::number("length_mm", units::kMm, {0.5, 100}, &Sample::length_m, "Long."),
        Row::limit("most_N", units::kN, 30, &Sample::most_N, "At most; 0: no limit."),
        Row::whole("count", {1, 8}, &Sample::count, "Many.", "ticks").withDefault(4),
        Row::whole<std::uint64_t>("seed", {1, 99}, &Sample::seed, "Drawn."),
        Row::flag("on", within(&Sample::inner, &Inner::on), "Yes."),
        Row::choice<Colour>("colour", {{"red", Colour::red}, {"green", Colour::green}}, &Sample::colour,
                            "Bright."),
        Row::identifier("id", &Sample::id, "Which."),
        Row::reference("named", kNamedMesh, readNamed, "dome", &Sample::named, "Of \"content\"."),
        Row::list("places", {0, 4}, placeRows(), "One.", "a key of a place", &Sample::places, "All."),
        Row::name("of", "Not kept."),
        Row::derived(
            "turn_deg", units::kDeg, {0, 180},
            [](Sample& sample, double turn_rad) { sample.cosine = std::cos(turn_rad); },
            [](Sample& sample) { return std::acos(sample.cosine); }, "Turned."),
        Row::number("pressure_kPa", units::kKPa, {0, 9}, &Sample::pressure_Pa, "Pressed."),
        Row::wholes<std::int32_t>("numbers", {0, 9}, {-5, 5}, &Sample::numbers, "One of them.", "Counted.",
                                  "µm")
            .withoutDefault()};
    return kRows;
}

struct Read {
    Sample sample;
    QStringList problems;
};

Read read(const char* json) {
    Read out;
    Problems problems;
    readParameters(sampleRows(),
                   ObjectReader(QJsonDocument::fromJson(json).object(), QStringLiteral("$"), problems),
                   QStringLiteral("a parameter of the sample"), out.sample);
    for (const Problem& problem : problems)
        out.problems << problem.path + QStringLiteral(": ") + problem.found + QStringLiteral(": expected ") +
                            problem.expected;
    return out;
}

} // namespace

class TestParameterRows : public QObject {
    Q_OBJECT
private slots:
    void schemasAreMadeOfTheRows_data();
    void schemasAreMadeOfTheRows();
    void everySchemaOfParametersHasRows();
    void everySchemaOfNamedContentHasRows();
    void aRowFillsItsMember();
    void whatIsNotGivenStays();
    void aRowRefusesWhatItCannotRead_data();
    void aRowRefusesWhatItCannotRead();
    void defaultsAreReadAsTheMembers();
    void theFileHasTheOrderOfTheRows();
    void everyItemMayHaveALine();
};

void TestParameterRows::schemasAreMadeOfTheRows_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("made");
    for (const ExerciseContent& content : exerciseContents())
        if (content.schema)
            QTest::addRow("%s", qPrintable(nameOf(content))) << nameOf(content) << content.schema();
    for (const NamedKind& kind : kNamedKinds)
        QTest::newRow(kind.contentSchema) << QString::fromLatin1(kind.contentSchema) << kind.schema();
}

/// The schemas of parameters are written from the rows: CHIRON_STORE_SCHEMA=1 with this test, after a row was
/// changed.
void TestParameterRows::schemasAreMadeOfTheRows() {
    QFETCH(QString, name);
    QFETCH(QByteArray, made);
    QFile file(kSchemaFolder + u'/' + name + QStringLiteral(".json"));
    const bool stores = qEnvironmentVariableIsSet("CHIRON_STORE_SCHEMA");
    QVERIFY2(file.open(stores ? QIODevice::WriteOnly : QIODevice::ReadOnly), qPrintable(file.errorString()));
    if (stores) {
        QCOMPARE(file.write(made), made.size());
        return;
    }
    const QString difference = firstDifference(QString::fromUtf8(file.readAll()), QString::fromUtf8(made));
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

void TestParameterRows::everySchemaOfParametersHasRows() {
    QSet<QString> made;
    for (const ExerciseContent& content : exerciseContents())
        if (content.schema)
            made.insert(nameOf(content) + QStringLiteral(".json"));
    QVERIFY(!made.isEmpty());
    const QStringList stored = QDir(kSchemaFolder).entryList({QStringLiteral("*_parameters.json")});
    QCOMPARE(QSet<QString>(stored.begin(), stored.end()), made);
}

/// What a file of objects, meshes or tissues refers to for its numbers is made of rows.
void TestParameterRows::everySchemaOfNamedContentHasRows() {
    QCOMPARE(kNamedKinds.size(), std::size_t{3});
    for (const NamedKind& kind : kNamedKinds) {
        QFile file(kSchemaFolder + u'/' + QLatin1String(kind.key) + QStringLiteral(".json"));
        QVERIFY2(file.open(QIODevice::ReadOnly), kind.key);
        const QJsonObject member = QJsonDocument::fromJson(file.readAll())
                                       .object()[QStringLiteral("properties")]
                                       .toObject()[QLatin1String(kind.member)]
                                       .toObject();
        QCOMPARE(member[QStringLiteral("description")].toString(),
                 QStringLiteral("Its keys are in %1.json.").arg(QLatin1String(kind.contentSchema)));
        // a row names the item whose numbers were taken
        QVERIFY2(QJsonDocument::fromJson(kind.schema())
                     .object()[QStringLiteral("properties")]
                     .toObject()
                     .contains(QLatin1String(kind.key)),
                 kind.key);
    }
}

void TestParameterRows::aRowFillsItsMember() {
    const Read all = read(R"({"length_mm": 12.3, "most_N": 7, "count": 5, "seed": 77, "on": false,
                              "colour": "red", "id": "two", "named": {"number": 6},
                              "places": [{"at_mm": 7, "rank": 1}, {"at_mm": 8, "rank": 3, "height_mm": 9}],
                              "of": "another", "turn_deg": 90, "pressure_kPa": 0.3,
                              "numbers": [1, -2147483648, 3]})");
    QCOMPARE(all.problems, QStringList());
    QVERIFY(all.sample.length_m == 12.3 / 1000.0); // to the bit
    QVERIFY(all.sample.most_N == 7.0);
    QCOMPARE(all.sample.count, 5);
    QCOMPARE(all.sample.seed, std::uint64_t{77});
    QVERIFY(!all.sample.inner.on);
    QVERIFY(all.sample.colour == Colour::red);
    QCOMPARE(all.sample.id, std::string("two"));
    QCOMPARE(all.sample.named, 6);
    QCOMPARE(all.sample.places.size(), std::size_t{2});
    QVERIFY(all.sample.places[1].at_m == 8 / 1000.0 && all.sample.places[1].rank == 3);
    QVERIFY(all.sample.places[0].height_m == Place{}.height_m && all.sample.places[1].height_m == 9 / 1000.0);
    QVERIFY(all.sample.cosine == std::cos(90.0 / units::kDeg.perSi));
    QVERIFY(all.sample.pressure_Pa == 0.3 * 1000.0); // to the bit
    QCOMPARE(all.sample.numbers, (std::vector<std::int32_t>{1, std::numeric_limits<std::int32_t>::min(), 3}));
    QVERIFY(std::isinf(read(R"({"most_N": 0})").sample.most_N));     // no limit
    QCOMPARE(read(R"({"seed": -7})").sample.seed, std::uint64_t{0}); // has no negative values
}

void TestParameterRows::whatIsNotGivenStays() {
    const Read none = read("{}");
    QCOMPARE(none.problems, QStringList());
    QCOMPARE(none.sample.count, 3); // the struct's, not the default with which a level begins
    QVERIFY(none.sample.length_m == Sample{}.length_m && std::isinf(none.sample.most_N));
    QCOMPARE(none.sample.places.size(), std::size_t{1});
}

void TestParameterRows::aRowRefusesWhatItCannotRead_data() {
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("problem");
    const auto row = [](const char* tag, const char* json, const char* problem) {
        QTest::newRow(tag) << QByteArray(json) << QString::fromUtf8(problem);
    };
    row("another type", R"({"length_mm": "12"})", "$.length_mm: another type: expected a number");
    row("no whole number", R"({"count": 1.5})", "$.count: 1.5: expected a whole number");
    row("another word", R"({"colour": "blue"})", R"($.colour: "blue": expected "red" or "green")");
    row("unknown key", R"({"lenght_mm": 12})",
        R"($.lenght_mm: unknown key: expected a parameter of the sample; did you mean "length_mm"?)");
    row("key of an item", R"({"places": [{"at_mm": 1, "rank": 1, "rang": 1}]})",
        R"($.places[0].rang: unknown key: expected a key of a place; did you mean "rank"?)");
    row("item without a key", R"({"places": [{"at_mm": 1}]})",
        "$.places[0].rank: missing: expected a number");
    row("optional key of an item", R"({"places": [{"at_mm": 1, "rank": 1, "height_mm": true}]})",
        "$.places[0].height_mm: another type: expected a number");
    row("no list of numbers", R"({"numbers": 3})",
        "$.numbers: another type: expected an array of whole numbers");
    row("half a number in a list", R"({"numbers": [1, 0.5, 0.25]})",
        "$.numbers[1]: no whole number: expected a whole number");
    row("a text in a list of numbers", R"({"numbers": ["1"]})",
        "$.numbers[0]: no whole number: expected a whole number");
    row("more than the type holds", R"({"numbers": [2147483648]})",
        "$.numbers[0]: no whole number: expected a whole number");
    row("a text for an angle", R"({"turn_deg": "90"})", "$.turn_deg: another type: expected a number");
}

void TestParameterRows::aRowRefusesWhatItCannotRead() {
    QFETCH(QByteArray, json);
    QFETCH(QString, problem);
    QCOMPARE(read(json.constData()).problems, QStringList(problem));
}

/// Every number of an SI unit has a number of content from which it is read to the bit.
void TestParameterRows::defaultsAreReadAsTheMembers() {
    QCOMPARE(contentNumber(0.0877, units::kMm), 87.7);
    QCOMPARE(contentNumber(22.0e-3 / 6.0, ContentUnit{"", 6000.0}), 22.0);
    QCOMPARE(contentNumber(17e3, units::kKPa), 17.0);
    for (const ContentUnit unit :
         {units::kMm, units::kUm, units::kDeg, units::kMilliNm, units::kN, units::kKPa})
        for (int i = -1000; i <= 1000; ++i) {
            const double given = i / 8.0;
            QVERIFY(unit.toSi(contentNumber(unit.toSi(given), unit)) == unit.toSi(given));
        }
}

void TestParameterRows::theFileHasTheOrderOfTheRows() {
    const QString expected = QString::fromUtf8(R"({
    "$schema": "https://json-schema.org/draft/2020-12/schema",
    "title": "Sample",
    "description": "Of a test.",
    "type": "object",
    "properties": {
        "length_mm": {
            "type": "number",
            "unit": "mm",
            "minimum": 0.5,
            "maximum": 100,
            "default": 87.7,
            "description": "Long."
        },
        "most_N": {
            "type": "number",
            "unit": "N",
            "minimum": 0,
            "maximum": 30,
            "default": 0,
            "description": "At most; 0: no limit."
        },
        "count": {
            "type": "integer",
            "unit": "ticks",
            "minimum": 1,
            "maximum": 8,
            "default": 4,
            "description": "Many."
        },
        "seed": {
            "type": "integer",
            "unit": "1",
            "minimum": 1,
            "maximum": 99,
            "default": 9,
            "description": "Drawn."
        },
        "on": {
            "type": "boolean",
            "default": true,
            "description": "Yes."
        },
        "colour": {
            "type": "string",
            "enum": ["red", "green"],
            "default": "green",
            "description": "Bright."
        },
        "id": {
            "type": "string",
            "format": "identifier",
            "minLength": 1,
            "maxLength": 40,
            "default": "one",
            "description": "Which."
        },
        "named": {
            "$ref": "mesh_source.json",
            "default": {"mesh": "dome"},
            "description": "Of \"content\"."
        },
        "places": {
            "type": "array",
            "minItems": 0,
            "maxItems": 4,
            "default": [{"at_mm": 250, "rank": 2, "height_mm": 500, "width_mm": 3000}],
            "description": "All.",
            "items": {
                "type": "object",
                "description": "One.",
                "properties": {
                    "at_mm": {
                        "type": "number",
                        "unit": "mm",
                        "minimum": 0,
                        "maximum": 500,
                        "description": "Where."
                    },
                    "rank": {
                        "type": "integer",
                        "unit": "1",
                        "minimum": 1,
                        "maximum": 9,
                        "description": "Which."
                    },
                    "height_mm": {
                        "type": "number",
                        "unit": "mm",
                        "minimum": 0,
                        "maximum": 900,
                        "default": 500,
                        "description": "How high."
                    },
                    "width_mm": {
                        "type": "number",
                        "unit": "mm",
                        "minimum": 0,
                        "maximum": 9000,
                        "description": "How wide."
                    }
                },
                "required": ["at_mm", "rank"]
            }
        },
        "of": {
            "type": "string",
            "format": "identifier",
            "minLength": 1,
            "maxLength": 40,
            "description": "Not kept."
        },
        "turn_deg": {
            "type": "number",
            "unit": "deg",
            "minimum": 0,
            "maximum": 180,
            "default": 0,
            "description": "Turned."
        },
        "pressure_kPa": {
            "type": "number",
            "unit": "kPa",
            "minimum": 0,
            "maximum": 9,
            "default": 2.5,
            "description": "Pressed."
        },
        "numbers": {
            "type": "array",
            "minItems": 0,
            "maxItems": 9,
            "description": "Counted.",
            "items": {
                "type": "integer",
                "unit": "µm",
                "minimum": -5,
                "maximum": 5,
                "description": "One of them."
            }
        }
    }
}
)");
    QCOMPARE(QString::fromUtf8(parametersSchema({"Sample", "Of a test."}, sampleRows())), expected);
}

void TestParameterRows::everyItemMayHaveALine() {
    JsonNode inner;
    inner.add("a", JsonNode::number(1e8));
    inner.add("b", JsonNode::list());
    JsonNode node;
    node.add("list", JsonNode::list({JsonNode::yesNo(true), inner}).brief());
    QCOMPARE(node.written(JsonLayout::briefOnOneLine),
             QStringLiteral("{\n    \"list\": [true, {\"a\": 100000000, \"b\": []}]\n}"));
    QCOMPARE(node.written(JsonLayout::itemPerLine),
             QStringLiteral("{\n    \"list\": [\n        true,\n        {\n            \"a\": 100000000,\n"
                            "            \"b\": []\n        }\n    ]\n}"));
}

QTEST_APPLESS_MAIN(TestParameterRows)
#include "test_parameter_rows.moc"
