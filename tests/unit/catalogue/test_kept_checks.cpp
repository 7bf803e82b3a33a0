// SPDX-License-Identifier: GPL-3.0-or-later
// What a level or a study may say: each of its numbers made 0, smaller, larger, and as large as every other
// number of its unit, so that each limit is met just there, against what was kept. Refused values with their
// place and reason; who gives a limit up says so.
#include "support/kept_figures.h"

#include "catalogue/canonical_json.h"
#include "catalogue/catalogue.h"
#include "catalogue/comparison_content.h"
#include "catalogue/exercise_contents.h"
#include "catalogue/json_file.h"
#include "catalogue/object_reader.h"
#include "catalogue/schema.h"
#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "catalogue/whole_file.h"
#include "curriculum/exercises/sphere_apex/catalogue/apex_study_content.h"
#include "simulation/comparison/comparison_parameters.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace chiron;
using namespace chiron::catalogue;
using tests::Figures;

namespace {

const QString kContent = QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content");

/// A number in a document.
struct Leaf {
    QStringList steps; ///< keys, and places in arrays
    double value = 0.0;
    QString unit; ///< what its key ends in, where that is one
    QString path() const { return steps.join(QLatin1Char('.')); }
};

/// "N_per_m" of "stiffness_N_per_m"; of a count or a share none.
QString unitOf(const QString& key) {
    static const QStringList kUnits{"N", "Nm", "mm",  "m",  "cm", "s",   "ms",
                                    "g", "kg", "deg", "Hz", "Fr", "rad", "ticks"};
    const qsizetype per = key.indexOf(QLatin1String("_per_"));
    if (per >= 0)
        return key.mid(key.lastIndexOf(QLatin1Char('_'), per - 1) + 1);
    const QString last = key.section(QLatin1Char('_'), -1);
    return kUnits.contains(last) ? last : QString();
}

/// Only the first of an array's own numbers and objects: the others are as it is.
void collect(const QJsonValue& value, const QStringList& steps, std::vector<Leaf>& leaves) {
    if (value.isDouble()) {
        QString key = steps.back();
        for (qsizetype i = steps.size(); i-- > 0 && key.front().isDigit();)
            key = steps[i];
        leaves.push_back({steps, value.toDouble(), unitOf(key)});
    } else if (value.isObject()) {
        const QJsonObject object = value.toObject();
        for (auto it = object.begin(); it != object.end(); ++it)
            collect(it.value(), steps + QStringList(it.key()), leaves);
    } else if (value.isArray() && !value.toArray().isEmpty() && value.toArray().size() < 200) {
        collect(value.toArray().at(0), steps + QStringList(QStringLiteral("0")), leaves);
    }
}

QJsonValue changed(const QJsonValue& json, const QStringList& steps, double to) {
    if (steps.isEmpty())
        return to;
    if (json.isArray()) {
        QJsonArray array = json.toArray();
        array[steps.front().toInt()] = changed(array.at(steps.front().toInt()), steps.mid(1), to);
        return array;
    }
    QJsonObject object = json.toObject();
    object[steps.front()] = changed(object[steps.front()], steps.mid(1), to);
    return object;
}

/// Long lists of numbers by their first, middle and last: tables of a procedure take long to be made.
QJsonValue shortened(const QJsonValue& json) {
    if (json.isArray()) {
        const QJsonArray array = json.toArray();
        if (array.size() > 6 && array.at(0).isDouble())
            return QJsonArray{array.at(0), array.at(array.size() / 2), array.at(array.size() - 1)};
        QJsonArray out;
        for (const QJsonValue one : array)
            out.append(shortened(one));
        return out;
    }
    if (!json.isObject())
        return json;
    QJsonObject object = json.toObject();
    for (const QString& key : object.keys())
        object[key] = shortened(object[key]);
    return object;
}

/// What a number may be made: a whole one stays whole. `few`: where each takes long, as a soft organ does.
std::set<double> others(const Leaf& leaf, const std::vector<Leaf>& all, bool few = false) {
    std::set<double> values;
    for (const double factor : {-1.0, 0.0, 0.1, 0.5, 0.9, 1.1, 2.0, 5.0})
        if (!few || factor == 0.5 || factor == 2.0)
            values.insert(factor * leaf.value);
    for (const Leaf& other : all)
        if (other.unit == leaf.unit &&
            (!few || leaf.unit == QLatin1String("ms") || leaf.unit == QLatin1String("ticks")))
            values.insert(other.value);
    std::set<double> result;
    for (const double value : values)
        result.insert(leaf.value == std::floor(leaf.value) && leaf.unit.isEmpty()
                          ? std::round(value)
                          : std::stod(QString::number(value, 'g', 6).toStdString()));
    result.erase(leaf.value);
    return result;
}

QString said(const Problems& problems) {
    QStringList text;
    for (const Problem& problem : problems)
        text << problem.path + QStringLiteral(": ") + problem.found + QStringLiteral(": expected ") +
                    problem.expected;
    return text.join(QStringLiteral(" | ")).left(300);
}

} // namespace

