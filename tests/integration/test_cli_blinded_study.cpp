// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <algorithm>

// The surgeons' study is blinded: who is not its author learns no condition from any command, and runs by
// sealed codes.
class TestCliBlindedStudy : public QObject {
    Q_OBJECT
private slots:
    void aBlindedStudyTellsNoCondition();
    void conditionsThatAskDifferentlyAreSealedToo();

private:
    QTemporaryDir m_folder;
};

namespace {

QJsonObject object(const CliRun& run) {
    if (run.exitCode != 0)
        qWarning("%s", run.err.constData());
    return QJsonDocument::fromJson(run.out).object();
}

/// The names of all files with what is in those of this kind.
QByteArray filesIn(const QString& folder, const QStringList& ends) {
    QDirIterator files(folder, QDir::Files, QDirIterator::Subdirectories);
    QByteArray all;
    while (files.hasNext()) {
        QFile file(files.next());
        const bool wanted = std::any_of(ends.begin(), ends.end(),
                                        [&](const QString& end) { return file.fileName().endsWith(end); });
        all += QFileInfo(file).fileName().toUtf8() + '\n';
        all += wanted && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    return all;
}

} // namespace

void TestCliBlindedStudy::aBlindedStudyTellsNoCondition() {
    const QString database = m_folder.filePath("blind.db");
    const QMap<QString, QString> password{{"CHIRON_PASSWORD", "correct horse battery"},
                                          {"CHIRON_NEW_PASSWORD", "correct horse battery"}};
    const auto as = [&](const QString& name, const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", database, "--as", name, "--json"}, {}, password);
    };
    QCOMPARE(runCli({"init", "--admin", "alice", "--database", database}, {}, password).exitCode, 0);
    for (const char* name : {"ruth", "rob"})
        QCOMPARE(as("alice", {"user", "add", name, "--role", "researcher"}).exitCode, 0);
    QCOMPARE(as("ruth", {"study", "new", "surgeons"}).exitCode, 0);
    QCOMPARE(as("ruth", {"study", "freeze", "surgeons"}).exitCode, 0);
    const CliRun run = as("rob", {"study", "run", "surgeons", "--participant", "S01", "--observer",
                                  "weber:0.12", "--quick", "--trials", "5"});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    const CliRun rendered = as("rob", {"study", "run", "surgeons", "--participant", "S02", "--observer",
                                       "weber:0.12", "--trials", "1"});
    QVERIFY2(rendered.exitCode == 0, rendered.err.constData());
    // The sealed code beside the condition's name would tell which is which: of a study in the database as of
    // one in a file.
    const CliRun named = as("rob", {"study", "run", "surgeons", "--participant", "S03", "--observer",
                                    "weber:0.12", "--quick", "--trials", "5", "--condition", "mass"});
    QVERIFY2(named.exitCode == 2 && named.err.contains("--condition") && named.err.contains("blinded"),
             (named.out + named.err).constData());
    QByteArray told = run.out + rendered.out;
    for (const QStringList& command :
         {QStringList{"study", "show", "surgeons"},
          {"study", "analyse", "surgeons"},
          {"study", "export", "surgeons", "--format", "csv,bids", "--out", m_folder.filePath("blind")}}) {
        const CliRun read = as("rob", command);
        QVERIFY2(read.exitCode == 0, read.err.constData());
        told += read.out;
    }
    const CliRun shown = as("rob", {"session", "list"});
    const QJsonArray sessions = object(shown)["sessions"].toArray();
    QCOMPARE(sessions.size(), 1);
    const CliRun opened = as("rob", {"session", "show", QString::number(sessions[0]["session_id"].toInt())});
    QVERIFY2(opened.exitCode != 0 && opened.err.contains("blinded"), opened.out.constData());
    told += shown.out + opened.out + opened.err;
    const QJsonObject show = object(as("rob", {"study", "show", "surgeons"}));
    QVERIFY(show["blinded"].toBool() && !show.contains("design"));
    QCOMPARE(show["conditions"].toArray().size(), 3);
    const CliRun plan = as("rob", {"study", "plan", "surgeons", "--runs", "0", "--observer", "weber:0.1"});
    QVERIFY2(plan.exitCode != 0 && plan.err.contains("blinded"), (plan.out + plan.err).constData());
    QCOMPARE(as("ruth", {"study", "plan", "surgeons", "--runs", "0", "--observer", "weber:0.1"}).exitCode, 0);
    QVERIFY(object(as("ruth", {"study", "show", "surgeons"})).contains("design")); // who may unblind it
    const QJsonObject analysis = object(as("rob", {"study", "analyse", "surgeons"}));
    QCOMPARE(analysis["runs"].toArray().size(), 2);
    const QString code = analysis["runs"][0]["condition"].toString();
    QCOMPARE(code.size(), 3);
    for (const QJsonValue& each :
         analysis["runs"].toArray()) { // conditions differ: not even how many trials there were
        QVERIFY(each["estimate"]["weber"].isNull() && each["estimate"]["trials"].isNull());
        QVERIFY(each["replayed"]["trials"].toInt() == 0 && each["force_class"].isNull());
    }
    QCOMPARE(analysis["quality"].toArray().size(), 2); // what can be watched instead, by participant
    for (const QJsonValue& each : analysis["quality"].toArray()) {
        QVERIFY(each["conditions"].toInt() == 3 && each["conditions_done"].toInt() == 0 &&
                each["scored"].isNull());
        const bool felt = each["participant"].toString() == QLatin1String("S02");
        QVERIFY(felt
                    ? each["force_class"].toString() == QLatin1String("felt") && each["late_ticks"].isDouble()
                    : each["force_class"].isNull() && each["late_ticks"].isNull());
    }
    // What columns mean is said beside them, in words that hold for all attributes ("stiffness_error").
    const QByteArray exported = filesIn(
        m_folder.filePath("blind"), {"runs.csv", "trials.csv", "estimates.csv", "participants.csv", ".tsv"});
    told += filesIn(m_folder.filePath("blind"), {".json"});
    QVERIFY(exported.contains(code.toLatin1()));
    for (const char* condition : {"stiffness", "mass", "friction"}) {
        QVERIFY2(!told.contains(QByteArray("\"") + condition + "\""), condition);
        QVERIFY2(!exported.contains(condition), condition);
    }
    QVERIFY(!QFile::exists(m_folder.filePath("blind/csv/design.json")));
    QVERIFY(as("rob", {"study", "unblind", "surgeons", "--reason", "curiosity"}).exitCode != 0);
    const CliRun without = as("ruth", {"study", "unblind", "surgeons"});
    QVERIFY2(without.exitCode == 2 && without.err.contains("--reason"), without.err.constData());
    QVERIFY(as("ruth", {"study", "unblind", "surgeons", "--reason", " "}).exitCode != 0);
    const CliRun unblinded = as("ruth", {"study", "unblind", "surgeons", "--reason", "all are done"});
    QVERIFY2(unblinded.exitCode == 0, unblinded.err.constData());
    QVERIFY(object(unblinded)["people_to_come"].toInt() > 0); // nobody planned has come yet
    QCOMPARE(as("rob", {"session", "show", QString::number(sessions[0]["session_id"].toInt())}).exitCode, 0);
    QVERIFY(object(as("rob", {"study", "show", "surgeons"})).contains("design"));
    const QString after =
        object(as("rob", {"study", "analyse", "surgeons"}))["runs"][0]["condition"].toString();
    QVERIFY2((QStringList{"stiffness", "mass", "friction"}).contains(after), qPrintable(after));
    const CliRun open = as("rob", {"study", "run", "surgeons", "--participant", "S03", "--observer",
                                   "weber:0.12", "--quick", "--trials", "5", "--condition", "mass"});
    QVERIFY2(open.exitCode == 0, open.err.constData()); // nothing is sealed any more
}

/// Where conditions ask differently, an answer alone would tell which it was: no trial is listed until the
/// study is unblinded, then all of each is.
void TestCliBlindedStudy::conditionsThatAskDifferentlyAreSealedToo() {
    const auto contentOf = [](const char* study) {
        QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content/studies/%1.json")
                       .arg(QLatin1String(study)));
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                              : QJsonObject();
    };
    QJsonObject design = contentOf("surgeons");
    QJsonObject pairs = contentOf("stiffness_2afc")["conditions"][0].toObject();
    pairs["id"] = "pairs";
    design["id"] = "two_tasks";
    design["conditions"] = QJsonArray{design["conditions"][0], pairs};
    const QString file = m_folder.filePath("two_tasks.json"), database = m_folder.filePath("two_tasks.db");
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly) && out.write(QJsonDocument(design).toJson()) > 0);
    out.close();
    const QMap<QString, QString> password{{"CHIRON_PASSWORD", "correct horse battery"},
                                          {"CHIRON_NEW_PASSWORD", "correct horse battery"}};
    const auto as = [&](const QString& name, const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", database, "--as", name, "--json"}, {}, password);
    };
    QCOMPARE(runCli({"init", "--admin", "alice", "--database", database}, {}, password).exitCode, 0);
    for (const char* name : {"ruth", "rob"})
        QCOMPARE(as("alice", {"user", "add", name, "--role", "researcher"}).exitCode, 0);
    const CliRun draft = as("ruth", {"study", "new", file});
    QVERIFY2(draft.exitCode == 0, draft.err.constData());
    QCOMPARE(as("ruth", {"study", "freeze", "two_tasks"}).exitCode, 0);
    const auto trialsOf = [&](const char* participant) {
        QStringList told;
        for (const QJsonValue& run :
             object(as("rob", {"study", "run", "two_tasks", "--participant", participant, "--observer",
                               "weber:0.12", "--quick"}))["runs"]
                 .toArray())
            for (const QJsonValue& trial : run["trials"].toArray())
                told << QStringLiteral("%1 %2 %3")
                            .arg(trial["arrangement"].isDouble())
                            .arg(trial["answer"].isDouble())
                            .arg(trial["outcome"].isDouble());
        return told;
    };
    QCOMPARE(trialsOf("S01"), QStringList());
    const CliRun unblinded = as("ruth", {"study", "unblind", "two_tasks", "--reason", "all are done"});
    QVERIFY2(unblinded.exitCode == 0, unblinded.err.constData());
    QStringList told = trialsOf("S02");
    QVERIFY(told.size() > 20);
    told.removeDuplicates();
    QCOMPARE(told, QStringList{QStringLiteral("1 1 1")});
}

QTEST_GUILESS_MAIN(TestCliBlindedStudy)
#include "test_cli_blinded_study.moc"
