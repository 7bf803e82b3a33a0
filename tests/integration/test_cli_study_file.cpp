// SPDX-License-Identifier: GPL-3.0-or-later
// A study designed as a JSON file, of rankings with ties: planned, run and analysed from the file; another
// design of that name is refused.
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

class TestCliStudyFile : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void planned();
    void runAndAnalysed();
    void anotherDesignIsRefused();
    void faultyFile();

private:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    void write(const QString& name, const QJsonObject& design) {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(design).toJson()) > 0);
    }
    CliRun run(const QString& file, const QString& participant, const QString& database) {
        return runCli({"study", "run", path(file), "--participant", participant, "--observer",
                       "weber:0.12,lapse:0.02,ties:0.8", "--seed", "5", "--quick", "--database",
                       path(database), "--json"});
    }
    QTemporaryDir m_folder;
    QJsonObject m_design;
};

namespace {

QJsonObject object(const CliRun& run) {
    if (run.exitCode != 0)
        qWarning("%s", run.err.constData());
    return QJsonDocument::fromJson(run.out).object();
}

} // namespace

/// The program's own study of tubes, where ties are allowed.
void TestCliStudyFile::initTestCase() {
    const QString database = path("content.db");
    QCOMPARE(runCli({"study", "run", "stiffness_elastic_tube", "--participant", "S01", "--observer",
                     "weber:0.1", "--quick", "--trials", "5", "--database", database})
                 .exitCode,
             0);
    QCOMPARE(runCli({"study", "export", "stiffness_elastic_tube", "--format", "csv", "--out", path("export"),
                     "--database", database})
                 .exitCode,
             0);
    QFile file(path("export/design.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    m_design = QJsonDocument::fromJson(file.readAll()).object();
    QJsonObject condition = m_design["conditions"][0].toObject(),
                procedure = condition["procedures"][0].toObject();
    QCOMPARE(procedure["kind"].toString(), QStringLiteral("rank3_quest_plus"));
    procedure["allow_ties"] = true;
    condition["task"] = "rank3_ties";
    condition["procedures"] = QJsonArray{procedure};
    m_design["conditions"] = QJsonArray{condition};
    m_design["id"] = "tubes_with_ties";
    write("ties.json", m_design);
}

void TestCliStudyFile::planned() {
    const QJsonObject plan = object(runCli({"study", "plan", path("ties.json"), "--observer",
                                            "weber:0.12,lapse:0.02,ties:0.8", "--runs", "20", "--json"}));
    const QJsonObject condition = plan["conditions"][0].toObject();
    QVERIFY(condition["sd_log10"].toDouble() > 0.03 && condition["sd_log10"].toDouble() < 0.12);
    QVERIFY(condition["information_per_trial"].toDouble() > 0.8);
}

void TestCliStudyFile::runAndAnalysed() {
    const QJsonObject first = object(run("ties.json", "S01", "ties.db"));
    QVERIFY(first["runs"][0]["completed"].toBool());
    bool tied = false;
    for (const QJsonValue& trial : first["trials"].toArray())
        tied = tied || trial["answer"].toInt() >= 6;
    QVERIFY(tied);
    QCOMPARE(object(run("ties.json", "S01", "ties.db"))["trials"],
             first["trials"]); // the same study, done already
    QCOMPARE(runCli({"study", "rerun", "tubes_with_ties", "--database", path("ties.db")}).exitCode, 0);
    const QJsonObject estimate = object(runCli({"study", "analyse", "tubes_with_ties", "--database",
                                                path("ties.db"), "--json"}))["runs"][0]["estimate"]
                                     .toObject();
    QVERIFY(estimate["ci_low"].toDouble() < 0.12 && estimate["ci_high"].toDouble() > 0.12);
    QVERIFY(estimate["tie_ci"][0].toDouble() < 0.8 && estimate["tie_ci"][1].toDouble() > 0.8);
}

void TestCliStudyFile::anotherDesignIsRefused() {
    QJsonObject other = m_design;
    other["participants_planned"] = 3;
    write("other.json", other);
    const QString fault = refusalFault(run("other.json", "S02", "ties.db"), 3,
                                       {"other.json", "another design", "tubes_with_ties"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

/// Ties in the task and not in the procedure: the place in the file is named, and nothing is made.
void TestCliStudyFile::faultyFile() {
    QJsonObject faulty = m_design;
    QJsonObject condition = faulty["conditions"][0].toObject();
    condition["task"] = "rank3";
    faulty["conditions"] = QJsonArray{condition};
    write("faulty.json", faulty);
    const QString fault =
        refusalFault(run("faulty.json", "S01", "none.db"), 3, {"faulty.json", "allow_ties"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    QVERIFY(!QFile::exists(path("none.db")));
}

QTEST_GUILESS_MAIN(TestCliStudyFile)
#include "test_cli_study_file.moc"
