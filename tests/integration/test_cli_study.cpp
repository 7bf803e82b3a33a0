// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

// The study commands from outside: a study done by simulated participants in a database that is not there
// before, with and without rendering, gone on with, run again, exported; what is refused and why.
class TestCliStudy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void runPrintsTheContract();
    void theSameSeedIsTheSameRun();
    void aRunIsGoneOnWith();
    void renderedTrialsAreRecorded();
    void rerunIsIdentical();
    void analyseTellsEachRun();
    void listAndShowTellOfIt();
    void planNeedsNoDatabase();
    void planOfAComparisonHasItsAssumptionsAsInputs();
    void planOfNoRunsIsInformationAlone();
    void planTellsWhyNoSpacingIsBest();
    void exportHoldsTheFrozenDesign();
    void bidsHoldsMotion();
    void draftIsFrozenByAResearcher();
    void refusals_data();
    void refusals();

private:
    CliRun cli(const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", m_database, "--json"});
    }
    CliRun quick(const QString& participant, const QStringList& more = {}) {
        return cli(QStringList{"study", "run", kStudy, "--participant", participant, "--observer",
                               "weber:0.12,lapse:0.02", "--seed", "1", "--quick"} +
                   more);
    }
    QByteArray fileIn(const QString& path) {
        QFile file(m_folder.filePath(path));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    inline static const QString kStudy = QStringLiteral("stiffness_elastic_tube");
    QTemporaryDir m_folder;
    QString m_database;
};

namespace {

QJsonObject object(const CliRun& run) {
    if (run.exitCode != 0)
        qWarning("%s", run.err.constData());
    return QJsonDocument::fromJson(run.out).object();
}

int scored(const QJsonArray& trials) {
    int count = 0;
    for (const QJsonValue& trial : trials)
        count += !trial["practice"].toBool() && trial["spoiled"].toString().isEmpty() ? 1 : 0;
    return count;
}

} // namespace

// `study run` makes the database, the frozen study and the participant.
void TestCliStudy::initTestCase() {
    QVERIFY(m_folder.isValid());
    m_database = m_folder.filePath("study.db");
    QCOMPARE(quick("S01").exitCode, 0);
    QVERIFY(QFile::exists(m_database));
}

void TestCliStudy::runPrintsTheContract() {
    const QJsonObject run = object(quick("S01")); // done already: told again
    QCOMPARE(run["sha256"].toString().size(), 64);
    QCOMPARE(run["participant"].toString(), QStringLiteral("S01"));
    const QJsonArray trials = run["trials"].toArray();
    QVERIFY2(scored(trials) >= 20, qPrintable(QString::number(scored(trials))));
    for (const char* key : {"ordinal", "practice", "spoiled", "candidate", "arrangement", "difference",
                            "values", "answer", "outcome", "entropy_margin"})
        QVERIFY2(trials.last().toObject().contains(QLatin1String(key)), key);
    const QJsonObject estimate = run["estimate"].toObject();
    for (const char* key : {"weber", "jnd", "sigma_log10", "ci_low", "ci_high", "criterion"})
        QVERIFY2(estimate[QLatin1String(key)].isDouble(), key);
    QCOMPARE(estimate["unit"].toString(), QStringLiteral("N/m"));
    const double weber = estimate["weber"].toDouble();
    QVERIFY(weber > 0.0 && estimate["ci_low"].toDouble() < weber && weber < estimate["ci_high"].toDouble());
    QCOMPARE(run["runs"].toArray().size(), 1);
    QVERIFY(run["runs"][0]["completed"].toBool());
}

void TestCliStudy::theSameSeedIsTheSameRun() {
    const QString elsewhere = m_folder.filePath("again.db");
    const QJsonObject again =
        object(runCli({"study", "run", kStudy, "--participant", "S01", "--observer", "weber:0.12,lapse:0.02",
                       "--seed", "1", "--quick", "--database", elsewhere, "--json"}));
    const QJsonObject first = object(quick("S01"));
    QCOMPARE(again["sha256"], first["sha256"]);
    QCOMPARE(again["trials"], first["trials"]);
    QCOMPARE(again["estimate"], first["estimate"]);
}

