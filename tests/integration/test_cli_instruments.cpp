// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <cmath>

// Graspers from outside: what the catalogue says of instruments, two hands in one session, their samples
// exported and scored again, traces of one and of both, and the map by which the gimbal renders force.
class TestCliInstruments : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void theCatalogueTellsInstrumentsAndQuantities();
    void twoHandsAreExportedAndScoredTheSame();
    void anExportIsATraceOfBothHands();
    void aTraceThatLacksAHandIsRefused();
    void theForceMapIsChosenAndKept();
    void theForceMapIsRefusedWhereItMeansNothing();
    void theBaseIsMountedAsOneLikes();

private:
    CliRun cli(const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", m_database, "--json"});
    }
    QJsonObject object(const CliRun& run) {
        if (run.exitCode != 0)
            qWarning("%s", run.err.constData());
        return QJsonDocument::fromJson(run.out).object();
    }
    QJsonArray devicesOf(const QJsonObject& trained) {
        return object(cli({"session", "show", QString::number(trained["session_id"].toInt())}))["devices"]
            .toArray();
    }
    /// A trace file with rows of these tools, one second, jaw open.
    QString trace(const QString& name, const QList<int>& tools);

    QTemporaryDir m_folder;
    QString m_database;
    QJsonObject m_twoHanded;
    QString m_export;
};

namespace {

constexpr int kTwoHanded = 4; // level of elastic_tube

QMap<QString, QJsonValue> valuesOf(const QJsonArray& metrics) {
    QMap<QString, QJsonValue> values;
    for (const QJsonValue& metric : metrics)
        values[metric["id"].toString()] = metric["value"];
    return values;
}

QString idsOf(const QJsonObject& document) {
    return QStringList(valuesOf(document["metrics"].toArray()).keys()).join(u',');
}

} // namespace

void TestCliInstruments::initTestCase() {
    QVERIFY(m_folder.isValid());
    m_database = m_folder.filePath("site.db");
}

QString TestCliInstruments::trace(const QString& name, const QList<int>& tools) {
    QByteArray text = "t_s,x_mm,y_mm,z_mm,jaw_deg,tool\n";
    for (int i = 0; i < 50; ++i)
        for (const int tool : tools)
            text += QStringLiteral("%1,%2,0,50,60,%3\n")
                        .arg(0.02 * i)
                        .arg(tool == 0 ? 40 : -40)
                        .arg(tool)
                        .toUtf8();
    QFile out(m_folder.filePath(name));
    if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size())
        qFatal("the test's own file could not be written");
    return out.fileName();
}

void TestCliInstruments::theCatalogueTellsInstrumentsAndQuantities() {
    const QJsonArray tube =
        object(runCli({"exercise", "show", "elastic_tube", "--json"}))["levels"].toArray();
    QVERIFY(tube.size() >= kTwoHanded);
    QCOMPARE(tube[0]["tools"].toInt(), 1);
    QCOMPARE(tube[kTwoHanded - 1]["tools"].toInt(), 2);
    QVERIFY(tube[0]["mounting"].toArray().isEmpty());
    QCOMPARE(tube[tube.size() - 1]["tools"].toInt(),
             3); // two hands and a retractor, as the level mounts them
    QCOMPARE(tube[tube.size() - 1]["mounting"].toArray().size(), qsizetype{3});
    QVERIFY(std::abs(tube[tube.size() - 1]["mounting"].toArray()[2].toObject()["tilt_deg"].toDouble() +
                     10.0) < 1e-9);
    const QJsonArray quantities = tube[0]["quantities"].toArray();
    QVERIFY(!quantities.isEmpty());
    QCOMPARE(quantities[0]["id"].toString(), QStringLiteral("tension_N"));
    QCOMPARE(quantities[0]["unit"].toString(), QStringLiteral("N"));
    QVERIFY(quantities[0]["resolution"].toDouble() > 0.0);
    const QJsonArray apex = object(runCli({"exercise", "show", "sphere_apex", "--json"}))["levels"].toArray();
    QCOMPARE(apex[0]["tools"].toInt(), 1);
    QVERIFY(apex[0]["quantities"].toArray().isEmpty());
    const CliRun words = runCli({"exercise", "show", "elastic_tube"});
    QVERIFY2(words.out.contains("instruments: 2") && words.out.contains("tension_N"), words.out.constData());
    QVERIFY(runCli({"exercise", "list"}).out.contains("tools"));
}