class TestKeptChecks : public QObject {
    Q_OBJECT
private slots:
    void levels_data();
    void levels();
    void studies_data();
    void studies();
    void comparedObjects();
    void jsonTexts();
    void wordsOfProblems();
    void typedMembers();
    void schemas();
    void wholeFiles();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const QString& name, const Figures& figures) {
        const QString differs = m_kept.differs(name, figures.lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    catalogue::Catalogue m_catalogue = *Catalogue::load(kContent.toStdString());
    catalogue::StudyCatalogue m_studies = *StudyCatalogue::load(kContent.toStdString());
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/catalogue/kept_checks.txt"),
                           tests::sameFigures};
};

void TestKeptChecks::levels_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    for (const Exercise& exercise : m_catalogue.exercises())
        for (const ExerciseLevel& level : exercise.levels)
            if (level.number == 1 || level.number == static_cast<int>(exercise.levels.size()) ||
                level.id == "soft_organ")
                QTest::addRow("%s %d", exercise.id.c_str(), level.number)
                    << QString::fromStdString(exercise.id) << level.number;
}

void TestKeptChecks::levels() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    const ExerciseLevel* found = m_catalogue.find(exercise.toStdString(), level);
    const ExerciseContent* content = findExerciseContent(exercise.toStdString());
    QVERIFY(found && content);
    const auto schema =
        readSchema(kContent + QStringLiteral("/schema"),
                   QString::fromUtf8(content->parametersSchema.data(),
                                     static_cast<qsizetype>(content->parametersSchema.size())));
    QVERIFY(schema);
    const QJsonObject given = QJsonDocument::fromJson(QByteArray::fromStdString(found->resolvedJson))
                                  .object()["level"]
                                  .toObject()["parameters"]
                                  .toObject();
    QVERIFY(!given.isEmpty());
    std::vector<Leaf> leaves;
    collect(given, {}, leaves);
    Figures out;
    for (const Leaf& leaf : leaves) {
        QStringList taken;
        for (const double value : others(leaf, leaves, found->id == "soft_organ")) {
            Problems problems;
            const QJsonObject parameters =
                validated(changed(given, leaf.steps, value), *schema, QStringLiteral("$"), problems)
                    .toObject();
            const bool inRange = problems.empty();
            if (inRange) {
                const ExerciseParameters read =
                    content->read(ObjectReader(parameters, QStringLiteral("$"), problems), found->cues);
                content->check(read, QStringLiteral("$"), problems);
            }
            const QString shown = QString::number(value, 'g', 6);
            if (problems.empty())
                taken << shown;
            else
                out.say(leaf.path() + QLatin1Char(' ') + shown,
                        (inRange ? QString() : QStringLiteral("out of range, "))
                            .append(said(problems))
                            .toStdString());
        }
        out.say(leaf.path() + QStringLiteral(" may be"), taken.join(QLatin1Char(' ')).toStdString());
    }
    hold(QStringLiteral("%1 %2").arg(exercise).arg(level), out);
}

void TestKeptChecks::studies_data() {
    QTest::addColumn<QString>("file");
    for (const QString& file :
         QDir(kContent + QStringLiteral("/studies")).entryList({QStringLiteral("*.json")}))
        QTest::addRow("%s", qPrintable(file)) << file;
}