// Broken off after ten and gone on with, a run is what it would have been without.
void TestCliStudy::aRunIsGoneOnWith() {
    const QJsonObject part = object(quick("S02", {"--trials", "10"}));
    QVERIFY(!part["runs"][0]["completed"].toBool(true));
    const QJsonArray before = part["trials"].toArray();
    QCOMPARE(before.size(), 10);
    QCOMPARE(refusalFault(cli({"study", "run", kStudy, "--participant", "S02", "--observer",
                               "weber:0.12,lapse:0.02", "--seed", "2", "--quick"}),
                          2, {"seed"}),
             QString());
    const QJsonObject whole = object(quick("S02"));
    const QJsonArray after = whole["trials"].toArray();
    QVERIFY(whole["runs"][0]["completed"].toBool());
    QVERIFY(after.size() > before.size());
    for (qsizetype i = 0; i < before.size(); ++i)
        QCOMPARE(after[i], before[i]);
    QCOMPARE(object(quick("S02")), whole); // completed: nothing is added
    QCOMPARE(refusalFault(cli({"study", "run", kStudy, "--participant", "S02", "--observer",
                               "weber:0.12,lapse:0.02", "--seed", "2", "--quick"}),
                          2, {"every run", "seed"}),
             QString());
    QCOMPARE(whole["device"], QJsonValue(QJsonValue::Null));
}

void TestCliStudy::renderedTrialsAreRecorded() {
    const QJsonObject run = object(cli({"study", "run", kStudy, "--participant", "S03", "--observer",
                                        "weber:0.12", "--seed", "3", "--trials", "2"}));
    QVERIFY(run["device"]["delay_measured"].toBool());
    QVERIFY(run["device"]["stiffness_cap_N_per_m"].toDouble() > 2000.0 &&
            run["device"]["stiffness_cap_N_per_m"].toDouble() < 4000.0);
    const QJsonArray trials = run["trials"].toArray();
    QCOMPARE(trials.size(), 2);
    for (const QJsonValue& trial : trials) {
        QVERIFY(trial["session_id"].toInt() > 0);
        QVERIFY2(trial["fidelity"].toObject().contains("peak_force_N"),
                 qPrintable(QString::fromUtf8(QJsonDocument(trial.toObject()).toJson())));
        QCOMPARE(trial["values"].toArray().size(), 3);
    }
    const QString session = QString::number(trials[0]["session_id"].toInt());
    QCOMPARE(cli({"replay", session}).exitCode, 0);
    QCOMPARE(cli({"verify"}).exitCode, 0);
    QCOMPARE(cli({"session", "export", session, "--format", "bids", "--folder", m_folder.filePath("session")})
                 .exitCode,
             0);
    QVERIFY(
        QFile::exists(m_folder.filePath("session/session_" + session + ".bids/dataset_description.json")));
}

void TestCliStudy::rerunIsIdentical() {
    const CliRun run = cli({"study", "rerun", kStudy});
    QCOMPARE(run.exitCode, 0);
    const QJsonObject again = object(run);
    QVERIFY(again["identical"].toBool());
    QCOMPARE(again["runs"].toArray().size(), 3);
    for (const QJsonValue& each : again["runs"].toArray())
        QVERIFY(each["trials"].toInt() > 0 &&
                each["same"].toInt() + each["ties"].toInt() == each["trials"].toInt());
}

void TestCliStudy::analyseTellsEachRun() {
    const QJsonObject analysis = object(cli({"study", "analyse", kStudy}));
    QCOMPARE(analysis["runs"].toArray().size(), 3);
    const QJsonObject first = analysis["runs"][0].toObject();
    QCOMPARE(first["participant"].toString(), QStringLiteral("S01"));
    const QJsonObject run = object(quick("S01"));
    QCOMPARE(first["estimate"].toObject()["weber"], run["estimate"].toObject()["weber"]);
}

