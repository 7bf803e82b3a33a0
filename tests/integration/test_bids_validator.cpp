// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QtTest>

// Exports are BIDS by the judgement of others: the bids-validator (npm, of the BIDS community; scripts/setup
// fetches it) finds no error in a study's export with behaviour, motion, forces and events, nor in a single
// session's.
class TestBidsValidator : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void studyHasNoErrors();
    void sessionHasNoErrors();
    void brokenExportIsNoticed();

private:
    CliRun cli(const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", m_folder.filePath("study.db"), "--json"});
    }
    QTemporaryDir m_folder;
};

namespace {

constexpr int kPatience_ms = 120000; // never asserted, only to end a hanging validator

struct Judgement {
    bool reached = false;
    QStringList errors; ///< "KEY: reason"
    qint64 files = 0;
};

Judgement judge(const QString& folder) {
    QProcess process;
    process.start(QStringLiteral("node"),
                  {QStringLiteral(CHIRON_BIDS_VALIDATOR), folder, QStringLiteral("--json")});
    Judgement judgement;
    if (!process.waitForFinished(kPatience_ms))
        return judgement;
    const QJsonDocument document = QJsonDocument::fromJson(process.readAllStandardOutput());
    judgement.reached = document.object()["issues"].toObject()["errors"].isArray();
    for (const QJsonValue& error : document.object()["issues"].toObject()["errors"].toArray())
        judgement.errors << error["key"].toString() + ": " + error["reason"].toString();
    judgement.files = document.object()["summary"].toObject()["totalFiles"].toInteger();
    return judgement;
}

} // namespace

// Two participants: one with two sittings of rendered presentations, one without rendering and so without
// motion.
void TestBidsValidator::initTestCase() {
    if (QStandardPaths::findExecutable("node").isEmpty() ||
        !QFile::exists(QStringLiteral(CHIRON_BIDS_VALIDATOR)))
        QSKIP("BIDS EXPORTS ARE NOT CHECKED: node or " CHIRON_BIDS_VALIDATOR
              " is missing; scripts/setup fetches them");
    QVERIFY(m_folder.isValid());
    const QStringList run{
        "study",    "run", "stiffness_elastic_tube", "--observer", "weber:0.12,lapse:0.02", "--seed", "1",
        "--trials", "2",   "--participant"};
    for (const QStringList& who : {QStringList{"S01"}, QStringList{"S01"}, QStringList{"S02", "--quick"}}) {
        const CliRun done = cli(run + who);
        QVERIFY2(done.exitCode == 0, done.err.constData());
    }
}

void TestBidsValidator::studyHasNoErrors() {
    const QString folder = m_folder.filePath("study");
    QCOMPARE(cli({"study", "export", "stiffness_elastic_tube", "--format", "bids", "--out", folder}).exitCode,
             0);
    QCOMPARE(QDir(folder + "/sub-S01/motion").entryList({"*_motion.tsv"}, QDir::Files).size(), 2);
    const Judgement judgement = judge(folder);
    QVERIFY(judgement.reached);
    QVERIFY2(judgement.errors.isEmpty(), qPrintable(judgement.errors.join('\n')));
    QVERIFY(judgement.files > 10); // it has looked at them
}

void TestBidsValidator::sessionHasNoErrors() {
    QCOMPARE(cli({"session", "export", "1", "--format", "bids", "--folder", m_folder.path()}).exitCode, 0);
    const Judgement judgement = judge(m_folder.filePath("session_1.bids"));
    QVERIFY(judgement.reached);
    QVERIFY2(judgement.errors.isEmpty(), qPrintable(judgement.errors.join('\n')));
}

// That the validator finds errors at all.
void TestBidsValidator::brokenExportIsNoticed() {
    const QString folder = m_folder.filePath("broken");
    QCOMPARE(cli({"study", "export", "stiffness_elastic_tube", "--format", "bids", "--out", folder}).exitCode,
             0);
    QVERIFY(QFile::remove(folder + "/dataset_description.json"));
    const Judgement judgement = judge(folder);
    QVERIFY(judgement.reached);
    QVERIFY(!judgement.errors.isEmpty());
}

QTEST_GUILESS_MAIN(TestBidsValidator)
#include "test_bids_validator.moc"
