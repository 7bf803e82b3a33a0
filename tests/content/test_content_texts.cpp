// SPDX-License-Identifier: GPL-3.0-or-later
// Translations stand in a file per language beside the content: all of them are there, a language is a line
// and files, and no digest of a task depends on them.
#include "catalogue/canonical_json.h"
#include "catalogue/catalogue.h"
#include "catalogue/content_texts.h"
#include "catalogue/instrument_catalogue.h"
#include "catalogue/resolved_level.h"
#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "core/languages.h"
#include "support/content_copy.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::catalogue;

namespace {

const QString kLevel = QStringLiteral("exercises/sphere_apex/levels/visible.json");
const QString kGerman = QStringLiteral("exercises/sphere_apex/texts/de.json");

QStringList keysOf(const char* path) {
    return QString::fromUtf8(path).split(u'/');
}

/// `json` with `value` at the end of `keys`; undefined: taken out.
QJsonObject with(QJsonObject json, const QStringList& keys, const QJsonValue& value) {
    if (keys.size() > 1)
        json[keys.front()] = with(json[keys.front()].toObject(), keys.mid(1), value);
    else if (value.isUndefined())
        json.remove(keys.front());
    else
        json[keys.front()] = value;
    return json;
}

QJsonObject objectIn(const ContentCopy& copy, const QString& file) {
    return QJsonDocument::fromJson(copy.read(file)).object();
}

void change(const ContentCopy& copy, const QString& file, const QStringList& keys, const QJsonValue& value) {
    copy.write(file, QJsonDocument(with(objectIn(copy, file), keys, value)).toJson());
}

/// Why the content is not read; empty: it is.
std::string faultOf(const ContentCopy& copy,
                    const std::vector<std::string>& languages = core::languageIds()) {
    if (const auto catalogue = Catalogue::load(copy.directory(), languages); !catalogue)
        return catalogue.error().message;
    if (const auto studies = StudyCatalogue::load(copy.directory(), languages); !studies)
        return studies.error().message;
    const auto instruments = loadInstruments(copy.directory(), languages);
    return instruments ? std::string() : instruments.error().message;
}

Catalogue loaded(const ContentCopy& copy) {
    auto catalogue = Catalogue::load(copy.directory());
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return std::move(*catalogue);
}

/// Every folder that has files of languages.
QStringList textFolders(const ContentCopy& copy) {
    QStringList folders;
    QDirIterator it(copy.path(QString()), {QStringLiteral("texts")}, QDir::Dirs,
                    QDirIterator::Subdirectories);
    while (it.hasNext())
        folders << it.next();
    return folders;
}

/// An object that has a text in English as one of several languages.
bool hasTextByLanguage(const QJsonValue& value) {
    const QJsonObject object = value.toObject();
    const QJsonArray array = value.toArray();
    return object.contains(QStringLiteral("en")) ||
           std::any_of(object.begin(), object.end(),
                       [](const QJsonValue& each) { return hasTextByLanguage(each); }) ||
           std::any_of(array.begin(), array.end(),
                       [](const QJsonValue& each) { return hasTextByLanguage(each); });
}

} // namespace

class TestContentTexts : public QObject {
    Q_OBJECT
private slots:
    void everyTextIsInEveryLanguage();
    void aLanguageIsALineAndFiles();
    void whatIsMissingIsToldAndShownInEnglish();
    void textsForNothingAreRefused_data();
    void textsForNothingAreRefused();
    void filesOfStrangeLanguagesAreRefused();
    void aSentenceOnAMomentHasItsPlaces();
    void theTaskHasNoTexts();
    void aTextChangesNoTask();
    void aNumberChangesTheTask();
    void filesWithAllLanguagesAreReadAsBefore();
    void whatWasStoredBeforeHasTheTaskOfToday();
};