void TestCliStudy::listAndShowTellOfIt() {
    const QJsonArray studies = object(cli({"study", "list"}))["studies"].toArray();
    QCOMPARE(studies.size(), 1);
    QCOMPARE(studies[0]["key"].toString(), kStudy);
    QCOMPARE(studies[0]["state"].toString(), QStringLiteral("frozen"));
    QCOMPARE(studies[0]["participants"].toInt(), 3);
    const QJsonObject shown = object(cli({"study", "show", QString::number(studies[0]["id"].toInt())}));
    QCOMPARE(shown["sha256"], studies[0]["sha256"]);
    QCOMPARE(shown["design"]["id"].toString(), kStudy);
    for (const QJsonValue& participant : shown["participant_list"].toArray())
        QVERIFY(participant["simulated"].toBool() &&
                participant["observer"].toString().startsWith("weber:0.12"));
}

void TestCliStudy::planNeedsNoDatabase() {
    const QJsonObject plan =
        object(runCli({"study", "plan", kStudy, "--observer", "weber:0.12,lapse:0.02", "--runs", "5",
                       "--database", m_folder.filePath("none.db"), "--json"}));
    const QJsonObject condition = plan["conditions"][0].toObject();
    for (const char* key :
         {"bias_log10", "sd_log10", "coverage", "trials", "minutes", "information_per_trial"})
        QVERIFY2(condition[QLatin1String(key)].isDouble(), key);
    QVERIFY(plan["minutes"].toDouble() > 0.0);
    for (const char* key :
         {"bias_log10_error", "sd_log10_error", "coverage_error", "trials_error", "minutes_error"})
        QVERIFY2(condition[QLatin1String(key)].toDouble() > 0.0, key);
    QVERIFY(condition["weber_quantiles"]["0.1"].toDouble() <= condition["weber_quantiles"]["0.5"].toDouble());
    for (const char* share : {"0.1", "0.5", "0.9"})
        QVERIFY2(condition["weber_quantiles_error"][QLatin1String(share)].toDouble() > 0.0, share);
    QCOMPARE(plan["minutes_error"].toDouble(), condition["minutes_error"].toDouble()); // it has one condition
    const QJsonObject one =
        object(runCli({"study", "plan", kStudy, "--observer", "weber:0.12,lapse:0.02", "--runs", "1",
                       "--database", m_folder.filePath("none.db"), "--json"}));
    QVERIFY(one["conditions"][0]["trials"].isDouble() &&
            one["conditions"][0]["minutes"].isDouble()); // a single run has a length, too
    QVERIFY(!QFile::exists(m_folder.filePath("none.db")));
}

void TestCliStudy::planOfAComparisonHasItsAssumptionsAsInputs() {
    const auto plan = [&](const QStringList& more) {
        return object(runCli(QStringList{"study", "plan", kStudy, "--observer", "weber:0.12,lapse:0.02",
                                         "--runs", "5", "--power", "--database", m_folder.filePath("none.db"),
                                         "--json"} +
                             more))["conditions"][0]["power"]
            .toObject();
    };
    const QJsonObject paired = plan({"--paired", "--participants", "10", "--ratio", "1.3"});
    const QJsonObject strict = plan({"--participants", "10", "--alpha", "0.001"}),
                      groups = plan({"--unpaired", "--participants", "10", "--between-sd", "0.3"});
    QVERIFY(paired["paired"].toBool() && strict["paired"].toBool() && !groups["paired"].toBool());
    QCOMPARE(groups["between_sd_log10"].toDouble(), 0.3);
    QVERIFY(paired["detectable_ratio"].toDouble() > 1.0 && paired["detectable_ratio_error"].toDouble() > 0.0);
    QVERIFY(strict["detectable_ratio"].toDouble() > paired["detectable_ratio"].toDouble() &&
            groups["detectable_ratio"].toDouble() > paired["detectable_ratio"].toDouble());
    QVERIFY(paired["power"].toDouble() > 0.05 && paired["power"].toDouble() <= 1.0 &&
            paired["participants_needed"].toDouble() >= 2.0);
    for (const QStringList& wrong : {QStringList{"--paired", "--unpaired", "--power"},
                                     QStringList{"--alpha", "0.01"}, QStringList{"--power", "--ratio", "1"}})
        QCOMPARE(
            runCli(QStringList{"study", "plan", kStudy, "--observer", "weber:0.12", "--runs", "5"} + wrong)
                .exitCode,
            2);
}

