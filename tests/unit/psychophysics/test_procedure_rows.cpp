// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of every kind of procedure: its words, default and range, and that the reader and the schema keep
// to it.
#include "catalogue/procedure_reader.h"
#include "catalogue/procedure_schema.h"
#include "catalogue/schema.h"
#include "psychophysics/measures/run_warnings.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <type_traits>

using namespace chiron;
using namespace chiron::catalogue;
using namespace chiron::psychophysics;

namespace {

const QString kSchemaFolder = QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content/schema");

QString text(std::string_view of) {
    return QString::fromUtf8(of.data(), static_cast<qsizetype>(of.size()));
}

/// "pest.stop.trials", for messages.
QString nameOf(const ProcedureKind& kind, const Parameter& row) {
    return text(kind.id()) + '.' + (row.object.empty() ? QString() : text(row.object) + '.') + text(row.key);
}

core::Result<ProcedureSpec> read(const QJsonObject& json) {
    static const auto schema = readSchema(kSchemaFolder, "procedure");
    return readProcedure(QJsonDocument(json).toJson(), "procedure.json", *schema);
}

/// A task that answers in the way the kind needs, on the scale that it needs.
Condition conditionFor(const ProcedureKind& kind, ProcedureScale scale) {
    Condition condition;
    condition.task = kind.drives(Task::twoAfc) ? Task::twoAfc : Task::rank3;
    condition.scale = kind.onlyScale().value_or(scale);
    condition.stimulus.differences = {0.01, 0.02, 0.05, 0.1, 0.2};
    return condition;
}

std::vector<ProcedureSpec> begunWith(const ProcedureKind& kind) {
    return {kind.usual(conditionFor(kind, ProcedureScale::difference)),
            kind.usual(conditionFor(kind, ProcedureScale::logDifference))};
}

/// Whether the default is an empty list that must not stay empty: there is no default, and a file must have
/// the key.
bool mustBeGiven(const ProcedureKind& kind, const Parameter& row) {
    return std::visit(
        [&row](const auto& value) {
            if constexpr (requires { value.front(); } &&
                          !std::is_same_v<std::decay_t<decltype(value)>, std::string>)
                return value.empty() && row.fewest > 0;
            else
                return false;
        },
        row.get(kind.defaults()));
}

/// The shortest file of a kind that reads: what has a default is left out, so that a fault can lie only in
/// what a test adds.
QJsonObject shortestJson(const ProcedureKind& kind) {
    const QJsonObject whole = writeProcedure(begunWith(kind).back());
    QJsonObject json{{"kind", text(kind.id())}};
    for (const Parameter& row : kind.rows())
        if (mustBeGiven(kind, row) && whole.contains(text(row.key)))
            json.insert(text(row.key), whole.value(text(row.key)));
    return json;
}

/// The same with another value of one row.
QJsonObject with(QJsonObject json, const Parameter& row, const QJsonValue& value) {
    if (row.object.empty()) {
        json.insert(text(row.key), value);
        return json;
    }
    QJsonObject object{{"trials", 10}}; // rules that are given replace the default ones
    object.insert(text(row.key), value);
    json.insert(text(row.object), object);
    return json;
}

double below(const Parameter& row) {
    return row.minimum - std::max(1.0, std::floor(std::abs(row.minimum) / 2.0));
}
double above(const Parameter& row) {
    return row.maximum + std::max(1.0, std::floor(std::abs(row.maximum) / 2.0));
}

/// Values of one row that lie outside of its range, by the type of the row.
struct OutsideOf {
    const Parameter& row;
    QJsonValue begun; ///< what the kind begins with