void TestKeptChecks::studies() {
    QFETCH(QString, file);
    const psychophysics::StudyDesign* design =
        m_studies.find(QFileInfo(file).completeBaseName().toStdString());
    QVERIFY(design);
    const QJsonObject given = shortened(QJsonDocument::fromJson(studyJson(*design)).object()).toObject();
    QVERIFY(readStudy(QJsonDocument(given).toJson(), "s"));
    std::vector<Leaf> leaves;
    collect(given, {}, leaves);
    Figures out;
    for (const Leaf& leaf : leaves) {
        QStringList taken;
        for (const double value : others(leaf, leaves)) {
            const auto read = readStudy(
                QJsonDocument(changed(given, leaf.steps, value).toObject()).toJson(QJsonDocument::Compact),
                "s");
            const QString shown = QString::number(value, 'g', 6);
            if (read)
                taken << shown;
            else
                out.say(leaf.path() + QLatin1Char(' ') + shown, read.error().message.substr(0, 300));
        }
        out.say(leaf.path() + QStringLiteral(" may be"), taken.join(QLatin1Char(' ')).toStdString());
    }
    hold(file, out);
}

/// What the conditions of a study become, and what no condition may be.
void TestKeptChecks::comparedObjects() {
    Figures out;
    const auto level = [&](const QString& name, const ExerciseLevel& of) {
        static const QRegularExpression marks(QStringLiteral("[][{},:]+"));
        out.say(name, QString::fromStdString(of.resolvedJson)
                          .replace(marks, QStringLiteral(" "))
                          .left(2500)
                          .toStdString());
        const auto again = fromResolvedJson(of.resolvedJson);
        QVERIFY2(again && again->resolvedSha256 == of.resolvedSha256, qPrintable(name));
    };
    for (const QString& file :
         QDir(kContent + QStringLiteral("/studies")).entryList({QStringLiteral("*.json")})) {
        const psychophysics::StudyDesign* design =
            m_studies.find(QFileInfo(file).completeBaseName().toStdString());
        QVERIFY(design);
        for (const psychophysics::Condition& condition : design->conditions) {
            const QString name = file + QLatin1Char(' ') + QString::fromStdString(condition.id);
            const auto compared = comparisonOf(condition, design->trial);
            const auto found = apexOf(condition, design->trial, 12);
            if (compared)
                level(name, comparisonLevel(*compared, design->id, condition.id));
            if (found)
                level(name, apexLevel(*found, design->id, condition.id));
            out.say(name, (compared ? std::string() : compared.error().message) + " | " +
                              (found ? std::string() : found.error().message));
            out.add(QStringLiteral("middle"), middleReference(condition));
        }
    }
    psychophysics::Condition apex;
    apex.id = "a";
    apex.stimulus.attribute = psychophysics::Attribute::apex;
    psychophysics::TrialRules rules;
    rules.visibleObjects = false;
    rules.exploreLimit_s = 0.0;
    for (const double radius_m : {0.0, 0.00499, 0.005, 0.02, 0.045, 0.04501, std::nan("")})
        for (const int trials : {0, 1, 32, 33}) {
            apex.stimulus.reference = radius_m;
            const auto found = apexOf(apex, rules, trials);
            out.say(QStringLiteral("radius %1").arg(radius_m),
                    found ? std::string("taken") : found.error().message);
            if (found)
                out.add(QStringLiteral("sphere"), found->trials, 1e3 * found->radius_m,
                        1e3 * found->centreDiscRadius_m, found->trialLimit_s, found->betweenTrials_s,
                        found->cues.size());
        }
    apex.stimulus.reference = 0.02;
    for (const std::string& name : fixedAttributeNames())
        for (const double value : {-1.0, 0.0, 0.4, std::nan("")}) {
            apex.stimulus.fixed = {{name, value}};
            const auto attributes = attributesOf(apex.stimulus.fixed);
            const auto found = apexOf(apex, rules, 3);
            out.say(QString::fromStdString(name) + QStringLiteral(" %1").arg(value),
                    (attributes ? std::string("taken") : attributes.error().message) + " | " +
                        (found ? std::string("taken") : found.error().message));
        }
    out.say(QStringLiteral("colour"), attributesOf({{"colour", 1.0}}).error().message);
    simulation::ComparisonParameters good;
    good.values = {{1.0, 2.0, 3.0}};
    good.arrangements = {{0, 1, 2}};
    const auto checked = [&](const char* name, auto change) {
        simulation::ComparisonParameters other = good;
        change(other);
        Problems problems;
        checkComparison(ExerciseParameters(other), QStringLiteral("$"), problems);
        out.say(QLatin1String(name), said(problems).toStdString());
    };
    for (const int places : {0, 1, 3, 4})
        checked("places", [&](auto& p) { p.places = places; });
    for (const std::size_t rows : {0U, 1U, 4096U, 4097U})
        checked("values", [&](auto& p) { p.values.assign(rows, {1.0, 2.0, 3.0}); });
    for (const std::size_t rows : {0U, 1U, 16U, 17U})
        checked("arrangements", [&](auto& p) { p.arrangements.assign(rows, {0, 1, 2}); });
    for (const double value : {0.0, -1.0, 1e-9, std::nan(""), HUGE_VAL})
        checked("value", [&](auto& p) { p.values.push_back({1.0, value, 2.0}); });
    // Every key of what a session of a study stored, gone, of another type, or with a stranger beside it.
    const ExerciseLevel stored = comparisonLevel(good, "s", "c");
    const QJsonObject document =
        QJsonDocument::fromJson(QByteArray::fromStdString(stored.resolvedJson)).object();
    const QJsonObject whole = document["level"].toObject(), parameters = whole["parameters"].toObject();
    const auto read = [&](const QString& name, const QString& inside, const QString& key,
                          const QJsonValue& value) {
        QJsonObject changedParameters = parameters, changedLevel = whole, changedDocument = document;
        QJsonObject& into = inside == QLatin1String("parameters") ? changedParameters : changedLevel;
        if (value.isUndefined())
            into.remove(key);
        else
            into[key] = value;
        if (inside == QLatin1String("parameters"))
            changedLevel["parameters"] = changedParameters;
        changedDocument["level"] = changedLevel;
        const auto again = fromResolvedJson(canonicalJson(changedDocument));
        out.say(name + QLatin1Char(' ') + key,
                again ? std::string("is read") : again.error().message.substr(0, 300));
    };
    for (const auto& [inside, object] :
         {std::pair<QString, QJsonObject>{QStringLiteral("parameters"), parameters},
          {QStringLiteral("level"), whole}})
        for (const QString& key : object.keys()) {
            read(QStringLiteral("without"), inside, key, QJsonValue::Undefined);
            read(QStringLiteral("a text"), inside, key, QStringLiteral("text"));
            read(QStringLiteral("a number"), inside, key, 1.5);
            read(QStringLiteral("an array"), inside, key, QJsonArray{QJsonArray{1, 2}});
        }
    read(QStringLiteral("with"), QStringLiteral("parameters"), QStringLiteral("stranger"), 1);
    hold(QStringLiteral("compared objects"), out);
}