void TestContentTexts::everyTextIsInEveryLanguage() {
    const ContentCopy copy;
    const auto report = [](const std::vector<MissingText>& missing) {
        std::string lines;
        for (const MissingText& text : missing)
            lines += text.file + ": " + text.path + ": " + text.language + "\n";
        return lines;
    };
    const auto studies = StudyCatalogue::load(copy.directory());
    QVERIFY2(studies.has_value(), studies ? "" : studies.error().message.c_str());
    QCOMPARE(report(loaded(copy).missingTexts()), std::string());
    QCOMPARE(report(studies->missingTexts()), std::string());
    const auto instruments = loadInstruments(copy.directory());
    QVERIFY2(instruments.has_value(), instruments ? "" : instruments.error().message.c_str());
    for (const Instrument& instrument : *instruments)
        for (const auto& item : instrument.questionnaire.items)
            for (const std::string& language : core::languageIds()) {
                QVERIFY2(item.text.contains(language), item.id.c_str());
                for (const auto& choice : item.choices)
                    QVERIFY2(choice.contains(language), item.id.c_str());
            }
    const Catalogue catalogue = loaded(copy);
    for (const Exercise& exercise : catalogue.exercises()) // and no exercise's content was passed over
        for (const std::string& language : core::languageIds())
            QVERIFY2(exercise.textsSha256.contains(language), exercise.id.c_str());
}

// An invented language: its files are copies of the German ones.
void TestContentTexts::aLanguageIsALineAndFiles() {
    const ContentCopy copy;
    const QStringList folders = textFolders(copy);
    const auto exercises = static_cast<qsizetype>(loaded(copy).exercises().size());
    QCOMPARE(folders.size(), exercises + 5); // and objects, meshes, tissues, studies, instruments
    for (const QString& folder : folders)
        QVERIFY(QFile::copy(folder + QStringLiteral("/de.json"), folder + QStringLiteral("/xx.json")));
    std::vector<std::string> languages = core::languageIds();
    languages.push_back("xx");
    QCOMPARE(faultOf(copy, languages), std::string());
    const auto catalogue = Catalogue::load(copy.directory(), languages);
    QVERIFY(catalogue->missingTexts().empty());
    for (const Exercise& exercise : catalogue->exercises()) {
        QCOMPARE(exercise.title.at("xx"), exercise.title.at("de"));
        for (const Advice& advice : exercise.advice)
            QCOMPARE(advice.text.at("xx"), advice.text.at("de"));
        for (const LegendLine& line : exercise.legend)
            QCOMPARE(line.text.at("xx"), line.text.at("de"));
        for (const ExerciseLevel& level : exercise.levels) {
            QCOMPARE(level.objective.at("xx"), level.objective.at("de"));
            QCOMPARE(textIn(level.title, "xx"), level.title.at("de"));
        }
    }
    const auto studies = StudyCatalogue::load(copy.directory(), languages);
    QVERIFY(studies->missingTexts().empty());
    QCOMPARE(studies->find("surgeons")->questionnaires.front().items.front().text.at("xx"),
             studies->find("surgeons")->questionnaires.front().items.front().text.at("de"));
    const auto instruments = loadInstruments(copy.directory(), languages);
    QCOMPARE(instruments->front().questionnaire.title.at("xx"),
             instruments->front().questionnaire.title.at("de"));
}

void TestContentTexts::whatIsMissingIsToldAndShownInEnglish() {
    const ContentCopy copy;
    change(copy, kGerman, keysOf("levels/visible/title"), QJsonValue::Undefined);
    change(copy, QStringLiteral("objects/texts/el.json"), {QStringLiteral("ovary")}, QJsonValue::Undefined);
    const Catalogue catalogue = loaded(copy);
    const std::vector<MissingText> expected{
        {"el", copy.path(QStringLiteral("objects/ovary.json")).toStdString(), "$.title"},
        {"de", copy.path(kLevel).toStdString(), "$.title"}};
    QVERIFY(catalogue.missingTexts() == expected);
    const ExerciseLevel& level = *catalogue.find("sphere_apex", 1);
    QCOMPARE(textIn(level.title, "de"), level.title.at("en"));
    QVERIFY(textIn(level.title, "el") != level.title.at("en"));
    QVERIFY(QFile::remove(copy.path(kGerman))); // a language may lack a whole file
    QCOMPARE(faultOf(copy), std::string());
    QVERIFY(loaded(copy).missingTexts().size() > expected.size());
}