/// data.md: scores are computed from stored channels, and from an exported file to the last digit.
void TestCliInstruments::twoHandsAreExportedAndScoredTheSame() {
    m_twoHanded = object(cli({"train", "elastic_tube", "--level", QString::number(kTwoHanded), "--operator",
                              "expert", "--seed", "3"}));
    QCOMPARE(m_twoHanded["state"].toString(), QStringLiteral("completed"));
    const QString id = QString::number(m_twoHanded["session_id"].toInt());
    QCOMPARE(devicesOf(m_twoHanded).size(), 2);
    QCOMPARE(object(cli({"replay", id}))["identical"].toBool(), true);
    QCOMPARE(object(cli({"score", id}))["same"].toBool(), true);
    QCOMPARE(cli({"session", "export", id, "--format", "csv", "--folder", m_folder.path()}).exitCode, 0);
    m_export = m_folder.filePath("session_" + id + ".csv");
    QFile file(m_export);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray header = file.readLine();
    for (const char* column :
         {"jaw_deg", "tool", "quantity_tension_N", "truth_target_N", "failed", "completed"})
        QVERIFY2(header.contains(column), column);
    const QJsonObject again = object(runCli({"metrics", m_export, "--metric", idsOf(m_twoHanded), "--json"}));
    QCOMPARE(valuesOf(again["metrics"].toArray()), valuesOf(m_twoHanded["metrics"].toArray()));
    const QJsonArray before = m_twoHanded["trials"].toArray();
    const QJsonArray after = again["trials"].toArray();
    QCOMPARE(after.size(), before.size());
    for (qsizetype i = 0; i < before.size(); ++i)
        QCOMPARE(valuesOf(after[i]["metrics"].toArray()), valuesOf(before[i]["metrics"].toArray()));
}

/// What one session recorded plays both instruments of another.
void TestCliInstruments::anExportIsATraceOfBothHands() {
    QVERIFY(!m_export.isEmpty());
    const QJsonObject played = object(cli({"train", "elastic_tube", "--level", QString::number(kTwoHanded),
                                           "--operator", m_export, "--seed", "3"}));
    QVERIFY(played["session_id"].toInt() > 0);
    const QJsonArray devices = devicesOf(played);
    QCOMPARE(devices.size(), 2);
    for (const QJsonValue& device : devices)
        QCOMPARE(device["driver"].toString(), QStringLiteral("replay"));
    QCOMPARE(object(cli({"replay", QString::number(played["session_id"].toInt())}))["identical"].toBool(),
             true);
}

void TestCliInstruments::aTraceThatLacksAHandIsRefused() {
    const QString level = QString::number(kTwoHanded);
    const CliRun one = cli({"train", "elastic_tube", "--level", level, "--operator", trace("one.csv", {0})});
    QCOMPARE(one.exitCode, 3);
    QVERIFY2(
        one.err.contains("one.csv: no row of tool 1; the level needs rows of tools 0 to 1 (column tool)"),
        one.err.constData());
    const CliRun left =
        cli({"train", "elastic_tube", "--level", level, "--operator", trace("left.csv", {1})});
    QCOMPARE(left.exitCode, 3);
    QVERIFY2(left.err.contains("no row of tool 0"), left.err.constData());
    QCOMPARE(
        cli({"train", "elastic_tube", "--level", level, "--operator", trace("both.csv", {0, 1})}).exitCode,
        0);
    QFile bare(m_folder.filePath("bare.csv"));
    QVERIFY(bare.open(QIODevice::WriteOnly) && bare.write("t_s,x_mm,y_mm,z_mm\n0,0,0,50\n1,0,0,50\n") > 0);
    bare.close();
    const CliRun noJaw = cli({"train", "elastic_tube", "--operator", bare.fileName()});
    QCOMPARE(noJaw.exitCode, 3);
    QVERIFY2(noJaw.err.contains("bare.csv: no jaw; a grasper needs the column jaw_deg"),
             noJaw.err.constData());
}