/// What is JSON and what is not, just at each rule.
void TestKeptChecks::jsonTexts() {
    Figures out;
    const auto told = [&](const QString& name, const QByteArray& text) {
        const auto file = JsonFile::parse(text, QStringLiteral("f"));
        out.say(name, file ? "is " + canonicalJson(file->root()).substr(0, 160)
                           : file.error().message.substr(0, 240));
    };
    for (const char* number :
         {"0",   "-0",    "-",       "00",   "01",    "-01",  "10",   "1.0",   "1.",  ".5",      "0.5",
          "-.5", "1e5",   "1E+5",    "1e-5", "1e",    "1e+",  "1e5.", "1.5.2", "+1",  "--1",     "0x1",
          "1_0", "1e400", "-1.5e-3", "true", "false", "null", "True", "nul",   "NaN", "Infinity"}) {
        told(QStringLiteral("number %1").arg(QLatin1String(number)), QByteArray("{\"a\": ") + number + "}");
        told(QStringLiteral("numbers %1").arg(QLatin1String(number)),
             QByteArray("{\n\"a\": [1,\n ") + number + " , 2]}");
    }
    for (const char* text : {"\"\"", "\"a\\\"b\"", "\"\\\\\"", "\"\\/\\b\\f\\n\\r\\t\"", "\"\\u00e4\"",
                             "\"\\x\"", "\"\\u12\"", "\"\\", "\"a", "a", "'a'", "\"\x09\"", "\"\x1f\"",
                             "\"\x7f\"", "\"\xc3\xa4\"", "\"\xc3\"", "\"\xe2\x82\"", "\"\xff\""})
        told(QStringLiteral("text"), QByteArray("{\"k\": 1,\n \"a\": ") + text + "}");
    for (const int depth : {1, 13, 14, 15, 16, 17, 18}) {
        told(QStringLiteral("%1 arrays").arg(depth),
             "{\"a\": " + QByteArray(depth, '[') + QByteArray(depth, ']') + "}");
        told(QStringLiteral("%1 objects").arg(depth),
             QByteArray("{\"a\": ").repeated(depth) + "1" + QByteArray(depth, '}'));
    }
    for (const char* text : {"{}",
                             " {\t}\r\n",
                             "{} x",
                             "{}}",
                             "{\"a\":1,}",
                             "{\"a\":1 \"b\":2}",
                             "{\"a\" 1}",
                             "{a:1}",
                             "{\"a\":[1,]}",
                             "{\"a\":[1 2]}",
                             "{\"a\":[,1]}",
                             "[]",
                             "[1]",
                             "1",
                             "\"a\"",
                             "null",
                             "",
                             "\xef\xbb\xbf{\"a\":1}",
                             "\xef\xbb{}",
                             "{\"a\":{\"b\":1,\"c\":2,\"b\":3},\"a\":0}",
                             "{\"a\":[{\"b\":1},{\"b\":1}]}",
                             "{\"a b\":[0,{\"\":01}]}",
                             "{\"a\":1}\n{\"b\":2}",
                             "{\"a\":01,\n\"b\":.5,\n\n  \"c\":[1.,2]}"})
        told(QLatin1String(text), text);
    const qsizetype mebibyte = 1 << 20;
    for (const qsizetype size : {mebibyte - 1, mebibyte, mebibyte + 1})
        told(QStringLiteral("%1 bytes").arg(size), "{}" + QByteArray(size - 2, ' '));
    out.say(QStringLiteral("two mebibytes"),
            JsonFile::parse("{}" + QByteArray(2 * mebibyte - 2, ' '), QStringLiteral("f"), 2) ? "taken"
                                                                                              : "refused");
    const auto file = JsonFile::parse("{\"a\": 1,\n\"b\": [{\"c\": 2}]}", QStringLiteral("f"));
    for (const std::size_t count : {1U, 19U, 20U, 21U, 22U}) {
        const std::string message = file->error(Problems(count, {QStringLiteral("$.b[0].c.d"),
                                                                 QStringLiteral("x"), QStringLiteral("y")}))
                                        .message;
        out.add(QStringLiteral("lines"), count, std::count(message.begin(), message.end(), '\n'));
        out.say(QStringLiteral("ends"), message.substr(message.size() - 20));
    }
    for (const char* path : {"$", "$.a", "$.b", "$.b[0]", "$.b[1]", "$.b[0].c", "$.b[0].x.y", "$.x", "x"})
        out.say(QLatin1String(path),
                file->error({{QLatin1String(path), QStringLiteral("x"), QStringLiteral("y")}}).message);
    hold(QStringLiteral("json texts"), out);
}