void TestContentTexts::textsForNothingAreRefused_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("keys");
    QTest::addColumn<QJsonValue>("value");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* tag, const char* file, const char* keys, const QJsonValue& value,
                        const char* says) {
        QTest::newRow(tag) << QString::fromLatin1(file) << QString::fromLatin1(keys) << value
                           << QString::fromLatin1(says);
    };
    const char* german = "exercises/sphere_apex/texts/de.json";
    row("level", german, "levels/visibel/title", "x",
        "$.levels.visibel: the content has no such part: expected one of ");
    row("part", german, "level/visible", QJsonObject{},
        "$.level: the content has no such part: expected one of exercise, levels; did you mean \"levels\"?");
    row("key of a level", german, "levels/visible/titel", "x",
        "$.levels.visible.titel: the content has no such text: expected one of ");
    row("key that is no text", german, "levels/visible/number", "x",
        "$.levels.visible.number: the content has no such text");
    row("text that English lacks", german, "levels/visible/shown_force_variant", QJsonObject{{"note", "x"}},
        "$.levels.visible.shown_force_variant: the content has no such text");
    row("advice", german, "exercise/advice/time_and_again/text", "x",
        "$.exercise.advice.time_and_again: the content has no such metric: expected one of ");
    row("mark", german, "exercise/legend/arrow/text", "x",
        "$.exercise.legend.arrow: the content has no such mark: expected one of ");
    row("no text", german, "levels/visible/title", 7,
        "$.levels.visible.title: another type: expected a text");
    row("several languages", german, "levels/visible/title", QJsonObject{{"de", "x"}},
        "$.levels.visible.title: an object: expected a text");
    row("empty", german, "levels/visible/title", "",
        "$.levels.visible.title: \"\": expected a text of this many characters, 1 to 800");
    row("a text for a level", german, "levels/visible", "x",
        "$.levels.visible: \"x\": expected an object with texts");
    row("list for a list with names", german, "exercise/legend", QJsonArray{"x"},
        "$.exercise.legend: an array of 1: expected an object");
    row("preset", "exercises/urethra_insertion/texts/de.json", "presets/narrow/title", "x",
        "$.presets.narrow: the content has no such part");
    row("object", "objects/texts/el.json", "liver/title", "x",
        "$.liver: the content has no such part: expected one of ");
    row("study", "studies/texts/el.json", "tickling/title", "x", "$.tickling: the content has no such part");
    row("condition", "studies/texts/el.json", "apex/conditions/no_such/title", "x",
        "$.apex.conditions.no_such: the content has no such id");
    row("question", "instruments/texts/de.json", "sus/items/fun/text", "x",
        "$.sus.items.fun: the content has no such id: expected one of ");
    row("answers", "instruments/texts/de.json", "edinburgh/items/writing/choices", QJsonArray{"x"},
        ".choices: an array of 1: expected an array of ");
}

void TestContentTexts::textsForNothingAreRefused() {
    QFETCH(QString, file);
    QFETCH(QString, keys);
    QFETCH(QJsonValue, value);
    QFETCH(QString, says);
    const ContentCopy copy;
    change(copy, file, keys.split(u'/'), value);
    const QString fault = QString::fromStdString(faultOf(copy));
    QVERIFY2(fault.startsWith(copy.path(file) + u':'), qPrintable(fault));
    QVERIFY2(fault.contains(says), qPrintable(fault));
    const QStringList place = fault.mid(copy.path(file).size() + 1).split(u':');
    QVERIFY2(place[0].toInt() >= 1 && place[1].toInt() >= 1, qPrintable(fault));
}