void TestCliInstruments::theForceMapIsChosenAndKept() {
    const auto train = [this](const QStringList& map) {
        return object(cli(QStringList{"train", "sphere_apex", "--operator", "novice", "--seed", "11"} + map));
    };
    const QJsonObject exact = train({});
    const QJsonObject published = train({"--force-map", "as-published"});
    QCOMPARE(devicesOf(exact).at(0).toObject()["force_map"].toString(), QStringLiteral("exact"));
    QCOMPARE(devicesOf(published).at(0).toObject()["force_map"].toString(), QStringLiteral("as-published"));
    QVERIFY(valuesOf(exact["metrics"].toArray()) != valuesOf(published["metrics"].toArray())); // it is felt
    QCOMPARE(object(cli({"replay", QString::number(published["session_id"].toInt())}))["identical"].toBool(),
             true);
}

void TestCliInstruments::theForceMapIsRefusedWhereItMeansNothing() {
    const CliRun fiveBar =
        cli({"train", "urethra_insertion", "--operator", "novice", "--force-map", "as-published"});
    QCOMPARE(fiveBar.exitCode, 2);
    QVERIFY2(fiveBar.err.contains("of exercise urethra_insertion has no such map"), fiveBar.err.constData());
    const CliRun played =
        cli({"train", "elastic_tube", "--operator", trace("map.csv", {0}), "--force-map", "as-published"});
    QCOMPARE(played.exitCode, 2);
    QVERIFY2(played.err.contains("a trace feels nothing"), played.err.constData());
    const CliRun word = cli({"train", "sphere_apex", "--operator", "novice", "--force-map", "polar"});
    QVERIFY(word.exitCode == 2 || word.exitCode == 3);
    QVERIFY2(word.err.contains("as-published"), word.err.constData());
}

/// P2's flexible mounting: the same hands reach the same tube with bases that stand askew; stored, replayed
/// and scored alike.
void TestCliInstruments::theBaseIsMountedAsOneLikes() {
    const QJsonObject turned =
        object(cli({"train", "elastic_tube", "--level", QString::number(kTwoHanded), "--operator", "expert",
                    "--seed", "3", "--base-turn", "15,10,-5"}));
    QCOMPARE(turned["state"].toString(), QStringLiteral("completed"));
    QCOMPARE(turned["passed"].toBool(), true);
    for (const QJsonValue& device : devicesOf(turned))
        QCOMPARE(device.toObject()["base_turn"].toArray().size(), 4);
    const QString id = QString::number(turned["session_id"].toInt());
    QCOMPARE(object(cli({"replay", id}))["identical"].toBool(), true);
    QCOMPARE(object(cli({"score", id}))["same"].toBool(), true);
    QCOMPARE(cli({"session", "export", id, "--format", "csv", "--folder", m_folder.path()}).exitCode, 0);
    const QJsonObject again = object(runCli(
        {"metrics", m_folder.filePath("session_" + id + ".csv"), "--metric", idsOf(turned), "--json"}));
    QCOMPARE(valuesOf(again["metrics"].toArray()),
             valuesOf(turned["metrics"].toArray())); // poses in W, forces alike
    for (const char* bad : {"15", "15,10", "60,0,0", "a,b,c", "0,0,0,0"}) {
        const CliRun refused = cli({"train", "elastic_tube", "--operator", "expert", "--base-turn", bad});
        QCOMPARE(refused.exitCode, 3);
        QVERIFY2(refused.err.contains("--base-turn") && refused.err.contains("three angles"),
                 refused.err.constData());
    }
    const CliRun point = cli({"train", "sphere_apex", "--operator", "expert", "--base-turn", "5,0,0"});
    QCOMPARE(point.exitCode, 2);
    QVERIFY2(point.err.contains("stands as it is built"), point.err.constData());
}

QTEST_GUILESS_MAIN(TestCliInstruments)
#include "test_cli_instruments.moc"
