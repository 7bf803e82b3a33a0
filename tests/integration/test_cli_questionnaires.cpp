// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"
#include "raw_database.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

// Questionnaires on paper: template, filled, imported, summarised, exported; what is refused, and that a
// refused or broken import leaves nothing behind.
class TestCliQuestionnaires : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void templateFilledImportedSummarisedExported();
    void theSameFileTwiceAddsNothing();
    void jsonTemplateIsAFileToo();
    void refusals_data();
    void refusals();
    void allFaultsAtOnce();
    void performanceGoesWithAnswers();
    void halfWayLeavesNothing();
    void onlyThoseWhoMay();
    void workloadIsOfEachCondition();

private:
    CliRun as(const QString& name, const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", m_database, "--as", name, "--json"}, {},
                      {{"CHIRON_PASSWORD", "correct horse battery"},
                       {"CHIRON_NEW_PASSWORD", "correct horse battery"},
                       {"CHIRON_IDENTITY", "Ada"}});
    }
    QJsonObject done(const QStringList& arguments) {
        const CliRun run = as("rosa", arguments);
        if (run.exitCode != 0)
            qWarning("%s", run.err.constData());
        return QJsonDocument::fromJson(run.out).object();
    }
    CliRun import(const QByteArray& file, const QStringList& more = {}) {
        QFile out(m_folder.filePath("given.csv"));
        if (!out.open(QIODevice::WriteOnly) || out.write(file) != file.size())
            qFatal("the test's own file could not be written");
        out.close();
        return as("rosa", QStringList{"study", "questionnaire", "import", "surgeons", out.fileName()} + more);
    }
    QByteArray fileIn(const QString& path) {
        QFile file(m_folder.filePath(path));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QString enrolled(bool consents = true) {
        const QString code = done({"study", "enrol", "surgeons"})["code"].toString();
        if (consents)
            done({"study", "consent", "surgeons", "--participant", code});
        return code;
    }
    int stored() {
        const auto raw = RawDatabase::open(m_database, RawDatabase::Mode::read);
        return static_cast<int>(raw->integer("SELECT count(*) FROM questionnaire_answer").value_or(-1));
    }

    QTemporaryDir m_folder;
    QString m_database;
    QStringList m_codes; ///< three who consented
};

namespace {

const QByteArray kHeading =
    "participant,content_validity.skill_relevant,content_validity.teaches,content_validity.covers,content_"
    "validity.assess,content_validity.recommend,content_validity.remarks\n";

QJsonObject withId(const QJsonArray& array, const QString& key, const QString& id) {
    for (const QJsonValue& each : array)
        if (each[key].toString() == id)
            return each.toObject();
    return {};
}

} // namespace

void TestCliQuestionnaires::initTestCase() {
    QVERIFY(m_folder.isValid());
    m_database = m_folder.filePath("site.db");
    QCOMPARE(runCli({"init", "--admin", "alice", "--database", m_database}, {},
                    {{"CHIRON_PASSWORD", "correct horse battery"}})
                 .exitCode,
             0);
    QCOMPARE(as("alice", {"user", "add", "rosa", "--role", "researcher"}).exitCode, 0);
    QCOMPARE(as("alice", {"user", "add", "tim", "--role", "trainee"}).exitCode, 0);
    QCOMPARE(as("rosa", {"study", "new", "surgeons"}).exitCode, 0);
    const QString draft = refusalFault(as("rosa", {"study", "questionnaire", "template", "surgeons", "--out",
                                                   m_folder.filePath("draft.csv")}),
                                       2, {"draft"});
    QVERIFY2(draft.isEmpty(), qPrintable(draft));
    QCOMPARE(as("rosa", {"study", "freeze", "surgeons"}).exitCode, 0);
    for (int i = 0; i < 3; ++i)
        m_codes << enrolled();
    QVERIFY(!m_codes.contains(QString()));
}