void TestKeptChecks::wordsOfProblems() {
    Figures out;
    for (const QString& key :
         {QString(), QStringLiteral("a"), QStringLiteral("azAZ09_"), QStringLiteral("a-b"),
          QStringLiteral("a b"), QString(60, QLatin1Char('x')), QString(61, QLatin1Char('x')),
          QStringLiteral("\u00e4"), QStringLiteral("`"), QStringLiteral("{"), QStringLiteral("@"),
          QStringLiteral("["), QStringLiteral("/"), QStringLiteral(":")})
        out.say(QStringLiteral("path"), memberPath(QStringLiteral("$"), key).toStdString());
    for (const int code : {0x1f, 0x20, 0x7e, 0x7f, 0x80, 0x9f, 0xa0, 0xe4})
        out.say(QStringLiteral("quoted %1").arg(code), quoted(QString(QChar(code))).toStdString());
    for (const int size : {0, 39, 40, 41, 90})
        out.say(QStringLiteral("quoted"), quoted(QString(size, QLatin1Char('y'))).toStdString());
    const std::vector<QString> known{QStringLiteral("radius_mm"), QStringLiteral("radii_mm"),
                                     QStringLiteral("ab"),        QStringLiteral("abc"),
                                     QStringLiteral("abcd"),      QString(79, QLatin1Char('z'))};
    for (const QString& given :
         {QStringLiteral("radius_mm"), QStringLiteral("raduis_mm"), QStringLiteral("radus"),
          QStringLiteral("radi"), QStringLiteral("xradius_mmyz"), QStringLiteral("xradius_mmyzw"),
          QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("cd"), QStringLiteral("xyz"),
          QStringLiteral("abx"), QStringLiteral("dcba"), QString(), QString(80, QLatin1Char('z')),
          QString(81, QLatin1Char('z')), QString(76, QLatin1Char('z'))})
        out.say(QStringLiteral("meant by %1").arg(given), didYouMean(given, known).toStdString());
    out.say(QStringLiteral("element"), elementPath(QStringLiteral("$.a"), 12).toStdString());
    hold(QStringLiteral("words of problems"), out);
}