// What a debrief fills in is asked for by name, in every language alike.
void TestContentTexts::aSentenceOnAMomentHasItsPlaces() {
    const QString exercise = QStringLiteral("exercises/sphere_apex/exercise.json");
    const auto faultWith = [&](const char* sentence) {
        const ContentCopy copy;
        QByteArray bytes = copy.read(exercise);
        const qsizetype before = bytes.size();
        bytes.replace("Your first miss was {where}.", sentence);
        copy.write(exercise, bytes);
        return bytes.size() == before ? std::string("nothing was replaced") : faultOf(copy);
    };
    const auto says = [](const std::string& fault, const char* text) {
        return fault.find(text) != std::string::npos;
    };
    const std::string elsewhere = faultWith("Your first miss was here.");
    QVERIFY2(says(elsewhere, "$.advice[0].moment: no place for where it was: expected a text with {where}"),
             elsewhere.c_str());
    const std::string unknown = faultWith("Your first miss was {where}, {reason}.");
    QVERIFY2(
        says(unknown, "$.advice[0].moment: \"{reason}\": expected each at most once of {value}, {event}"),
        unknown.c_str());
    const std::string twice = faultWith("Your first miss was {where} and {where}.");
    QVERIFY2(says(twice, "\"{where}\": expected each at most once"), twice.c_str());
    const ContentCopy copy;
    change(copy, kGerman, keysOf("exercise/advice/apex_misses/moment"), "Ihr erster Fehlversuch: {value}.");
    const std::string translated = faultOf(copy);
    QVERIFY2(says(translated, "$.advice[0].moment.de: \"{value}\": expected the same places as in English"),
             translated.c_str());
}

void TestContentTexts::filesOfStrangeLanguagesAreRefused() {
    const auto refused = [](const char* name, const char* says) {
        const ContentCopy copy;
        const QString file = QStringLiteral("exercises/palpation/texts/") + QLatin1String(name);
        copy.write(file, "{}\n");
        const QString fault = QString::fromStdString(faultOf(copy));
        return fault.startsWith(copy.path(file) + u':') && fault.contains(QLatin1String(says))
                   ? QString()
                   : fault + QStringLiteral(" (no fault in ") + file + u')';
    };
    QCOMPARE(refused("xx.json",
                     "the unknown language \"xx\": expected the file of a language of the program: de, el"),
             QString());
    QCOMPARE(refused("en.json", "expected them in the content files themselves"), QString());
    const ContentCopy twice; // in the level as files had it before, and in the file of the language
    change(twice, kLevel, {QStringLiteral("title")}, QJsonObject{{"en", "Sphere"}, {"de", "Kugel"}});
    QVERIFY(faultOf(twice).find("$.levels.visible.title: given twice") != std::string::npos);
    const ContentCopy stranger;
    change(stranger, kLevel, {QStringLiteral("title")}, QJsonObject{{"en", "Sphere"}, {"xx", "Kugel"}});
    const std::string fault = faultOf(stranger);
    QVERIFY2(fault.starts_with(stranger.path(kLevel).toStdString()) &&
                 fault.find("$.title.xx: an unknown language: expected one of en, de, el") !=
                     std::string::npos,
             fault.c_str());
}

void TestContentTexts::theTaskHasNoTexts() {
    const ContentCopy copy;
    const Catalogue catalogue = loaded(copy);
    for (const Exercise& exercise : catalogue.exercises())
        for (const ExerciseLevel& level : exercise.levels) {
            const QJsonObject document =
                QJsonDocument::fromJson(QByteArray::fromStdString(level.resolvedJson)).object();
            QVERIFY2(hasTextByLanguage(document), level.id.c_str());
            const QJsonObject task = withoutTexts(document);
            QVERIFY2(!hasTextByLanguage(task), level.id.c_str());
            for (const char* judged : {"parameters", "metrics", "gates", "cues", "number", "id",
                                       "needs_force"}) // all the rest stays
                QVERIFY2(task["level"].toObject()[QLatin1String(judged)] ==
                             document["level"].toObject()[QLatin1String(judged)],
                         judged);
            QCOMPARE(taskSha256(level.resolvedJson), sha256Hex(canonicalJson(task)));
        }
}