// What the template asks is what import takes, also after a spreadsheet has had it: semicolons, quoted notes,
// lines within a cell.
void TestCliQuestionnaires::templateFilledImportedSummarisedExported() {
    const QString path = m_folder.filePath("template.csv");
    const QJsonObject made = done({"study", "questionnaire", "template", "surgeons", "--out", path,
                                   "--questionnaire", "content_validity,face_validity"});
    QCOMPARE(made["participants"].toInt(), 3);
    QCOMPARE(made["questionnaires"].toArray().size(), 2);
    QVERIFY(!as("rosa", {"study", "questionnaire", "template", "surgeons", "--out", path})
                 .out.contains("surgeons")); // never over a file
    QStringList lines = QString::fromUtf8(fileIn("template.csv")).trimmed().split(u'\n');
    QCOMPARE(lines.filter(QRegularExpression("^\"# (content|face)_validity\\.")).size(), 12);
    for (int i = 0; i < 3; ++i) {
        const qsizetype row = lines.size() - 3 + i;
        QVERIFY(m_codes.contains(lines[row].section(u',', 0, 0)));
        lines[row] = lines[row].section(u',', 0, 0) +
                     QStringLiteral(",%1,3,4,5,4,5,4,3,2,5,\"Größe, \"\"Gewicht\"\"\nund Ton\",").arg(i + 3);
    }
    const CliRun first = import((lines.join("\r\n") + "\r\n,,,,,,,,,,,,\r\n").toUtf8());
    QVERIFY2(first.exitCode == 0, first.err.constData());
    QCOMPARE(QJsonDocument::fromJson(first.out).object(),
             (QJsonObject{{"study", "surgeons"}, {"stored", 33}, {"unchanged", 0}, {"participants", 3}}));
    const QJsonArray told =
        done({"study", "questionnaire", "summary", "surgeons", "--texts"})["questionnaires"].toArray();
    const QJsonObject real =
        withId(withId(told, "id", "face_validity")["likert"].toArray(), "item", "stiffness_real");
    QCOMPARE(real["counts"].toArray(), (QJsonArray{0, 0, 1, 1, 1}));
    QCOMPARE(real["median"].toDouble(), 4.0);
    QCOMPARE(
        withId(withId(told, "id", "content_validity")["likert"].toArray(), "item", "recommend")["agreement"]
            .toDouble(),
        1.0);
    QCOMPARE(withId(told, "id", "background")["replies"].toInt(-1), 0);
    const QJsonObject words =
        withId(withId(told, "id", "content_validity")["texts"].toArray(), "item", "missing");
    QCOMPARE(words["answers"].toArray().at(0).toString(), QStringLiteral("Größe, \"Gewicht\"\nund Ton"));
    QVERIFY(!as("rosa", {"study", "questionnaire", "summary", "surgeons"})
                 .out.contains("Gewicht")); // only when asked for
    QCOMPARE(done({"study", "export", "surgeons", "--out", m_folder.filePath("csv")})["study"].toString(),
             QStringLiteral("surgeons"));
    QCOMPARE(fileIn("csv/questionnaires.csv").count("face_validity,stiffness_real,face,likert,"), 3);
    QCOMPARE(as("alice", {"verify"}).exitCode, 0);
}

void TestCliQuestionnaires::theSameFileTwiceAddsNothing() {
    const QString code = enrolled();
    const QByteArray file = kHeading + code.toUtf8() + ",4,4,4,4,4,so\n";
    QCOMPARE(import(file).exitCode, 0);
    const int before = stored();
    const CliRun again = import(file);
    QVERIFY2(again.exitCode == 0, again.err.constData());
    QCOMPARE(QJsonDocument::fromJson(again.out).object()["stored"].toInt(-1), 0);
    QCOMPARE(QJsonDocument::fromJson(again.out).object()["unchanged"].toInt(), 6);
    const QString other =
        refusalFault(import(kHeading + code.toUtf8() + ",4,4,4,4,5,so\n"), 3,
                     {"given.csv:2: column content_validity.recommend", "another answer is stored"});
    QVERIFY2(other.isEmpty(), qPrintable(other));
    QCOMPARE(stored(), before);
}