    QJsonArray numbers() const { return {below(row), above(row)}; }
    QJsonArray operator()(double) const { return numbers(); }
    QJsonArray operator()(int) const { return numbers(); }
    QJsonArray operator()(std::uint64_t) const { return numbers(); }
    QJsonArray operator()(const std::optional<double>&) const { return numbers(); }
    QJsonArray operator()(bool) const { return {}; }
    QJsonArray operator()(const std::string&) const { return {QStringLiteral("no_such_word")}; }
    QJsonArray operator()(const std::vector<double>&) const {
        constexpr int kMostTried = 1000; // longer lists take long to refuse
        QJsonArray outside;
        for (const QJsonValue& number : numbers())
            outside.append(QJsonArray{number});
        if (row.fewest > 0)
            outside.append(QJsonArray());
        if (row.most <= kMostTried) {
            QJsonArray tooMany;
            for (int i = 0; i <= row.most; ++i)
                tooMany.append(std::max(row.minimum, 1e-5 * (i + 1))); // each of them allowed
            outside.append(tooMany);
        }
        return outside;
    }
    QJsonArray operator()(const StimulusGrids&) const { return grids(); }
    QJsonArray operator()(const std::vector<ParameterGrid>&) const { return grids(); }
    QJsonArray operator()(const OutcomeProbabilities&) const { return {QJsonValue(QJsonArray())}; }

private:
    /// The first grid with one value that lies outside; and no grid at all.
    QJsonArray grids() const {
        QJsonArray outside;
        for (const QJsonValue& number : numbers()) {
            QJsonArray changed = begun.toArray();
            QJsonObject first = changed.at(0).toObject();
            first.insert(QStringLiteral("values"), QJsonArray{number});
            changed.replace(0, first);
            outside.append(changed);
        }
        outside.append(QJsonArray());
        return outside;
    }
};

/// What the schema must say of one row: its type, the words it may be, and where its numbers stand.
struct SchemaOf {
    const char* type;
    QStringList toNumber{}; ///< keys that lead to the node that has unit and range
    const char* numberType = "number";
    bool isList = false;
};

struct SchemaOfValue {
    SchemaOf operator()(double) const { return {"number"}; }
    SchemaOf operator()(const std::optional<double>&) const { return {"number"}; }
    SchemaOf operator()(int) const { return {"integer", {}, "integer"}; }
    SchemaOf operator()(std::uint64_t) const { return {"integer", {}, "integer"}; }
    SchemaOf operator()(bool) const { return {"boolean", {}, nullptr}; }
    SchemaOf operator()(const std::string&) const { return {"string", {}, nullptr}; }
    SchemaOf operator()(const std::vector<double>&) const { return {"array", {"items"}, "number", true}; }
    SchemaOf operator()(const StimulusGrids&) const { return ofGrids(); }
    SchemaOf operator()(const std::vector<ParameterGrid>&) const { return ofGrids(); }
    SchemaOf operator()(const OutcomeProbabilities&) const {
        return {"array", {"items", "items", "items"}, "number", true};
    }

private:
    static SchemaOf ofGrids() {
        return {"array", {"items", "properties", "values", "items"}, "number", true};
    }
};

QJsonObject committedSchema() {
    QFile file(kSchemaFolder + "/procedure.json");
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

QJsonObject propertiesFor(const QJsonObject& schema, const Parameter& row) {
    const QJsonObject properties = schema.value("properties").toObject();
    return row.object.empty() ? properties
                              : properties.value(text(row.object)).toObject().value("properties").toObject();
}

QStringList textsOf(const QJsonValue& list) {
    return list.toVariant().toStringList();
}

/// Where a node of the schema and a row differ; empty: nowhere.
QString differenceOf(const QJsonObject& node, const Parameter& row, const SchemaOf& expected) {
    if (node.value("type").toString() != QLatin1String(expected.type))
        return QStringLiteral("type: expected ") + expected.type;
    if (expected.isList && (node.value("minItems").toDouble(-1.0) != row.fewest ||
                            node.value("maxItems").toDouble(-1.0) != row.most))
        return QStringLiteral("items: expected %1 to %2").arg(row.fewest).arg(row.most);
    QStringList words;
    for (const ParameterWord& word : row.words)
        words.append(text(word.word));
    if (textsOf(node.value("enum")) != words)
        return QStringLiteral("enum: expected the words of the row, in its order");
    if (!expected.numberType)
        return {};
    QJsonObject number = node;
    for (const QString& key : expected.toNumber)
        number = number.value(key).toObject();
    if (number.value("type").toString() != QLatin1String(expected.numberType))
        return QStringLiteral("type of its numbers: expected ") + expected.numberType;
    if (number.value("unit").toString() != text(row.unit))
        return QStringLiteral("unit: expected ") + text(row.unit);
    for (const auto& [key, limit] : {std::pair("minimum", row.minimum), std::pair("maximum", row.maximum)})
        if (!number.value(QLatin1String(key)).isDouble() ||
            number.value(QLatin1String(key)).toDouble() != limit)
            return QStringLiteral("%1: expected %2").arg(QLatin1String(key)).arg(limit);
    return {};
}

} // namespace

class TestProcedureRows : public QObject {
    Q_OBJECT
private slots:
    void keysAreUnique();
    void wordsAreThere();
    void defaultsLieInTheirRange();
    void whatAKindBeginsWithIsWhole();
    void whatAKindBeginsWithSurvivesJson();
    void theUsualValueIsWhatAKindBeginsWith();
    void storedRunsLeadBackToTheKind();
    void anotherTableKeepsTheCounts();
    void rangesAreKept();
    void unknownKeysAreRefused();
    void valuesOutsideAreRefused();
    void theSchemaAgreesWithTheRows();
    void theSchemaIsMadeOfTheRows();
    void theSchemaHasNoOtherKeys();
};

void TestProcedureRows::keysAreUnique() {
    QSet<QString> kinds;
    for (const ProcedureKind* kind : procedureKinds()) {
        QVERIFY2(!kinds.contains(text(kind->id())), qPrintable(text(kind->id())));
        kinds.insert(text(kind->id()));
        QSet<QString> keys{"kind"};
        for (const Parameter& row : kind->rows()) {
            const QString key = text(row.object) + '.' + text(row.key);
            QVERIFY2(!row.key.empty() && !keys.contains(key), qPrintable(nameOf(*kind, row)));
            QVERIFY2(row.object.empty() || row.object == "stop",
                     qPrintable(nameOf(*kind, row))); // the reader knows no other object
            keys.insert(key);
        }
    }
}

void TestProcedureRows::wordsAreThere() {
    for (const ProcedureKind* kind : procedureKinds()) {
        QVERIFY2(!kind->words().title.empty() && !kind->words().meaning.empty(),
                 qPrintable(text(kind->id())));
        for (const Parameter& row : kind->rows()) {
            const QString name = nameOf(*kind, row);
            const ParameterValue value = row.get(kind->defaults());
            QVERIFY2(!row.description.empty() && !row.unit.empty(), qPrintable(name));
            const bool ofGrids = std::holds_alternative<std::vector<ParameterGrid>>(
                value); // a field for each parameter, by its own name
            QVERIFY2(ofGrids || row.title.empty() == row.meaning.empty(), qPrintable(name));
            QVERIFY2(row.words.empty() != std::holds_alternative<std::string>(value), qPrintable(name));
            QSet<QString> words;
            for (const ParameterWord& word : row.words) {
                QVERIFY2(!word.word.empty() && !words.contains(text(word.word)), qPrintable(name));
                words.insert(text(word.word));
            }
        }
    }
}

void TestProcedureRows::defaultsLieInTheirRange() {
    for (const ProcedureKind* kind : procedureKinds())
        for (const Parameter& row : kind->rows()) {
            QVERIFY2(row.minimum < row.maximum && row.fewest <= row.most, qPrintable(nameOf(*kind, row)));
            if (mustBeGiven(*kind, row))
                continue;
            const std::string fault = rangeFault(row, row.get(kind->defaults()));
            QVERIFY2(fault.empty(), qPrintable(text(kind->id()) + ": " + QString::fromStdString(fault)));
        }
}

void TestProcedureRows::whatAKindBeginsWithIsWhole() {
    for (const ProcedureKind* kind : procedureKinds())
        for (const ProcedureSpec& spec : begunWith(*kind)) {
            QCOMPARE(&kindFor(spec), kind);
            for (const Parameter& row : kind->rows()) {
                const std::string fault = rangeFault(row, row.get(spec));
                QVERIFY2(fault.empty(), qPrintable(text(kind->id()) + ": " + QString::fromStdString(fault)));
            }
            const auto made = makeProcedure(spec, 1);
            QVERIFY2(made, made ? "" : made.error().message.c_str());
        }
}

void TestProcedureRows::whatAKindBeginsWithSurvivesJson() {
    for (const ProcedureKind* kind : procedureKinds())
        for (const ProcedureSpec& spec : begunWith(*kind)) {
            const QJsonObject json = writeProcedure(spec);
            const auto again = read(json);
            QVERIFY2(again, again ? "" : again.error().message.c_str());
            QCOMPARE(&kindFor(*again), kind);
            QCOMPARE(QJsonDocument(writeProcedure(*again)).toJson(), QJsonDocument(json).toJson());
        }
}

/// A field never says "usually 20" beside another number that nobody chose.
void TestProcedureRows::theUsualValueIsWhatAKindBeginsWith() {
    int stated = 0;
    for (const ProcedureKind* kind : procedureKinds())
        for (const ProcedureSpec& spec : begunWith(*kind))
            for (const Parameter& row : kind->rows()) {
                if (!row.usual || !row.usual->value)
                    continue;
                const ParameterValue value = row.get(spec);
                const double stored = std::holds_alternative<int>(value)
                                          ? static_cast<double>(std::get<int>(value))
                                          : std::get<double>(value);
                const double shown = row.quantity == Quantity::share ? 100.0 * stored : stored;
                QVERIFY2(std::abs(shown - *row.usual->value) < 1e-9, qPrintable(nameOf(*kind, row)));
                ++stated;
            }
    QVERIFY(stated > 0);
    for (const ProcedureKind* kind : procedureKinds()) // how few trials are few stands where they are typed
        for (const Parameter& row : kind->rows())
            if (row.key == "trials" && row.object == "stop")
                QVERIFY2(text(row.meaning).contains(QString::number(kFewTrials)),
                         qPrintable(nameOf(*kind, row)));
}

/// Whether two numbers, optional numbers or lists of numbers are equal; other values are not compared.
bool sameNumbers(const ParameterValue& a, const ParameterValue& b) {
    return std::visit(
        [&b](const auto& of) {
            using Type = std::decay_t<decltype(of)>;
            if constexpr (std::is_arithmetic_v<Type> || std::is_same_v<Type, std::optional<double>> ||
                          std::is_same_v<Type, std::vector<double>>)
                return of == std::get<Type>(b);
            else
                return true;
        },
        a);
}

/// Whoever changes the table of differences, or takes another kind, keeps the trials that they asked for;
/// levels follow the table.
void TestProcedureRows::anotherTableKeepsTheCounts() {
    for (const ProcedureKind* kind : procedureKinds()) {
        const Condition before = conditionFor(*kind, ProcedureScale::difference);
        Condition after = before;
        for (double& difference : after.stimulus.differences)
            difference *= 2.0;
        ProcedureSpec asked = kind->usual(before);
        int counts = 0;
        for (const Parameter& row : kind->rows())
            if (row.get(asked).index() == ParameterValue(1).index() && row.minimum <= 7.0 &&
                row.maximum >= 7.0) {
                row.set(asked, ParameterValue(7));
                ++counts;
            }
        const ProcedureSpec kept = usualProcedureKeeping(std::string(kind->id()), after, asked);
        const ProcedureSpec fresh = kind->usual(after);
        for (const Parameter& row : kind->rows()) {
            const bool count = row.get(asked).index() == ParameterValue(1).index();
            if (count && row.minimum <= 7.0 && row.maximum >= 7.0)
                QVERIFY2(sameNumbers(row.get(kept), ParameterValue(7)), qPrintable(nameOf(*kind, row)));
            else if (row.quantity == Quantity::level || row.quantity == Quantity::spread)
                QVERIFY2(sameNumbers(row.get(kept), row.get(fresh)), qPrintable(nameOf(*kind, row)));
        }
        QVERIFY2(counts > 0, qPrintable(text(kind->id())));
    }
    StaircaseSpec staircase;
    staircase.stop.trials = 12;
    Condition condition = conditionFor(StaircaseSpec::kind(), ProcedureScale::difference);
    const ProcedureSpec other = usualProcedureKeeping("quest_plus", condition, staircase);
    QCOMPARE(std::get<QuestPlusSpec>(other).stop.trials, 12);
    ConstantSpec constant{{0.05, 0.1}, 40, true}; // presentations of a level: another thing in another kind
    condition.task = Task::rank3;
    const ProcedureSpec descending = usualProcedureKeeping("descending", condition, constant);
    QCOMPARE(std::get<DescendingSpec>(descending).repeats,
             std::get<DescendingSpec>(usualProcedure("descending", condition)).repeats);
}

/// A run stores the id of its procedure with a version; screens and reports find the kind's words by it.
void TestProcedureRows::storedRunsLeadBackToTheKind() {
    for (const ProcedureKind* kind : procedureKinds())
        for (const ProcedureSpec& spec : begunWith(*kind)) {
            const auto made = makeProcedure(spec, 1);
            QVERIFY2(made, qPrintable(text(kind->id())));
            QVERIFY2(findProcedureKind((*made)->id()) == kind, qPrintable(text((*made)->id())));
        }
}

void TestProcedureRows::rangesAreKept() {
    Parameter row{
        .key = "size", .minimum = 0.5, .maximum = 2.0, .fewest = 1, .most = 2, .words = {{"one"}, {"two"}}};
    QCOMPARE(rangeFault(row, 0.5), std::string());
    QCOMPARE(rangeFault(row, 2), std::string());
    QCOMPARE(rangeFault(row, std::optional<double>()), std::string());
    QCOMPARE(rangeFault(row, std::vector<double>{0.5, 2.0}), std::string());
    QCOMPARE(rangeFault(row, std::string("two")), std::string());
    QCOMPARE(rangeFault(row, 0.25), std::string("size: 0.25: expected 0.5 to 2"));
    QCOMPARE(rangeFault(row, std::nan("")), std::string("size: nan: expected 0.5 to 2"));
    QCOMPARE(rangeFault(row, 3), std::string("size: 3: expected 0.5 to 2"));
    QCOMPARE(rangeFault(row, std::uint64_t(3)), std::string("size: 3: expected 0.5 to 2"));
    QCOMPARE(rangeFault(row, std::optional<double>(3.0)), std::string("size: 3: expected 0.5 to 2"));
    QCOMPARE(rangeFault(row, std::vector<double>{1.0, 3.0}), std::string("size[1]: 3: expected 0.5 to 2"));
    QCOMPARE(rangeFault(row, std::vector<double>()), std::string("size: 0 numbers: expected 1 to 2"));
    QCOMPARE(rangeFault(row, std::vector<double>{1.0, 1.0, 1.0}),
             std::string("size: 3 numbers: expected 1 to 2"));
    QCOMPARE(rangeFault(row, std::string("three")), std::string("size: \"three\": expected another word"));
}

void TestProcedureRows::unknownKeysAreRefused() {
    for (const ProcedureKind* kind : procedureKinds()) {
        const QJsonObject shortest = shortestJson(*kind);
        const auto whole = read(shortest);
        QVERIFY2(whole, whole ? "" : whole.error().message.c_str());
        std::vector<std::pair<QString, QJsonObject>> wrong;
        QJsonObject json = shortest;
        json.insert("no_such_key", 1);
        wrong.emplace_back("$.no_such_key: unknown key", json);
        const auto& rows = kind->rows();
        if (std::any_of(rows.begin(), rows.end(),
                        [](const Parameter& row) { return row.object == "stop"; })) {
            json = shortest;
            json.insert("stop", QJsonObject{{"trials", 10}, {"no_such_rule", 1}});
            wrong.emplace_back("$.stop.no_such_rule: unknown key", json);
        }
        for (const auto& [said, faulty] : wrong) {
            const auto spec = read(faulty);
            QVERIFY2(!spec, qPrintable(text(kind->id()) + ": " + said));
            QVERIFY2(QString::fromStdString(spec.error().message).contains(said),
                     spec.error().message.c_str());
        }
    }
}

void TestProcedureRows::valuesOutsideAreRefused() {
    for (const ProcedureKind* kind : procedureKinds()) {
        const QJsonObject shortest = shortestJson(*kind);
        for (const Parameter& row : kind->rows()) {
            const QJsonArray outside =
                std::visit(OutsideOf{row, shortest.value(text(row.key))}, row.get(kind->defaults()));
            for (const QJsonValue& value : outside) {
                const QByteArray json = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
                const QString what = nameOf(*kind, row) + ' ' + QString::fromUtf8(json.left(100));
                const auto spec = read(with(shortest, row, value));
                QVERIFY2(!spec, qPrintable(what + ": was taken"));
                QCOMPARE(spec.error().code, core::ErrorCode::badInput);
                const QRegularExpression key("\\b" + text(row.key) +
                                             "\\b"); // "step" is not named by "smallest_step"
                const QString said = QString::fromStdString(spec.error().message);
                QVERIFY2(said.contains(key), qPrintable(what + ": " + said));
            }
        }
    }
}

void TestProcedureRows::theSchemaAgreesWithTheRows() {
    const QJsonObject schema = committedSchema();
    QStringList ids;
    for (const ProcedureKind* kind : procedureKinds()) {
        ids.append(text(kind->id()));
        for (const Parameter& row : kind->rows()) {
            const QJsonValue node = propertiesFor(schema, row).value(text(row.key));
            QVERIFY2(node.isObject(), qPrintable(nameOf(*kind, row) + ": the schema lacks it"));
            const QString difference =
                differenceOf(node.toObject(), row, std::visit(SchemaOfValue(), row.get(kind->defaults())));
            QVERIFY2(difference.isEmpty(), qPrintable(nameOf(*kind, row) + ": " + difference));
        }
    }
    QCOMPARE(textsOf(schema.value("properties").toObject().value("kind").toObject().value("enum")), ids);
}

/// content/schema/procedure.json is written from the rows: CHIRON_STORE_SCHEMA=1 with this test, after a row
/// was changed.
void TestProcedureRows::theSchemaIsMadeOfTheRows() {
    QFile file(kSchemaFolder + QStringLiteral("/procedure.json"));
    const bool stores = qEnvironmentVariableIsSet("CHIRON_STORE_SCHEMA");
    QVERIFY2(file.open(stores ? QIODevice::WriteOnly : QIODevice::ReadOnly), qPrintable(file.errorString()));
    if (stores)
        QCOMPARE(file.write(procedureSchema()), procedureSchema().size());
    else
        QCOMPARE(QString::fromUtf8(file.readAll()), QString::fromUtf8(procedureSchema()));
}

void TestProcedureRows::theSchemaHasNoOtherKeys() {
    QSet<QString> known{"kind"};
    for (const ProcedureKind* kind : procedureKinds())
        for (const Parameter& row : kind->rows()) {
            known.insert(row.object.empty() ? text(row.key) : text(row.object));
            if (!row.object.empty())
                known.insert(text(row.object) + '.' + text(row.key));
        }
    const QJsonObject properties = committedSchema().value("properties").toObject();
    for (const QString& key : properties.keys()) {
        QVERIFY2(known.contains(key), qPrintable(key));
        if (properties.value(key).toObject().value("type").toString() == QLatin1String("object"))
            for (const QString& inner :
                 properties.value(key).toObject().value("properties").toObject().keys())
                QVERIFY2(known.contains(key + '.' + inner), qPrintable(key + '.' + inner));
    }
}

QTEST_APPLESS_MAIN(TestProcedureRows)
#include "test_procedure_rows.moc"