void TestContentTexts::aTextChangesNoTask() {
    const ContentCopy copy;
    const Catalogue before = loaded(copy);
    change(copy, kGerman, keysOf("levels/visible/objective"), "Ein anderer Text.");
    const Catalogue german = loaded(copy);
    change(copy, kLevel, {QStringLiteral("goal")}, "Another text.");
    change(copy, QStringLiteral("exercises/sphere_apex/exercise.json"), {QStringLiteral("objective")},
           "Another text.");
    const Catalogue english = loaded(copy);
    const auto level = [](const Catalogue& catalogue) -> const ExerciseLevel& {
        return *catalogue.find("sphere_apex", 1);
    };
    const auto texts = [](const Catalogue& catalogue, const char* language) {
        return catalogue.find("sphere_apex")->textsSha256.at(language);
    };
    QCOMPARE(taskSha256(level(german).resolvedJson), taskSha256(level(before).resolvedJson));
    QCOMPARE(taskSha256(level(english).resolvedJson), taskSha256(level(before).resolvedJson));
    QVERIFY(level(german).resolvedSha256 !=
            level(before).resolvedSha256); // what a session stores has the texts that were shown
    QVERIFY(texts(german, "de") != texts(before, "de"));
    QCOMPARE(texts(german, "en"), texts(before, "en"));
    QCOMPARE(texts(german, "el"), texts(before, "el"));
    QVERIFY(texts(english, "en") != texts(before, "en"));
    QCOMPARE(texts(english, "de"), texts(german, "de"));
}

void TestContentTexts::aNumberChangesTheTask() {
    const ContentCopy copy;
    const Catalogue before = loaded(copy);
    const auto task = [](const Catalogue& catalogue) {
        return taskSha256(catalogue.find("sphere_apex", 1)->resolvedJson);
    };
    const auto differs = [&](const QStringList& keys, const QJsonValue& value) {
        const QByteArray valid = copy.read(kLevel);
        change(copy, kLevel, keys, value);
        const Catalogue after = loaded(copy);
        copy.write(kLevel, valid);
        return task(after) != task(before) &&
               after.find("sphere_apex")->textsSha256 == before.find("sphere_apex")->textsSha256;
    };
    QVERIFY(differs(keysOf("parameters/radius_mm"), 21));                                         // felt
    QVERIFY(differs({QStringLiteral("feedback")}, !objectIn(copy, kLevel)["feedback"].toBool())); // told
    QJsonArray gates = objectIn(copy, kLevel)["gates"].toArray();
    QJsonObject gate = gates[0].toObject();
    gate["maximum"] = 11.5;
    gates[0] = gate;
    QVERIFY(differs({QStringLiteral("gates")}, gates)); // judged
    QCOMPARE(task(loaded(copy)), task(before));
}