void TestCliStudy::planOfNoRunsIsInformationAlone() {
    const QJsonObject plan = object(runCli({"study", "plan", kStudy, "--observer", "weber:0.12", "--runs",
                                            "0", "--database", m_folder.filePath("none.db"), "--json"}));
    const QJsonObject condition = plan["conditions"][0].toObject();
    QVERIFY(condition["information_per_trial"].toDouble() > 0.0);
    QVERIFY(condition["best_spacing_sigma"].toDouble() > 0.0);
    for (const char* key : {"bias_log10", "trials", "minutes"}) // of simulated runs
        QVERIFY2(condition.contains(QLatin1String(key)) && condition[QLatin1String(key)].isNull(), key);
    QVERIFY(plan["minutes"].isNull());
}

void TestCliStudy::planTellsWhyNoSpacingIsBest() {
    for (const char* study : {"stiffness_adjustment", "stiffness_magnitude"}) {
        const QJsonObject plan = object(runCli({"study", "plan", study, "--observer", "weber:0.12", "--runs",
                                                "2", "--database", m_folder.filePath("none.db"), "--json"}));
        const QJsonObject condition = plan["conditions"][0].toObject();
        QVERIFY2(condition.contains("best_spacing_sigma") && condition["best_spacing_sigma"].isNull() &&
                     condition["best_difference"].isNull(),
                 study);
        QVERIFY2(condition["best_spacing_why"].toString().contains("no difference"), study);
    }
}