void TestCliQuestionnaires::jsonTemplateIsAFileToo() {
    const QString path = m_folder.filePath("template.json");
    QCOMPARE(done({"study", "questionnaire", "template", "surgeons", "--format", "json", "--out", path,
                   "--questionnaire", "background", "--language", "de"})["participants"]
                 .toInt(),
             4);
    QJsonObject root = QJsonDocument::fromJson(fileIn("template.json")).object();
    QVERIFY(root["questions"]
                .toObject()["background"]
                .toObject()["hand"]
                .toObject()["answer"]
                .toString()
                .contains("Beiden", Qt::CaseInsensitive));
    QJsonArray participants = root["participants"].toArray();
    QJsonObject first = participants[0].toObject();
    const QJsonObject filled{
        {"years_of_surgery", 7.5}, {"laparoscopies", "11 bis 50"}, {"hand", "right"}, {"simulators", 1}};
    QJsonObject answers = first["answers"].toObject();
    QJsonObject given = answers["background"].toObject();
    for (const QString& key : given.keys())
        given[key] = filled[key];
    first["answers"] = QJsonObject{{"background", given}};
    participants[0] = first;
    root["participants"] = participants;
    const CliRun run = import(QJsonDocument(root).toJson());
    QVERIFY2(run.exitCode == 0, run.err.constData());
    QCOMPARE(QJsonDocument::fromJson(run.out).object()["stored"].toInt(), static_cast<int>(given.size()));
    const QJsonObject told = withId(done({"study", "questionnaire", "summary", "surgeons", "--questionnaire",
                                          "background"})["questionnaires"]
                                        .toArray(),
                                    "id", "background");
    QCOMPARE(withId(told["numbers"].toArray(), "item", "laparoscopies")["choice_counts"].toArray(),
             (QJsonArray{0, 0, 1, 0, 0}));
    QCOMPARE(withId(told["numbers"].toArray(), "item", "years_of_surgery")["mean"].toDouble(), 7.5);
    root["design_sha256"] = "other";
    const QString fault = refusalFault(import(QJsonDocument(root).toJson()), 3, {"$.design_sha256", "other"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

void TestCliQuestionnaires::refusals_data() {
    QTest::addColumn<QByteArray>("file"); // X: a participant who has answered nothing
    QTest::addColumn<QStringList>("mentions");
    const QByteArray good = "X,1,2,3,4,5,\n";
    QTest::newRow("empty") << QByteArray() << QStringList{"given.csv:1", "empty"};
    QTest::newRow("no rows") << kHeading << QStringList{"given.csv", "no rows"};
    QTest::newRow("unknown question")
        << QByteArray("participant,face_validity.taste\nX,4\n")
        << QStringList{"given.csv:1: heading", "face_validity.taste", "face_validity.stiffness_real"};
    QTest::newRow("a column is missing")
        << QByteArray("participant,content_validity.teaches\nX,4\n")
        << QStringList{"given.csv:1: heading",
                       "no column content_validity.skill_relevant, content_validity.covers", "--incomplete"};
    QTest::newRow("no participants") << QByteArray("content_validity.teaches\n4\n")
                                     << QStringList{"given.csv:1: heading", "no column participant"};
    QTest::newRow("above the scale") << kHeading + "X,1,2,6,4,5,\n"
                                     << QStringList{"given.csv:2: column content_validity.covers", "\"6\"",
                                                    "whole number from 1 (Not at all) to 5 (Completely)"};
    QTest::newRow("below the scale") << kHeading + "X,0,2,3,4,5,\n"
                                     << QStringList{"given.csv:2: column content_validity.skill_relevant",
                                                    "\"0\""};
    QTest::newRow("between") << kHeading + "X,1,2,3,4.5,5,\n"
                             << QStringList{"given.csv:2: column content_validity.assess", "\"4.5\""};
    QTest::newRow("words for a number")
        << kHeading + "X,1,two,3,4,5,\n"
        << QStringList{"given.csv:2: column content_validity.teaches", "\"two\""};
    QTest::newRow("nobody") << kHeading + "ZZZ-ZZZ,1,2,3,4,5,\n" << QStringList{"given.csv:2", "ZZZ-ZZZ"};
    QTest::newRow("no code") << kHeading + ",1,2,3,4,5,\n"
                             << QStringList{"given.csv:2: column participant", "empty"};
    QTest::newRow("twice in one file") << kHeading + good + good.left(good.indexOf(',')) + ",1,,,,,\n"
                                       << QStringList{"given.csv:3", "answered already at", "given.csv:2"};
    QTest::newRow("not answered") << kHeading + "X,1,2,,4,5,\n"
                                  << QStringList{"given.csv:2: column content_validity.covers", "empty",
                                                 "--incomplete"};
    QTest::newRow("short row") << kHeading + "X,1,2\n" << QStringList{"given.csv:2", "3 cells; expected 7"};
    QTest::newRow("open quote") << kHeading + "X,1,2,3,4,5,\"oh\n" << QStringList{"given.csv:2", "quote"};
    QTest::newRow("Latin-1") << kHeading + good + "X,,,,,,gr\xfc\xdf\n"
                             << QStringList{"given.csv:3", "UTF-8"};
    QTest::newRow("UTF-16") << QByteArray("\xff\xfep\0a\0", 6)
                            << QStringList{"given.csv:1", "UTF-16", "UTF-8"};
    QTest::newRow("JSON cut off") << QByteArray("{\"participants\": [")
                                  << QStringList{"given.csv:1", "expected"};
    QTest::newRow("JSON: key twice") << QByteArray("{\"participants\": [], \"participants\": []}")
                                     << QStringList{"participants", "twice"};
    QTest::newRow("JSON: unknown question")
        << QByteArray(
               R"({"participants": [{"participant": "X", "answers": {"face_validity": {"taste": 4}}}]})")
        << QStringList{"$.participants[0].answers.face_validity", "taste"};
    QTest::newRow("JSON: out of scale")
        << QByteArray(
               R"({"participants": [{"participant": "X", "answers": {"face_validity": {"handle_real": 7}}}]})")
        << QStringList{"$.participants[0].answers.face_validity.handle_real", "7", "from 1"};
    QTest::newRow("JSON: true")
        << QByteArray(
               R"({"participants": [{"participant": "X", "answers": {"content_validity": {"remarks": true}}}]})")
        << QStringList{"$.participants[0].answers.content_validity.remarks", "words"};
}

void TestCliQuestionnaires::refusals() {
    QFETCH(QByteArray, file);
    QFETCH(QStringList, mentions);
    static const QByteArray nobodyYet = enrolled().toUtf8();
    const int before = stored();
    const QString fault = refusalFault(
        import(file.replace("X,", nobodyYet + ',').replace("\"X\"", '"' + nobodyYet + '"')), 3, mentions);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    QCOMPARE(stored(), before);
}

void TestCliQuestionnaires::allFaultsAtOnce() {
    const QByteArray who = enrolled().toUtf8();
    const CliRun run = import(kHeading + who + ",9,8,7,4,5,\nZZZ-ZZZ,1,2,3,4,5,\n");
    QCOMPARE(run.exitCode, 3);
    QCOMPARE(run.err.count("given.csv:2: column"), 3);
    QCOMPARE(run.err.count("given.csv:3:"), 1);
    const CliRun paper =
        import(kHeading + who + ",1,,,,,\n", {"--incomplete"}); // left out on paper: kept as left out
    QVERIFY2(paper.exitCode == 0, paper.err.constData());
    QCOMPARE(QJsonDocument::fromJson(paper.out).object()["stored"].toInt(), 1);
}

// Who feels finer finds the stiffness more real here, and the weight less: the order of answers and that of
// results agree, or are opposite. Only where asked for, and nothing while the study is blinded.
void TestCliQuestionnaires::performanceGoesWithAnswers() {
    const QString database = m_folder.filePath("performance.db");
    const auto rosa = [&](const QStringList& arguments) {
        const CliRun run = runCli(
            arguments + QStringList{"--database", database, "--as", "rosa", "--json"}, {},
            {{"CHIRON_PASSWORD", "correct horse battery"}, {"CHIRON_NEW_PASSWORD", "correct horse battery"}});
        if (run.exitCode != 0)
            qWarning("%s", run.err.constData());
        return QJsonDocument::fromJson(run.out).object();
    };
    QCOMPARE(runCli({"init", "--admin", "alice", "--database", database}, {},
                    {{"CHIRON_PASSWORD", "correct horse battery"}})
                 .exitCode,
             0);
    QCOMPARE(runCli({"user", "add", "rosa", "--role", "researcher", "--database", database, "--as", "alice"},
                    {},
                    {{"CHIRON_PASSWORD", "correct horse battery"},
                     {"CHIRON_NEW_PASSWORD", "correct horse battery"}})
                 .exitCode,
             0);
    rosa({"study", "new", "surgeons"});
    rosa({"study", "freeze", "surgeons"});
    QByteArray file = "participant,face_validity.stiffness_real,face_validity.weight_real,face_validity."
                      "surface_real,face_validity.no_disturbance,face_validity.handle_real\n";
    const QStringList webers{"0.03", "0.1", "0.3", "0.9"};
    for (int i = 0; i < webers.size(); ++i) {
        const QString code = QStringLiteral("S0%1").arg(i + 1);
        QVERIFY(!rosa({"study", "run", "surgeons", "--participant", code, "--observer", "weber:" + webers[i],
                       "--quick", "--seed", QString::number(i + 1)})
                     .isEmpty());
        file +=
            code.toLatin1() + ',' + QByteArray::number(5 - i) + ',' + QByteArray::number(1 + i) + ",3,3,3\n";
    }
    QFile given(m_folder.filePath("performance.csv"));
    QVERIFY(given.open(QIODevice::WriteOnly) && given.write(file) == file.size());
    given.close();
    QCOMPARE(rosa({"study", "questionnaire", "import", "surgeons", given.fileName()})["participants"].toInt(),
             4);
    const auto tau = [&](const QString& item, const QStringList& more) -> QJsonValue {
        const QJsonArray told =
            rosa(QStringList{"study", "questionnaire", "summary", "surgeons"} + more)["questionnaires"]
                .toArray();
        return withId(withId(told, "id", "face_validity")["likert"].toArray(), "item", item)["performance"]
            .toObject()["tau"];
    };
    QVERIFY(
        !tau("stiffness_real", {"--performance"}).isDouble()); // tables differ: blinded, no run has a result
    rosa({"study", "unblind", "surgeons", "--reason", "all are done"});
    QVERIFY(!tau("stiffness_real", {}).isDouble());
    QCOMPARE(tau("stiffness_real", {"--performance"}).toDouble(), 1.0);
    QCOMPARE(tau("weight_real", {"--performance"}).toDouble(), -1.0);
    QVERIFY(!tau("surface_real", {"--performance"}).isDouble()); // one answer of everybody goes with nothing
}

// The database refuses the fourth answer: the three before it are gone, too, and so are their lines of the
// audit.
void TestCliQuestionnaires::halfWayLeavesNothing() {
    const QByteArray who = enrolled().toUtf8();
    const int before = stored();
    const auto execute = [&](const char* sql) {
        const auto raw = RawDatabase::open(m_database, RawDatabase::Mode::write);
        return raw && raw->execute(sql);
    };
    QVERIFY(execute("CREATE TRIGGER full_disk BEFORE INSERT ON questionnaire_answer WHEN NEW.item = 'assess' "
                    "BEGIN SELECT RAISE(ABORT, 'no room'); END"));
    const QByteArray file = kHeading + who + ",1,2,3,4,5,\n";
    const CliRun broken = import(file);
    QVERIFY(execute("DROP TRIGGER full_disk"));
    QCOMPARE(broken.exitCode, 4);
    QCOMPARE(stored(), before);
    QCOMPARE(as("alice", {"verify"}).exitCode, 0);
    QCOMPARE(import(file).exitCode, 0);
    QCOMPARE(stored(), before + 5);
}

void TestCliQuestionnaires::onlyThoseWhoMay() {
    const QString unasked = enrolled(false);
    const QString gone = enrolled();
    done({"study", "withdraw", "surgeons", "--participant", gone});
    const int before = stored();
    for (const auto& [code, mention] : {std::pair{unasked, "consent"}, {gone, "withdrawn"}}) {
        const CliRun run = import(kHeading + code.toUtf8() + ",1,2,3,4,5,\n");
        QVERIFY2(run.exitCode != 0 && run.err.contains(mention), run.err.constData());
    }
    const QString path = m_folder.filePath("given.csv");
    QCOMPARE(as("tim", {"study", "questionnaire", "import", "surgeons", path}).exitCode, 2);
    QCOMPARE(as("tim", {"study", "questionnaire", "summary", "surgeons"}).exitCode, 2);
    QCOMPARE(
        runCli({"study", "questionnaire", "import", "surgeons", path, "--database", m_database}).exitCode,
        2); // nobody
    QCOMPARE(stored(), before);
}

/// NASA-TLX after each of two conditions: asked, stored, summarised, scored and exported by condition, with
/// the language of the forms.
void TestCliQuestionnaires::workloadIsOfEachCondition() {
    const auto contentOf = [](const char* path) {
        QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content/") + QLatin1String(path));
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                              : QJsonObject();
    };
    QJsonObject design = contentOf("studies/stiffness_elastic_tube.json");
    QJsonObject workload = contentOf("instruments/nasa_tlx.json")["questionnaire"].toObject();
    workload["when"] = "after_condition";
    QJsonArray items = workload["items"].toArray();
    for (QJsonValueRef item : items) { // a study's file has each text in all its languages itself
        QJsonObject asked = item.toObject();
        asked["text"] = QJsonObject{{"en", asked["text"]}, {"de", QStringLiteral("Auf Deutsch")}};
        item = asked;
    }
    workload["items"] = items;
    QJsonArray conditions = design["conditions"].toArray();
    QJsonObject again = conditions[0].toObject();
    again["id"] = "tube_again";
    conditions.append(again);
    design["id"] = "tlx";
    design["conditions"] = conditions;
    design["questionnaires"] = QJsonArray{workload};
    QFile out(m_folder.filePath("tlx.json"));
    QVERIFY(out.open(QIODevice::WriteOnly) && out.write(QJsonDocument(design).toJson()) > 0);
    out.close();
    QCOMPARE(done({"study", "new", out.fileName()})["state"].toString(), QStringLiteral("draft"));
    QCOMPARE(done({"study", "freeze", "tlx"})["sha256"].toString().size(), 64);
    QVERIFY(!done({"study", "run", "tlx", "--participant", "S1", "--observer", "weber:0.1", "--quick",
                   "--condition", "tube_60"})
                 .isEmpty());
    const QString path = m_folder.filePath("tlx.csv");
    QCOMPARE(
        done({"study", "questionnaire", "template", "tlx", "--out", path, "--language", "de"})["participants"]
            .toInt(),
        1);
    QStringList lines = QString::fromUtf8(fileIn("tlx.csv")).trimmed().split(u'\n');
    QCOMPARE(lines[lines.size() - 2].count(QStringLiteral("nasa_tlx@tube_60.")), 6);
    QCOMPARE(lines[lines.size() - 2].count(QStringLiteral("nasa_tlx@tube_again.")), 6);
    const auto imported = [&](const QString& cells, const QStringList& more = {}) {
        QFile filled(path);
        if (!filled.open(QIODevice::WriteOnly | QIODevice::Truncate) ||
            filled.write(
                (QStringList(lines.mid(0, lines.size() - 1)) << "S1," + cells).join(u'\n').toUtf8()) <= 0)
            qFatal("the test's own file could not be written");
        filled.close();
        return as("rosa", QStringList{"study", "questionnaire", "import", "tlx", path} + more);
    };
    const CliRun notDone = imported("21,21,21,21,21,21,1,1,1,1,1,1"); // a line for each answer
    QVERIFY2(notDone.exitCode == 3 &&
                 notDone.err.count("condition tube_again is not completed by participant S1") == 6,
             notDone.err.constData());
    const QString foreign =
        refusalFault(imported("21,21,21,21,21,21,,,,,,", {"--language", "xx"}), 2, {"xx"});
    QVERIFY2(foreign.isEmpty(), qPrintable(foreign));
    QVERIFY(!done({"study", "run", "tlx", "--participant", "S1", "--observer", "weber:0.1", "--quick"})
                 .isEmpty());
    const CliRun whole = imported("21,21,21,21,21,21,1,1,1,1,1,1", {"--language", "de"});
    QVERIFY2(whole.exitCode == 0, whole.err.constData());
    QCOMPARE(QJsonDocument::fromJson(whole.out)["stored"].toInt(), 12);
    const QJsonArray told = done({"study", "questionnaire", "summary", "tlx"})["questionnaires"].toArray();
    QCOMPARE(told.size(), 2);
    for (const auto& [condition, median] : {std::pair{"tube_60", 21.0}, {"tube_again", 1.0}})
        QCOMPARE(withId(withId(told, "condition", QLatin1String(condition))["likert"].toArray(), "item",
                        "effort")["median"]
                     .toDouble(),
                 median);
    QVERIFY(!done({"study", "export", "tlx", "--format", "csv,bids", "--out", m_folder.filePath("tlx")})
                 .isEmpty());
    const QByteArray scores = fileIn("tlx/csv/scores.csv");
    QVERIFY2(scores.contains("nasa_tlx,nasa_tlx_raw,workload,100,tube_60") &&
                 scores.contains("nasa_tlx,nasa_tlx_raw,workload,0,tube_again"),
             scores.constData());
    const QByteArray answers = fileIn("tlx/csv/questionnaires.csv");
    QCOMPARE(answers.count(",tube_60,de"), 6);
    QCOMPARE(answers.count(",tube_again,de"), 6);
    const QList<QByteArray> table = fileIn("tlx/bids/phenotype/nasa_tlx.tsv").trimmed().split('\n');
    QCOMPARE(table.size(), 2); // one line: BIDS has one a participant
    const QByteArrayList heads = table[0].split('\t'), cells = table[1].split('\t');
    QCOMPARE(cells.size(), heads.size());
    const auto cell = [&](const char* name) {
        return heads.contains(name) ? cells[heads.indexOf(name)] : QByteArray(name);
    };
    QCOMPARE(cell("effort_tube_60"), QByteArray("21"));
    QCOMPARE(cell("effort_tube_again"), QByteArray("1"));
    QCOMPARE(cell("score_workload_tube_60"), QByteArray("100"));
    QCOMPARE(cell("language_shown_tube_again"), QByteArray("de"));
    QCOMPARE(as("alice", {"verify"}).exitCode, 0);
}

QTEST_GUILESS_MAIN(TestCliQuestionnaires)
#include "test_cli_questionnaires.moc"