void TestKeptChecks::typedMembers() {
    Figures out;
    const QJsonObject json =
        QJsonDocument::fromJson(
            R"({"text":"t","whole":3,"share":0.5,"most":2147483647,"more":2147483648,"least":-2147483647,"less":-2147483648,"yes":true,"none":null,
        "words":["a",1,"b"],"objects":[{"text":"x"},2,{}],"in":{"en":"E","de":7},"german":{"de":"D"}})")
            .object();
    for (const QString& key : json.keys() + QStringList(QStringLiteral("gone"))) {
        Problems problems;
        const ObjectReader reader(json, QStringLiteral("$"), problems);
        out.say(key + QStringLiteral(" as text"), reader.text(key));
        out.add(key + QStringLiteral(" as numbers"), reader.number(key), reader.integer(key),
                reader.boolean(key), reader.has(key));
        for (const auto& [language, text] : reader.translated(key))
            out.say(key + QStringLiteral(" in ") + QString::fromStdString(language), text);
        out.say(key + QStringLiteral(" has"), reader.texts(key));
        reader.eachObject(key, [&](const ObjectReader& one) { out.say(one.path(), one.text("text")); });
        out.say(key + QStringLiteral(" below"), reader.object(key).path().toStdString());
        for (const Problem& problem : problems)
            out.say(QStringLiteral("- ") + problem.path,
                    problem.found.toStdString() + ": " + problem.expected.toStdString());
    }
    Problems problems;
    refuseUnknownKeys(ObjectReader(json, QStringLiteral("$"), problems),
                      {QStringLiteral("texts"), QStringLiteral("whole"), QStringLiteral("share")},
                      QStringLiteral("a key"));
    out.say(QStringLiteral("unknown"), said(problems).toStdString());
    hold(QStringLiteral("typed members"), out);
}