void TestCliStudy::exportHoldsTheFrozenDesign() {
    QCOMPARE(cli({"study", "export", kStudy, "--format", "csv", "--out", m_folder.filePath("csv")}).exitCode,
             0);
    for (const char* name :
         {"trials.csv", "runs.csv", "participants.csv", "questionnaires.csv", "estimates.csv",
          "data_dictionary.csv", "data_dictionary.json", "dataset_description.json", "README.txt"})
        QVERIFY2(!fileIn(QStringLiteral("csv/") + name).isEmpty(), name);
    const QString sha256 = QString::fromLatin1(
        QCryptographicHash::hash(fileIn("csv/design.json"), QCryptographicHash::Sha256).toHex());
    QCOMPARE(sha256, object(cli({"study", "show", kStudy}))["sha256"].toString());
    const QList<QByteArray> participants = fileIn("csv/participants.csv").trimmed().split('\n');
    QCOMPARE(participants.size(), 4);
    QVERIFY(participants[1].startsWith(sha256.toLatin1() + ",S01,1,"));
    const QJsonObject files =
        QJsonDocument::fromJson(fileIn("csv/data_dictionary.json")).object()["files"].toObject();
    const QList<QByteArray> heading = fileIn("csv/trials.csv").split('\n').first().trimmed().split(',');
    QCOMPARE(files["trials.csv"]["order"].toArray().size(), heading.size()); // every column is explained
    for (const QByteArray& column : heading)
        QVERIFY2(files["trials.csv"]["columns"].toObject().contains(QString::fromUtf8(column)),
                 column.constData());
    const QString fault = refusalFault(cli({"study", "export", kStudy, "--out", m_folder.filePath("csv")}), 3,
                                       {"csv"}); // there already
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

void TestCliStudy::bidsHoldsMotion() {
    QCOMPARE(
        cli({"study", "export", kStudy, "--format", "csv,bids", "--out", m_folder.filePath("both")}).exitCode,
        0);
    QVERIFY(!fileIn("both/csv/trials.csv").isEmpty());
    for (const char* name : {"dataset_description.json", "README", "participants.tsv", "participants.json",
                             "sourcedata/design.json"})
        QVERIFY2(!fileIn(QStringLiteral("both/bids/") + name).isEmpty(), name);
    QCOMPARE(QDir(m_folder.filePath("both/bids/sub-S01/beh")).entryList({"*_beh.tsv"}, QDir::Files).size(),
             1);
    QVERIFY(!QDir(m_folder.filePath("both/bids/sub-S01/motion")).exists()); // without rendering nothing moved
    for (const char* end : {"*_motion.tsv", "*_motion.json", "*_channels.tsv", "*_events.tsv"})
        QVERIFY2(!QDir(m_folder.filePath("both/bids/sub-S03/motion")).entryList({end}, QDir::Files).isEmpty(),
                 end);
}

void TestCliStudy::draftIsFrozenByAResearcher() {
    const QString database = m_folder.filePath("site.db");
    const QMap<QString, QString> password{{"CHIRON_PASSWORD", "correct horse battery"},
                                          {"CHIRON_NEW_PASSWORD", "correct horse battery"},
                                          {"CHIRON_IDENTITY", "Ada"}};
    const auto as = [&](const QString& name, const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", database, "--as", name, "--json"}, {}, password);
    };
    QCOMPARE(runCli({"init", "--admin", "alice", "--database", database}, {}, password).exitCode, 0);
    for (const char* role : {"researcher", "trainee"})
        QCOMPARE(as("alice", {"user", "add", QStringLiteral("a_") + role, "--role", role}).exitCode, 0);
    QCOMPARE(as("a_trainee", {"study", "new", kStudy}).exitCode, 2);
    QCOMPARE(object(as("a_researcher", {"study", "new", kStudy, "--id", "tube_trial"}))["state"].toString(),
             QStringLiteral("draft"));
    const QString early = refusalFault(as("a_researcher", {"study", "enrol", "tube_trial"}), 2, {"frozen"});
    QVERIFY2(early.isEmpty(), qPrintable(early));
    QCOMPARE(object(as("a_researcher", {"study", "freeze", "tube_trial"}))["sha256"].toString().size(), 64);
    const QString code = object(as("a_researcher", {"study", "enrol", "tube_trial"}))["code"].toString();
    QVERIFY(!code.isEmpty());
    QVERIFY(!as("a_researcher", {"study", "show", "tube_trial"}).out.contains("Ada"));
    QCOMPARE(object(as("a_researcher", {"study", "consent", "tube_trial", "--participant", code}))["state"]
                 .toString(),
             QStringLiteral("consented"));
    const QJsonArray keys =
        object(as("a_researcher", {"study", "key", "tube_trial"}))["participants"].toArray();
    QCOMPARE(keys, (QJsonArray{QJsonObject{{"code", code}, {"identity", "Ada"}}}));
    const QString person = refusalFault(as("a_researcher", {"study", "run", "tube_trial", "--participant",
                                                            code, "--observer", "weber:0.1", "--quick"}),
                                        2, {"a person"});
    QVERIFY2(person.isEmpty(), qPrintable(person));
    QVERIFY(object(runCli({"study", "list", "--database", database, "--json"}))["studies"]
                .toArray()
                .isEmpty()); // of people: not without --as
    const QStringList erase{"study", "erase", "tube_trial", "--participant", code, "--reason", "wish"};
    const QString early_erasure = refusalFault(as("alice", erase), 2, {"withdraw"});
    QVERIFY2(early_erasure.isEmpty(), qPrintable(early_erasure));
    QCOMPARE(object(as("a_researcher", {"study", "withdraw", "tube_trial", "--participant", code,
                                        "--erase-recordings"}))["state"]
                 .toString(),
             QStringLiteral("withdrawn"));
    QVERIFY(as("a_researcher", erase).exitCode != 0); // an administrator's
    const QJsonObject erased = object(as("alice", erase));
    QCOMPARE(
        erased,
        (QJsonObject{
            {"participant", code}, {"erased", true}, {"reason", "wish"}, {"recordings_withdrawn", true}}));
    QVERIFY(object(as("a_researcher", {"study", "key", "tube_trial"}))["participants"].toArray().isEmpty());
    const QString nobody = refusalFault(
        as("a_researcher", {"study", "enrol", "tube_trial", "--account", "ghost"}), 3, {"ghost"});
    QVERIFY2(nobody.isEmpty(), qPrintable(nobody));
    const QString linked =
        object(as("a_researcher", {"study", "enrol", "tube_trial", "--account", "a_trainee"}))["code"]
            .toString();
    QCOMPARE(object(as("a_researcher", {"study", "key", "tube_trial"}))["participants"].toArray(),
             (QJsonArray{QJsonObject{{"code", linked}, {"identity", "Ada"}, {"account", "a_trainee"}}}));
    QVERIFY(!as("a_researcher", {"study", "show", "tube_trial"}).out.contains("a_trainee"));
    const CliRun again = as("a_researcher", {"study", "enrol", "tube_trial", "--account", "A_Trainee"});
    QVERIFY(again.exitCode == 3 &&
            !again.err.contains(linked.toUtf8())); // who they are is no experimenter's to learn this way
    const QJsonArray held =
        object(as("a_trainee", {"person", "export", "a_trainee"}))["participations"].toArray();
    QVERIFY(held.size() == 1 && QJsonDocument(held).toJson().contains(linked.toUtf8()));
    QCOMPARE(object(as("a_researcher", {"study", "close", "tube_trial"}))["state"].toString(),
             QStringLiteral("closed"));
}

void TestCliStudy::refusals_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QStringList>("mentions");
    const QStringList run{"study", "run", kStudy, "--participant", "X01"};
    QTest::newRow("no such study") << QStringList{"study", "show", "nothing"} << 3 << QStringList{"nothing"};
    QTest::newRow("no such study to run")
        << QStringList{"study", "run", "nothing", "--participant", "X01", "--observer", "weber:0.1"} << 3
        << QStringList{"nothing"};
    QTest::newRow("no such study to plan")
        << QStringList{"study", "plan", "nothing", "--observer", "weber:0.1"} << 3
        << QStringList{"nothing", "expected one of", kStudy};
    QTest::newRow("no observer") << run << 2 << QStringList{"--observer"};
    QTest::newRow("wrong observer") << run + QStringList{"--observer", "weber:heavy"} << 3
                                    << QStringList{"--observer", "heavy"};
    QTest::newRow("observer out of range")
        << run + QStringList{"--observer", "weber:-1"} << 3 << QStringList{"--observer"};
    QTest::newRow("no Weber fraction")
        << run + QStringList{"--observer", "lapse:0.1"} << 3 << QStringList{"weber:W"};
    QTest::newRow("a plan without a Weber fraction")
        << QStringList{"study", "plan", kStudy, "--observer", "bias:0.1", "--runs", "1"} << 3
        << QStringList{"weber:W"};
    QTest::newRow("a plan of somebody who searches")
        << QStringList{"study", "plan", kStudy, "--observer", "operator:expert", "--runs", "1"} << 2
        << QStringList{"only a study of the apex"};
    QTest::newRow("no such condition")
        << run + QStringList{"--observer", "weber:0.1", "--condition", "other"} << 3 << QStringList{"other"};
    QTest::newRow("wrong seed") << run + QStringList{"--observer", "weber:0.1", "--seed", "x"} << 2
                                << QStringList{"--seed"};
    QTest::newRow("wrong number of trials")
        << run + QStringList{"--observer", "weber:0.1", "--trials", "0"} << 2 << QStringList{"--trials"};
    QTest::newRow("a plan of fewer runs than none")
        << QStringList{"study", "plan", kStudy, "--observer", "weber:0.1", "--runs", "-1"} << 2
        << QStringList{"--runs"};
    QTest::newRow("wrong format") << QStringList{"study", "export", kStudy,    "--format",
                                                 "xls",   "--out",  "/nowhere"}
                                  << 2 << QStringList{"xls", "csv, bids"};
    QTest::newRow("a design without --as") << QStringList{"study", "new", kStudy} << 2 << QStringList{"--as"};
    QTest::newRow("the key without --as") << QStringList{"study", "key", kStudy} << 2 << QStringList{"--as"};
}

void TestCliStudy::refusals() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QStringList, mentions);
    const QString fault = refusalFault(cli(arguments), status, mentions);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

QTEST_GUILESS_MAIN(TestCliStudy)
#include "test_cli_study.moc"