// Content of users, and what was shipped before: each text in all its languages in the content file. What is
// stored with a session is the same.
void TestContentTexts::filesWithAllLanguagesAreReadAsBefore() {
    const ContentCopy copy;
    const Catalogue before = loaded(copy);
    const auto studies = StudyCatalogue::load(copy.directory());
    const QString schemas = copy.path(QStringLiteral("schema"));
    const auto inPlace = [&](const QString& folder, const QString& file, const char* schemaName,
                             const QStringList& place) {
        auto texts = ContentTexts::read(copy.path(folder), core::languageIds());
        const auto schema = readSchema(schemas, QLatin1String(schemaName));
        Problems problems;
        const QJsonObject json =
            texts->laid(objectIn(copy, file), *schema, place, file, QStringLiteral("$"), problems);
        copy.write(file, QJsonDocument(json).toJson());
    };
    for (const Exercise& exercise : before.exercises()) {
        const QString folder = QStringLiteral("exercises/") + QString::fromStdString(exercise.id);
        inPlace(folder, folder + QStringLiteral("/exercise.json"), "exercise", {QStringLiteral("exercise")});
        for (const ExerciseLevel& level : exercise.levels) {
            const QString id = QString::fromStdString(level.id);
            inPlace(folder, folder + QStringLiteral("/levels/") + id + QStringLiteral(".json"), "level",
                    {QStringLiteral("levels"), id});
        }
    }
    for (const auto& study : studies->studies()) {
        const QString id = QString::fromStdString(study.id);
        inPlace(QStringLiteral("studies"), QStringLiteral("studies/") + id + QStringLiteral(".json"), "study",
                {id});
    }
    QVERIFY(objectIn(copy, kLevel)["title"].toObject().contains("de"));
    for (const Exercise& exercise : before.exercises())
        QVERIFY(QDir(copy.path(QStringLiteral("exercises/") + QString::fromStdString(exercise.id) +
                               QStringLiteral("/texts")))
                    .removeRecursively());
    QVERIFY(QDir(copy.path(QStringLiteral("studies/texts"))).removeRecursively());
    const Catalogue after = loaded(copy);
    for (std::size_t i = 0; i < before.exercises().size(); ++i) {
        const Exercise& was = before.exercises()[i];
        const Exercise& is = after.exercises()[i];
        QVERIFY2(is.title == was.title && is.advice == was.advice, was.id.c_str());
        for (std::size_t n = 0; n < was.levels.size(); ++n) {
            QCOMPARE(is.levels[n].resolvedJson, was.levels[n].resolvedJson);
            QCOMPARE(is.levels[n].resolvedSha256, was.levels[n].resolvedSha256);
        }
        for (const std::string& language : core::languageIds())
            QVERIFY2(is.textsSha256.at(language) == was.textsSha256.at(language) ||
                         was.id == "urethra_insertion", // presets keep their file here, so this exercise's
                                                        // texts of them are gone
                     language.c_str());
    }
    const auto again = StudyCatalogue::load(copy.directory());
    QVERIFY2(again.has_value(), again ? "" : again.error().message.c_str());
    for (const auto& study : studies->studies())
        QCOMPARE(studyJson(*again->find(study.id)), studyJson(study));
}

void TestContentTexts::whatWasStoredBeforeHasTheTaskOfToday() {
    // As a program stored it whose content had two languages in its level files, other words, and no goal
    // yet.
    const ContentCopy copy;
    const ExerciseLevel today = *loaded(copy).find("sphere_apex", 2);
    QJsonObject document = QJsonDocument::fromJson(QByteArray::fromStdString(today.resolvedJson)).object();
    const QJsonObject words{{"en", "Earlier words."}, {"de", "Frühere Worte."}};
    for (const char* path : {"exercise/title", "exercise/objective", "level/title", "level/objective",
                             "level/measured", "level/shown_force_variant/note"})
        document = with(document, keysOf(path), words);
    document = with(document, keysOf("level/goal"), QJsonValue::Undefined);
    const auto stored = fromResolvedJson(canonicalJson(document));
    QVERIFY2(stored.has_value(), stored ? "" : stored.error().message.c_str());
    QCOMPARE(stored->title.at("de"),
             std::string("Frühere Worte.")); // it opens with the words it was done with,
    QCOMPARE(stored->resolvedSha256, sha256Hex(canonicalJson(document))); // its digest is what it was,
    QVERIFY(stored->resolvedSha256 != today.resolvedSha256);
    QCOMPARE(taskSha256(stored->resolvedJson), taskSha256(today.resolvedJson)); // and it was the same task
    QCOMPARE(taskSha256("{\"level\":3}"), std::string());
    QCOMPARE(taskSha256("no JSON"), std::string());
}

QTEST_APPLESS_MAIN(TestContentTexts)
#include "test_content_texts.moc"