void TestKeptChecks::schemas() {
    Figures out;
    const QTemporaryDir folder;
    const auto write = [&](const char* name, const QByteArray& text) {
        QFile file(folder.filePath(QLatin1String(name) + QStringLiteral(".json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    write("word", R"({"type":"string","description":"w","minLength":2,"maxLength":5,"format":"identifier"})");
    write("whole", R"({"type":"object","description":"d","required":["n"],"properties":{
        "n":{"type":"number","description":"n","unit":"mm","minimum":-1.5,"maximum":2},
        "i":{"type":"integer","description":"i","unit":"1","minimum":0,"maximum":4,"default":3},
        "w":{"$ref":"word.json","description":"own words"},
        "one":{"type":"string","description":"o","enum":["left","right"],"default":"left"},
        "b":{"type":"boolean","description":"b","default":true},
        "list":{"type":"array","description":"l","minItems":1,"maxItems":3,"uniqueItems":true,"items":{"type":"integer","description":"e","unit":"1","minimum":0,"maximum":9}}}})");
    const auto schema = readSchema(folder.path(), QStringLiteral("whole"));
    QVERIFY(schema);
    out.say(QStringLiteral("described"),
            schema->properties.at(QStringLiteral("w"))->description.toStdString());
    for (const char* text : {R"({"n":-1.5})",
                             R"({"n":-1.51})",
                             R"({"n":2})",
                             R"({"n":2.001})",
                             R"({"n":"2"})",
                             R"({})",
                             R"({"n":0,"i":0})",
                             R"({"n":0,"i":4})",
                             R"({"n":0,"i":5})",
                             R"({"n":0,"i":-1})",
                             R"({"n":0,"i":2.5})",
                             R"({"n":0,"w":"a"})",
                             R"({"n":0,"w":"ab"})",
                             R"({"n":0,"w":"abcde"})",
                             R"({"n":0,"w":"abcdef"})",
                             R"({"n":0,"w":"_ab"})",
                             R"({"n":0,"w":"9ab"})",
                             R"({"n":0,"w":"a_9z"})",
                             R"({"n":0,"w":"aB"})",
                             R"({"n":0,"w":"a-b"})",
                             R"({"n":0,"w":"a"})",
                             R"({"n":0,"w":"a"})",
                             R"({"n":0,"one":"right"})",
                             R"({"n":0,"one":"rigth"})",
                             R"({"n":0,"one":""})",
                             R"({"n":0,"b":1})",
                             R"({"n":0,"b":false})",
                             R"({"n":0,"list":[]})",
                             R"({"n":0,"list":[1]})",
                             R"({"n":0,"list":[1,2,3]})",
                             R"({"n":0,"list":[1,2,3,4]})",
                             R"({"n":0,"list":[1,2,1]})",
                             R"({"n":0,"list":[9,10]})",
                             R"({"n":0,"list":{}})",
                             R"({"n":0,"lst":[1]})",
                             R"({"n":1e400})",
                             R"({"n":null})",
                             R"({"n":[1,2]})",
                             R"({"n":{}})"}) {
        Problems problems;
        const QJsonValue filled =
            validated(QJsonDocument::fromJson(text).object(), *schema, QStringLiteral("$"), problems);
        out.say(QLatin1String(text), problems.empty() ? canonicalJson(filled) : said(problems).toStdString());
    }
    Problems problems;
    validated(QJsonArray{}, *schema, QStringLiteral("$"), problems);
    out.say(QStringLiteral("an array"), said(problems).toStdString());
    int number = 0;
    for (const char* text :
         {R"({"type":"number","description":"d","unit":"mm","minimum":0})",
          R"({"type":"number","description":"d","unit":"mm","maximum":0})",
          R"({"type":"integer","description":"d","minimum":0,"maximum":1})",
          R"({"type":"number","unit":"1","minimum":0,"maximum":1})", R"({"type":"string"})",
          R"({"type":"text","description":"d"})", R"({"description":"d"})",
          R"({"type":"string","description":"d","default":3})",
          R"({"type":"string","description":"d","maxLength":2,"default":"abc"})",
          R"({"type":"string","description":"d","pattern":"x"})",
          R"({"type":"object","description":"d","required":["a"]})",
          R"({"type":"object","description":"d","properties":{"a":{"type":"boolean"}}})",
          R"({"type":"array","description":"d","items":{"type":"number"}})",
          R"({"$ref":"gone.json","description":"d"})", R"({"$ref":"word.json"})",
          R"({"type":"object","description":"d","properties":{"a":{"$ref":"word.json","default":"A"}}})"}) {
        const QByteArray name = "s" + QByteArray::number(++number);
        write(name.constData(), text);
        const auto read = readSchema(folder.path(), QLatin1String(name));
        out.say(QLatin1String(text), read ? std::string("a schema")
                                          : QString::fromStdString(read.error().message)
                                                .replace(folder.path(), QStringLiteral("DIR"))
                                                .toStdString());
    }
    for (int links = 7; links <= 10; ++links) { // one that refers to one that refers ...
        for (int i = 0; i < links; ++i)
            write(("r" + QByteArray::number(i)).constData(),
                  i + 1 < links ? QByteArray("{\"$ref\":\"r" + QByteArray::number(i + 1) + ".json\"}")
                                : QByteArray("{\"type\":\"boolean\",\"description\":\"d\"}"));
        const auto read = readSchema(folder.path(), QStringLiteral("r0"));
        out.say(QStringLiteral("%1 in a row").arg(links),
                read ? std::string("a schema")
                     : QString::fromStdString(read.error().message)
                           .replace(folder.path(), QStringLiteral("DIR"))
                           .toStdString());
    }
    hold(QStringLiteral("schemas"), out);
}

void TestKeptChecks::wholeFiles() {
    Figures out;
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("f")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(1000, 'x'));
    file.close();
    for (const qint64 largest : {0, 999, 1000, 1001}) {
        const auto read = readWholeFile(file.fileName(), largest);
        out.say(QStringLiteral("%1").arg(largest), read ? std::to_string(read->size())
                                                        : QString::fromStdString(read.error().message)
                                                              .replace(folder.path(), QStringLiteral("DIR"))
                                                              .toStdString());
    }
    for (const QString& path : {folder.path(), folder.filePath(QStringLiteral("gone"))})
        out.say(QStringLiteral("path"), QString::fromStdString(readWholeFile(path, 10).error().message)
                                            .replace(folder.path(), QStringLiteral("DIR"))
                                            .toStdString());
    hold(QStringLiteral("whole files"), out);
}

QTEST_APPLESS_MAIN(TestKeptChecks)
#include "test_kept_checks.moc"
