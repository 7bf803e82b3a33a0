// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <cmath>

// Sessions from outside: trained with and without a name, flagged where a trace has no mark, refused to
// strangers, exported and scored again.
class TestCliSessions : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void traceWithoutMarkIsFlagged();
    void traceWithMarkIsNot();
    void exportScoresTheSame();
    void exportTellsWhatHappened();
    void aWrongOperatorMakesNoDatabase();
    void sessionsOfOthersAreRefused();
    void refusalsNameTheCommandOnce();
    void readingCountsWrongPasswords();
    void reportIsQuiet();
    void noForcesNoForceMetrics();

private:
    CliRun cli(const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", m_database, "--json"});
    }
    CliRun as(const QString& name, const QStringList& arguments, const QString& password = kPassword) {
        return runCli(arguments + QStringList{"--database", m_database, "--json", "--as", name}, {},
                      {{"CHIRON_PASSWORD", password}, {"CHIRON_NEW_PASSWORD", kPassword}});
    }
    QJsonObject object(const CliRun& run) {
        if (run.exitCode != 0)
            qWarning("%s", run.err.constData());
        return QJsonDocument::fromJson(run.out).object();
    }
    QString trace(const QString& name, int markedRow);

    inline static const QString kPassword = QStringLiteral("correct horse battery");
    QTemporaryDir m_folder;
    QString m_database;
};

namespace {

// The part of a document that holds the numbers, as it was printed: compared as text, no digit may differ.
QByteArray printedMetrics(const QJsonObject& document) {
    QJsonArray trials;
    for (const QJsonValue& trial : document["trials"].toArray())
        trials.append(trial["metrics"]);
    QMap<QString, QJsonValue>
        metrics; // `metrics` prints them in the catalogue's order, a session in its level's
    for (const QJsonValue& metric : document["metrics"].toArray())
        metrics[metric["id"].toString()] = metric["value"];
    QMap<QString, QJsonValue> ofTrials;
    for (qsizetype i = 0; i < trials.size(); ++i) {
        for (const QJsonValue& metric : trials[i].toArray())
            ofTrials[QStringLiteral("%1 %2").arg(i).arg(metric["id"].toString())] = metric["value"];
    }
    QJsonArray all;
    for (auto it = metrics.begin(); it != metrics.end(); ++it)
        all.append(QJsonArray{it.key(), it.value()});
    for (auto it = ofTrials.begin(); it != ofTrials.end(); ++it)
        all.append(QJsonArray{it.key(), it.value()});
    return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

/// The metrics of a session's level: a trace file by itself is asked for every metric there is.
QString idsOf(const QJsonObject& document) {
    QStringList ids;
    for (const QJsonValue& metric : document["metrics"].toArray())
        ids << metric["id"].toString();
    return ids.join(u',');
}

QJsonValue valueOf(const QJsonObject& document, const char* id) {
    for (const QJsonValue& metric : document["metrics"].toArray()) {
        if (metric["id"].toString() == QLatin1String(id))
            return metric;
    }
    return {};
}

} // namespace

// Three seconds over the sphere's top, pressing 1 mm into where it may be; row 0: no mark.
QString TestCliSessions::trace(const QString& name, int markedRow) {
    QByteArray text = "t_s,x_mm,y_mm,z_mm,buttons\n";
    for (int i = 0; i < 300; ++i) {
        const double t = 0.01 * i;
        text += QStringLiteral("%1,%2,%3,19,%4\n")
                    .arg(t, 0, 'f', 2)
                    .arg(5.0 * std::sin(t), 0, 'f', 3)
                    .arg(5.0 * std::cos(t), 0, 'f', 3)
                    .arg(markedRow > 0 && i >= markedRow ? 1 : 0)
                    .toUtf8();
    }
    QFile out(m_folder.filePath(name));
    if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size())
        qFatal("the test's own file could not be written");
    return out.fileName();
}

