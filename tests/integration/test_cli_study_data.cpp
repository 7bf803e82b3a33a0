// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <utility>

// What study commands leave behind: exports that hold all that was estimated and overwrite nobody, and
// refused ones nothing.
class TestCliStudyData : public QObject {
    Q_OBJECT
private slots:
    void magnitudeTellsTheExponent();
    void twoConditionsAreCompared();
    void codesThatLookAlikeStayApart();
    void everyTargetIsCheckedFirst();
    void refusedRunsMakeNothing_data();
    void refusedRunsMakeNothing();
    void refusedRunsEnrolNobody();

private:
    QByteArray fileIn(const QString& path) {
        QFile file(m_folder.filePath(path));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QStringList in(const QString& database) { return {"--database", m_folder.filePath(database), "--json"}; }

    inline static const QString kStudy = QStringLiteral("stiffness_elastic_tube");
    QTemporaryDir m_folder;
};

namespace {

QJsonObject object(const CliRun& run) {
    if (run.exitCode != 0)
        qWarning("%s", run.err.constData());
    return QJsonDocument::fromJson(run.out).object();
}

} // namespace

// Two conditions that are the same but for their names, done by the same three simulated people: a paired
// ratio near 1, which its interval holds.
void TestCliStudyData::twoConditionsAreCompared() {
    QFile content(
        QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content/studies/stiffness_elastic_tube.json"));
    QVERIFY(content.open(QIODevice::ReadOnly));
    QJsonObject design = QJsonDocument::fromJson(content.readAll()).object();
    QJsonArray conditions = design["conditions"].toArray();
    QJsonObject again = conditions[0].toObject();
    again["id"] = "tube_again";
    conditions.append(again);
    design["conditions"] = conditions;
    design["id"] = "two_tubes";
    QFile file(m_folder.filePath("two_tubes.json"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(design).toJson()) > 0);
    file.close();
    for (const char* code : {"C01", "C02", "C03"})
        QCOMPARE(runCli(QStringList{"study", "run", file.fileName(), "--participant", code, "--observer",
                                    "weber:0.12,lapse:0.02", "--quick"} +
                        in("compared.db"))
                     .exitCode,
                 0);
    const QJsonObject analysis =
        object(runCli(QStringList{"study", "analyse", "two_tubes"} + in("compared.db")));
    QCOMPARE(analysis["comparisons"].toArray().size(), 1);
    const QJsonObject compared = analysis["comparisons"][0].toObject();
    QCOMPARE(compared["condition_a"].toString(), QStringLiteral("tube_60"));
    QCOMPARE(compared["condition_b"].toString(), QStringLiteral("tube_again"));
    QVERIFY(compared["paired"].toBool());
    QCOMPARE(compared["n"].toInt(), 3);
    const double ratio = compared["ratio"].toDouble();
    QVERIFY2(ratio > 0.6 && ratio < 1.6 && compared["ci_low"].toDouble() < ratio &&
                 ratio < compared["ci_high"].toDouble(),
             qPrintable(QString::number(ratio)));
    QVERIFY(compared["p"].toDouble() > 0.0 && compared["p"].toDouble() <= 1.0 &&
            compared["p_holm"] == compared["p"]);
    QVERIFY(!compared.contains("threshold_models")); // answers decided what came next
    for (const QJsonValue& run : analysis["runs"].toArray())
        QVERIFY(run["estimate"]["prior_influence"].toDouble() > 0.01 &&
                run["estimate"]["prior_influence"].toDouble() < 0.5);
}

// Numbers that are said tell no Weber fraction: the exponent is all that there is.
void TestCliStudyData::magnitudeTellsTheExponent() {
    const QStringList database{"--database", m_folder.filePath("magnitude.db"), "--json"};
    const QJsonObject run = object(runCli(QStringList{"study", "run", "stiffness_magnitude", "--participant",
                                                      "M01", "--observer", "weber:0.12", "--quick"} +
                                          database));
    const QJsonObject estimate = run["estimate"].toObject();
    const double exponent = estimate["exponent"].toDouble();
    QVERIFY2(exponent > 0.5 && exponent < 1.5,
             qPrintable(QString::number(exponent))); // the observer says what it feels
    QVERIFY(estimate["exponent_ci"][0].toDouble() < exponent &&
            exponent < estimate["exponent_ci"][1].toDouble());
    QCOMPARE(runCli(QStringList{"study", "export", "stiffness_magnitude", "--format", "csv,bids", "--out",
                                m_folder.filePath("magnitude")} +
                    database)
                 .exitCode,
             0);
    const QList<QByteArray> rows = fileIn("magnitude/csv/estimates.csv").split('\n');
    const QList<QByteArray> heading = rows[0].split(','), cells = rows[1].split(',');
    for (const auto& [column, value] : {std::pair{"exponent", exponent},
                                        {"exponent_low", estimate["exponent_ci"][0].toDouble()},
                                        {"exponent_high", estimate["exponent_ci"][1].toDouble()}}) {
        QVERIFY2(heading.contains(column), column);
        QCOMPARE(cells[heading.indexOf(column)].toDouble(), value);
    }
    QVERIFY(fileIn("magnitude/csv/data_dictionary.csv").contains("estimates,exponent,1,"));
    const QList<QByteArray> trials = fileIn("magnitude/csv/trials.csv").trimmed().split('\n');
    const qsizetype said = trials[0].split(',').indexOf("value");
    for (const QByteArray& trial :
         trials.mid(1)) { // numbers are said relative to the reference, to which the observer gives about 10
        const double value = trial.split(',')[said].toDouble();
        QVERIFY2(value > 1.0 && value < 100.0, trial.constData());
    }
    const QDir beh(m_folder.filePath("magnitude/bids/sub-M01/beh"));
    const QJsonObject sidecar = QJsonDocument::fromJson(fileIn("magnitude/bids/sub-M01/beh/" +
                                                               beh.entryList({"*_beh.json"}).value(0)))
                                    .object();
    QCOMPARE(sidecar["Estimate"]["exponent"].toDouble(), exponent);
    QVERIFY(sidecar["Estimate"]["exponent_low"].isDouble() &&
            sidecar["Estimate"]["exponent_high"].isDouble());
}

void TestCliStudyData::codesThatLookAlikeStayApart() {
    for (const char* code : {"S_01", "S01"})
        QCOMPARE(runCli(QStringList{"study", "run", kStudy, "--participant", code, "--observer", "weber:0.12",
                                    "--quick", "--trials", "3"} +
                        in("alike.db"))
                     .exitCode,
                 0);
    QCOMPARE(runCli(QStringList{"study", "export", kStudy, "--format", "bids", "--out",
                                m_folder.filePath("alike")} +
                    in("alike.db"))
                 .exitCode,
             0);
    QCOMPARE(QDir(m_folder.filePath("alike")).entryList({"sub-*"}, QDir::Dirs),
             (QStringList{"sub-S01", "sub-S01x2"}));
    const QByteArray participants = fileIn("alike/participants.tsv");
    QVERIFY2(participants.contains("sub-S01x2\tS_01\t") && participants.contains("sub-S01\tS01\t"),
             participants.constData());
}

// Of several formats none is written where one cannot be.
void TestCliStudyData::everyTargetIsCheckedFirst() {
    QCOMPARE(runCli(QStringList{"study", "run", kStudy, "--participant", "S01", "--observer", "weber:0.12",
                                "--quick", "--trials", "3"} +
                    in("targets.db"))
                 .exitCode,
             0);
    QVERIFY(QDir(m_folder.path()).mkpath("targets/bids"));
    const QStringList both =
        QStringList{"study", "export", kStudy, "--out", m_folder.filePath("targets"), "--format"};
    const QString fault = refusalFault(runCli(both + QStringList{"csv,bids"} + in("targets.db")), 3,
                                       {"bids", "exists already"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    QVERIFY(!QDir(m_folder.filePath("targets/csv")).exists());
}

void TestCliStudyData::refusedRunsMakeNothing_data() {
    QTest::addColumn<QString>("study");
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::newRow("observer of another kind")
        << kStudy << QStringList{"--observer", "operator:novice", "--quick"} << 2;
    QTest::newRow("no such condition")
        << kStudy << QStringList{"--observer", "weber:0.12", "--condition", "nope"} << 3;
    QTest::newRow("no such study") << "nothing" << QStringList{"--observer", "weber:0.12"} << 3;
    QTest::newRow("no such trainee") << "apex" << QStringList{"--observer", "weber:0.1,operator:nobody"} << 3;
    QTest::newRow("no trials") << kStudy << QStringList{"--observer", "weber:0.12", "--trials", "0"} << 2;
    QTest::newRow("no seed") << kStudy << QStringList{"--observer", "weber:0.12", "--seed", "x"} << 2;
}

void TestCliStudyData::refusedRunsMakeNothing() {
    QFETCH(QString, study);
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    const QString database =
        QStringLiteral("refused_%1.db").arg(QString::fromLatin1(QTest::currentDataTag()).replace(u' ', u'_'));
    const QString fault = refusalFault(
        runCli(QStringList{"study", "run", study, "--participant", "Q1"} + arguments + in(database)), status,
        {});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    QVERIFY(!QFile::exists(m_folder.filePath(database)));
    if (study == kStudy) // nothing stands in the way of the right one
        QCOMPARE(runCli(QStringList{"study", "run", kStudy, "--participant", "Q1", "--observer", "weber:0.12",
                                    "--quick", "--trials", "2"} +
                        in(database))
                     .exitCode,
                 0);
}

// In a database with the study: nobody takes a row of the order design; a study that is not there yet is not
// made either.
void TestCliStudyData::refusedRunsEnrolNobody() {
    const auto run = [&](const QString& study, const QString& code, const QStringList& more) {
        return runCli(QStringList{"study", "run", study, "--participant", code, "--quick", "--trials", "2"} +
                      more + in("there.db"));
    };
    QCOMPARE(run(kStudy, "S01", {"--observer", "weber:0.12"}).exitCode, 0);
    QCOMPARE(run(kStudy, "S02", {"--observer", "weber:0.12", "--condition", "nope"}).exitCode, 3);
    QCOMPARE(run(kStudy, "S02", {"--observer", "operator:novice"}).exitCode, 2);
    QCOMPARE(run("stiffness_2afc", "S02", {"--observer", "operator:novice"}).exitCode, 2);
    QCOMPARE(run("stiffness_2afc", "no/code", {"--observer", "weber:0.12"}).exitCode, 3);
    const QJsonArray studies =
        object(runCli(QStringList{"study", "list"} + in("there.db")))["studies"].toArray();
    QCOMPARE(studies.size(), 1);
    QCOMPARE(studies[0]["participants"].toInt(), 1);
    QCOMPARE(run(kStudy, "S02", {"--observer", "weber:0.2"}).exitCode, 0);
    const QJsonArray list =
        object(runCli(QStringList{"study", "show", kStudy} + in("there.db")))["participant_list"].toArray();
    QCOMPARE(list[1]["code"].toString(), QStringLiteral("S02"));
    QCOMPARE(list[1]["order"].toInt(), 1);
}

QTEST_GUILESS_MAIN(TestCliStudyData)
#include "test_cli_study_data.moc"
