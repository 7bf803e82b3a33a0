// SPDX-License-Identifier: GPL-3.0-or-later
// Two programs on one database, and one that is asked to stop.
#include "cli_process.h"
#include "support/patience.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>
#include <QtTest>
#include <csignal>

using chiron::tests::kPatience_ms;

namespace {

QJsonObject object(const QByteArray& json) {
    return QJsonDocument::fromJson(json).object();
}

} // namespace

class TestTwoPrograms : public QObject {
    Q_OBJECT
private slots:
    void secondWriterIsRefusedAndReadersAreNot();
    void askedToStop();
    void cleanup() { // of a test that failed half-way
        m_training.kill();
        m_training.waitForFinished(kPatience_ms);
    }

private:
    void startTraining();
    CliRun run(const QStringList& words) const {
        return runCli(words + QStringList{"--database", m_database}, {},
                      {{"XDG_RUNTIME_DIR", m_folder.path()}});
    }
    QJsonArray sessions() const {
        return object(run({"session", "list", "--json"}).out)["sessions"].toArray();
    }
    QStringList rings() const { return QDir(m_folder.path()).entryList({"*.ring", "*.part"}, QDir::Files); }

    QTemporaryDir m_folder;
    QString m_database = m_folder.filePath("site.db");
    QProcess m_training;
};

/// A program that trains in real time, once it is seen to do so.
void TestTwoPrograms::startTraining() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_RUNTIME_DIR", m_folder.path());
    environment.insert("HOME", m_folder.path());
    m_training.setProcessEnvironment(environment);
    const auto before = QFile::exists(m_database) ? sessions().size() : 0;
    m_training.start(CHIRON_CLI, {"train", "sphere_apex", "--level", "2", "--operator", "novice",
                                  "--realtime", "--json", "--database", m_database});
    QVERIFY(m_training.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(
        QFile::exists(m_database) && sessions().size() == before + 1 && rings().size() == 1, kPatience_ms);
}

void TestTwoPrograms::secondWriterIsRefusedAndReadersAreNot() {
    startTraining();
    const CliRun second = run({"train", "sphere_apex", "--operator", "expert"});
    const QString pid = QString::number(m_training.processId());
    const QString fault = refusalFault(second, 4, {"site.db", "chiron-cli", pid});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    const CliRun reader = run({"session", "list", "--json"});
    QVERIFY2(reader.exitCode == 0, reader.err.constData());
    const QJsonArray listed = object(reader.out)["sessions"].toArray();
    QCOMPARE(listed.size(), 1);
    QCOMPARE(listed.at(0)["state"].toString(), QString("running"));
    QCOMPARE(run({"verify"}).exitCode, 0);
    // Nobody waited for the session to end, and nobody disturbed it.
    QCOMPARE(m_training.state(), QProcess::Running);
    ::kill(static_cast<pid_t>(m_training.processId()), SIGINT);
    QVERIFY(m_training.waitForFinished(kPatience_ms));
    QCOMPARE(m_training.exitCode(), 0);
}

void TestTwoPrograms::askedToStop() {
    startTraining();
    ::kill(static_cast<pid_t>(m_training.processId()), SIGTERM);
    QVERIFY(m_training.waitForFinished(kPatience_ms));
    QCOMPARE(m_training.exitStatus(), QProcess::NormalExit);
    QVERIFY2(m_training.exitCode() == 0, m_training.readAllStandardError().constData());
    const QJsonObject said = object(m_training.readAllStandardOutput());
    QCOMPARE(said["state"].toString(), QString("stopped"));
    QCOMPARE(said["recording"]["dropped"].toInteger(-1), 0);
    const qint64 frames = said["recording"]["frames"].toInteger();
    QVERIFY(frames > 0);
    QCOMPARE(frames, said["loop"]["ticks"].toInteger()); // every executed tick is recorded, the last one too
    QVERIFY(rings().isEmpty());
    const QString id = QString::number(said["session_id"].toInteger());
    const CliRun replay = run({"replay", id, "--json"});
    QVERIFY2(replay.exitCode == 0, replay.err.constData());
    QCOMPARE(object(replay.out)["frames"].toInteger(), frames);
    QCOMPARE(object(run({"session", "show", id, "--json"}).out)["state"].toString(), QString("stopped"));
    QCOMPARE(run({"verify"}).exitCode, 0);
}

QTEST_GUILESS_MAIN(TestTwoPrograms)
#include "test_two_programs.moc"