void TestCliSessions::initTestCase() {
    m_database = m_folder.filePath("site.db");
    QCOMPARE(
        runCli({"init", "--admin", "alice", "--database", m_database}, {}, {{"CHIRON_PASSWORD", kPassword}})
            .exitCode,
        0);
    for (const char* name : {"bob", "carol", "dave"})
        QCOMPARE(as("alice", {"user", "add", name, "--role", "trainee"}).exitCode, 0);
    QCOMPARE(as("alice", {"user", "add", "theo", "--role", "trainer"}).exitCode, 0);
}

// cli.md: without a mark the last position is marked and the trial flagged; so says every command that looks
// at it.
void TestCliSessions::traceWithoutMarkIsFlagged() {
    const QJsonObject trained = object(cli({"train", "sphere_apex", "--operator", trace("none.csv", 0)}));
    const QJsonArray trials = trained["trials"].toArray();
    QCOMPARE(trials.size(), 1);
    QCOMPARE(trials[0]["flag"].toString(), QStringLiteral("no_mark"));
    QCOMPARE(trials[0]["marked"].toBool(true), false);
    QCOMPARE(trials[0]["timed_out"].toBool(true), false);
    QVERIFY(valueOf(trained, "apex_error_mean")["value"].isDouble()); // scored at its last position
    const QString id = QString::number(trained["session_id"].toInt());
    const CliRun again = cli({"score", id});
    QCOMPARE(again.exitCode, 0);
    QCOMPARE(object(again)["trials"][0]["flag"].toString(), QStringLiteral("no_mark"));
    QCOMPARE(cli({"replay", id}).exitCode, 0);
    const QString folder = m_folder.filePath("flagged");
    QCOMPARE(cli({"session", "export", id, "--format", "csv,json", "--folder", folder}).exitCode, 0);
    const QJsonObject measured =
        object(runCli({"metrics", folder + "/session_" + id + ".csv", "--metric", idsOf(trained), "--json"}));
    QCOMPARE(measured["trials"][0]["flag"].toString(), QStringLiteral("no_mark"));
    QCOMPARE(printedMetrics(measured), printedMetrics(trained));
    const CliRun plain = runCli({"session", "show", id, "--database", m_database});
    QVERIFY2(plain.out.contains("the last position is scored: trial 1"), plain.out.constData());
}

void TestCliSessions::traceWithMarkIsNot() {
    const QJsonObject trained = object(cli({"train", "sphere_apex", "--operator", trace("one.csv", 200)}));
    const QJsonValue trial = trained["trials"][0];
    QVERIFY(trial["flag"].isNull());
    QCOMPARE(trial["marked"].toBool(), true);
}

void TestCliSessions::exportScoresTheSame() {
    const QString seed = QStringLiteral("18446744073709551615");
    const QJsonObject trained =
        object(cli({"train", "sphere_apex", "--level", "1", "--operator", "expert", "--seed", seed}));
    const QString id = QString::number(trained["session_id"].toInt());
    const QString folder = m_folder.filePath("same");
    QCOMPARE(cli({"session", "export", id, "--format", "csv,json", "--folder", folder}).exitCode, 0);
    const QJsonObject measured =
        object(runCli({"metrics", folder + "/session_" + id + ".csv", "--metric", idsOf(trained), "--json"}));
    QCOMPARE(printedMetrics(measured), printedMetrics(trained));
    const CliRun scored = cli({"score", id});
    QCOMPARE(scored.exitCode, 0);
    QCOMPARE(object(scored)["same"].toBool(), true);
    QCOMPARE(printedMetrics(object(scored)), printedMetrics(trained));
    QCOMPARE(object(cli({"session", "show", id}))["seed"].toString(),
             seed); // JSON numbers would lose its last digits
}

