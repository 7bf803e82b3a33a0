// SPDX-License-Identifier: GPL-3.0-or-later
// Runs `chiron-cli demo` on a small catalogue, and checks that people, scripted sessions, study and reports
// are there and in the database.
#include "cli_process.h"
#include "support/content_copy.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QtTest>

#include <map>

namespace {

/// Keeps one exercise with its first two levels, each with one trial.
void makeSmall(const ContentCopy& content) {
    const QDir exercises(content.path(QStringLiteral("exercises")));
    for (const QString& exercise : exercises.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
        if (exercise != QLatin1String("sphere_apex"))
            QDir(exercises.filePath(exercise)).removeRecursively();
    QDir(exercises.filePath(QStringLiteral("sphere_apex/texts")))
        .removeRecursively(); // translations of levels that are gone
    const QDir levels(exercises.filePath(QStringLiteral("sphere_apex/levels")));
    for (const QString& level : levels.entryList(QDir::Files)) {
        const QString file = QStringLiteral("exercises/sphere_apex/levels/") + level;
        QJsonObject json = QJsonDocument::fromJson(content.read(file)).object();
        if (json["number"].toInt() > 2) {
            QFile::remove(content.path(file));
            continue;
        }
        QJsonObject parameters = json["parameters"].toObject();
        parameters["trials"] = 1;
        json["parameters"] = parameters;
        content.write(file, QJsonDocument(json).toJson());
    }
}

} // namespace

class TestCliDemo : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { makeSmall(m_content); }
    void makesAWholeSite();
    void makesNoneOverAnother();
    void refusesWhatItCannotUse_data();
    void refusesWhatItCannotUse();

private:
    CliRun demo(const QStringList& more) const {
        return runCli(QStringList{"demo"} + more, {},
                      {{"CHIRON_CONTENT", QString::fromStdString(m_content.directory())}});
    }

    ContentCopy m_content;
    QTemporaryDir m_folder;
    QString m_site = m_folder.filePath("site");
};

void TestCliDemo::makesAWholeSite() {
    const CliRun run = demo({"--folder", m_site, "--seed", "3", "--json"});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    QVERIFY2(run.err.contains("step 1 of ") && run.err.contains("verifying"), run.err.constData());
    const QJsonObject made = QJsonDocument::fromJson(run.out).object();
    QVERIFY(made["verify_ok"].toBool());
    QCOMPARE(made["folder"].toString(), m_site);
    QCOMPARE(made["database"].toString(), QDir(m_site).filePath("chiron.db"));
    for (const char* files : {"reports", "pictures"}) {
        QVERIFY(!made[QLatin1String(files)].toArray().isEmpty());
        for (const QJsonValue& file : made[QLatin1String(files)].toArray())
            QVERIFY2(QFileInfo(file.toString()).size() > 1000, qPrintable(file.toString()));
    }
    // Each of the four operators and the three trainees did both levels; two trainees did the first one
    // several times, better and better.
    std::map<std::pair<QString, int>, int> times;
    std::map<QString, QStringList>
        hands; // of each person at the first level, in the order in which they were done
    for (const QJsonValue& value : made["sessions"].toArray()) {
        const QJsonObject session = value.toObject();
        QCOMPARE(session["exercise"].toString(), QStringLiteral("sphere_apex"));
        QVERIFY(session["replay_identical"].toBool() && session["score_same"].toBool());
        QVERIFY(!session["metrics"].toArray().isEmpty());
        if (session["operator"].toString() == QLatin1String("unsafe"))
            QVERIFY(!session["passed"].toBool(true));
        ++times[{session["operator"].toString(), session["level"].toInt()}];
        if (session["level"].toInt() == 1)
            hands[session["person"].toString()] << session["operator"].toString();
    }
    for (const int level : {1, 2})
        QCOMPARE(times[std::pair(QStringLiteral("unsafe"), level)], 1);
    for (const char* trained : {"novice", "intermediate", "expert"})
        QCOMPARE(times[std::pair(QString::fromLatin1(trained), 2)],
                 2); // the simulated account's and a trainee's
    QCOMPARE(times.size(), std::size_t{8});
    QCOMPARE(hands[QStringLiteral("nikos")], QStringList({"novice", "novice", "novice", "intermediate"}));
    QCOMPARE(hands[QStringLiteral("ines")],
             QStringList({"novice", "novice", "intermediate", "intermediate", "expert"}));
    QCOMPARE(hands[QStringLiteral("eva")], QStringList{"expert"});
    QVERIFY2(run.err.contains("Ines Improving, attempt 5 of 5"), run.err.constData());

    // The database holds what the command reported, and its people can log in with the password that it
    // printed.
    const QMap<QString, QString> password{{"CHIRON_PASSWORD", made["password"].toString()}};
    const auto ask = [&](const QStringList& words, const char* as) {
        return QJsonDocument::fromJson(
            runCli(words + QStringList{"--as", as, "--database", made["database"].toString(), "--json"}, {},
                   password)
                .out);
    };
    QCOMPARE(ask({"user", "list"}, "amalia").array().size(), 6);
    const QJsonArray listed = ask({"session", "list"}, "theo").object()["sessions"].toArray();
    QCOMPARE(listed.size(), made["sessions"].toArray().size() + 1); // plus the study's rendered sitting
    QCOMPARE(runCli({"verify", "--database", made["database"].toString()}).exitCode, 0);
}

void TestCliDemo::makesNoneOverAnother() {
    QDir().mkpath(m_folder.filePath("taken"));
    QFile file(m_folder.filePath("taken/chiron.db"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
    file.close();
    const CliRun run = demo({"--folder", m_folder.filePath("taken")});
    const QString fault = refusalFault(run, 3, {"chiron.db", "exists already"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    QVERIFY(file.open(QIODevice::ReadOnly) && file.readAll() == "mine");
    QCOMPARE(QDir(m_folder.filePath("taken")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
             QStringList{"chiron.db"});
}

void TestCliDemo::refusesWhatItCannotUse_data() {
    QTest::addColumn<QStringList>("more");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("mention");
    QFile file(m_folder.filePath("a_file"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QTest::newRow("no seed") << QStringList{"--folder", m_folder.filePath("none"), "--seed", "many"} << 2
                             << QStringLiteral("many");
    QTest::newRow("a file where a folder should be")
        << QStringList{"--folder", m_folder.filePath("a_file/inside")} << 4
        << QStringLiteral("cannot be made");
}

void TestCliDemo::refusesWhatItCannotUse() {
    QFETCH(QStringList, more);
    QFETCH(int, exitCode);
    QFETCH(QString, mention);
    const QString fault = refusalFault(demo(more), exitCode, {mention});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    QVERIFY(!QFileInfo::exists(m_folder.filePath("none")));
}

QTEST_GUILESS_MAIN(TestCliDemo)
#include "test_cli_demo.moc"