void TestCliSessions::exportTellsWhatHappened() {
    QFile file(m_folder.filePath("flagged/session_1.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QStringList kinds;
    for (const QJsonValue& event : QJsonDocument::fromJson(file.readAll())["events"].toArray()) {
        kinds << event["kind"].toString();
        QVERIFY(event["tick"].isDouble() && event["time_s"].isDouble());
    }
    QVERIFY2(kinds.contains("trial_started") && kinds.contains("trace_ended_unmarked") &&
                 !kinds.contains("marked"),
             qPrintable(kinds.join(' ')));
}

void TestCliSessions::aWrongOperatorMakesNoDatabase() {
    const QString fresh = m_folder.filePath("fresh.db");
    QFile broken(m_folder.filePath("broken.csv"));
    QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0,1,1,1\n") > 0);
    broken.close();
    for (const QString& name : {QStringLiteral("nobody"), broken.fileName()}) {
        const CliRun run = runCli({"train", "sphere_apex", "--operator", name, "--database", fresh});
        QCOMPARE(refusalFault(run, 3, {"train: ", QFileInfo(name).fileName(), "expected"}), QString());
        QVERIFY(!QFileInfo::exists(fresh) && !QFileInfo::exists(fresh + ".site"));
    }
}

void TestCliSessions::sessionsOfOthersAreRefused() {
    const QJsonObject mine = object(as("bob", {"train", "sphere_apex", "--operator", trace("bob.csv", 200)}));
    const QString id = QString::number(mine["session_id"].toInt());
    for (const QStringList& arguments :
         {QStringList{"session", "show", id}, QStringList{"score", id}, QStringList{"replay", id},
          QStringList{"session", "export", id, "--folder", m_folder.filePath("stolen")},
          QStringList{"report", id, "--pdf", m_folder.filePath("stolen.pdf")}}) {
        QCOMPARE(refusalFault(cli(arguments), 2, {"session " + id, "log in first"}), QString());
        QCOMPARE(refusalFault(as("carol", arguments), 2, {"session " + id + " is somebody else's"}),
                 QString());
    }
    QVERIFY(!QFileInfo::exists(m_folder.filePath("stolen")) &&
            !QFileInfo::exists(m_folder.filePath("stolen.pdf")));
    QCOMPARE(as("bob", {"score", id}).exitCode, 0);
    QCOMPARE(as("theo", {"score", id}).exitCode, 0);
    for (const QJsonValue& session : object(cli({"session", "list"}))["sessions"].toArray())
        QCOMPARE(session["person"].toString(), QStringLiteral("simulated"));
    QCOMPARE(refusalFault(as("theo", {"user", "add", "eve", "--role", "trainee"}), 2,
                          {"create person", "administrator"}),
             QString());
}

void TestCliSessions::refusalsNameTheCommandOnce() {
    const CliRun run = cli({"train", "sphere_apex", "--operator", "expert", "--level", "9"});
    QCOMPARE(run.exitCode, 2);
    QCOMPARE(run.err.count("train: "), 1);
    QCOMPARE(cli({"session", "show", "x"}).err.count("session show: "), 1);
}

// Reading is no way around the wait after wrong passwords.
void TestCliSessions::readingCountsWrongPasswords() {
    CliRun run;
    for (int i = 0; i < 4; ++i)
        run = as("dave", {"session", "list"}, "not the word");
    QCOMPARE(refusalFault(run, 2, {"too many wrong passwords", "wait"}), QString());
}

void TestCliSessions::reportIsQuiet() {
    const CliRun run = runCli({"report", "1", "--pdf", m_folder.filePath("r.pdf"), "--database", m_database},
                              {}, {{"XDG_RUNTIME_DIR", ""}});
    QCOMPARE(run.exitCode, 0);
    QCOMPARE(run.err, QByteArray());
}

void TestCliSessions::noForcesNoForceMetrics() {
    const QJsonObject measured = object(runCli({"metrics", trace("plain.csv", 0), "--json"}));
    for (const char* id : {"force_max", "force_mean", "force_time_over_limit"}) {
        const QJsonValue metric = valueOf(measured, id);
        QVERIFY2(metric["value"].isNull(), id);
        QCOMPARE(metric["reason"].toString(), QStringLiteral("the trace has no forces"));
    }
    QVERIFY(valueOf(measured, "path_length")["value"].isDouble());
}

QTEST_GUILESS_MAIN(TestCliSessions)
#include "test_cli_sessions.moc"
