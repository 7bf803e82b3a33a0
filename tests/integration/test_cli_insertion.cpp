// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include "support/urethra_trace.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using namespace chiron;

// Urethra insertion from outside: a trace trained, scored, replayed, exported and scored again.
class TestCliInsertion : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void trainedScoredReplayedExported();
    void scoredByAnotherVersionOfItsMetrics();
    void aTraceWithoutOrientationIsRefused();

private:
    CliRun cli(const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", m_database, "--json"});
    }
    static QJsonObject object(const CliRun& run) {
        if (run.exitCode != 0)
            qWarning("%s", run.err.constData());
        return QJsonDocument::fromJson(run.out).object();
    }
    static QMap<QString, QJsonValue> valuesOf(const QJsonObject& document) {
        QMap<QString, QJsonValue> values;
        for (const QJsonValue& metric : document["metrics"].toArray())
            values[metric["id"].toString()] = metric["value"];
        return values;
    }
    QString write(const char* name, bool oriented);

    QTemporaryDir m_folder;
    QString m_database;
};

/// A perfect hand through the first level, as a file.
QString TestCliInsertion::write(const char* name, bool oriented) {
    simulation::UrethraInsertionParameters level;
    level.goalDepth_m = 0.060;
    level.anatomy.straight_m = 0.035;
    level.anatomy.zEnd_m = 0.100;
    const scoring::TraceRows trace = tests::idealTrace(level, 0.030);
    QByteArray text = oriented ? "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n" : "t_s,x_mm,y_mm,z_mm\n";
    const auto put = [&](double value, char after) { text += QByteArray::number(value, 'g', 15) + after; };
    for (const scoring::TraceRow& row : trace.rows) {
        put(row.t_s, ',');
        put(1000.0 * row.p_WT_m.x(), ',');
        put(1000.0 * row.p_WT_m.y(), ',');
        put(1000.0 * row.p_WT_m.z(), oriented ? ',' : '\n');
        if (!oriented)
            continue;
        put(row.q_WT.w(), ',');
        put(row.q_WT.x(), ',');
        put(row.q_WT.y(), ',');
        put(row.q_WT.z(), '\n');
    }
    QFile out(m_folder.filePath(QLatin1String(name)));
    if (!out.open(QIODevice::WriteOnly) || out.write(text) != text.size())
        qFatal("the test's own file could not be written");
    return out.fileName();
}

void TestCliInsertion::initTestCase() {
    m_database = m_folder.filePath("site.db");
}

void TestCliInsertion::trainedScoredReplayedExported() {
    const QJsonObject trained =
        object(cli({"train", "urethra_insertion", "--level", "1", "--operator", write("ideal.csv", true)}));
    const auto values = valuesOf(trained);
    QCOMPARE(values.size(), 24);
    QCOMPARE(values["critical_errors"].toDouble(-1.0), 0.0);
    QCOMPARE(values["procedure_completed"].toDouble(), 100.0);
    QCOMPARE(values["insertion_depth"].toDouble(), 60.0);
    QCOMPARE(values["trauma_events"].toDouble(-1.0), 0.0);
    QVERIFY(values["offset_rms"].isDouble() && values["offset_rms"].toDouble() < 0.1);
    QCOMPARE(trained["passed"].toBool(), true);
    const QString id = QString::number(trained["session_id"].toInt());
    QCOMPARE(object(cli({"score", id}))["same"].toBool(), true);
    QCOMPARE(object(cli({"replay", id}))["identical"].toBool(), true);
    const QString folder = m_folder.filePath("exported");
    QCOMPARE(cli({"session", "export", id, "--format", "csv,json", "--folder", folder}).exitCode, 0);
    const QString ids = QStringList(values.keys()).join(u',');
    const QJsonObject measured =
        object(runCli({"metrics", folder + "/session_" + id + ".csv", "--metric", ids, "--json"}));
    QCOMPARE(valuesOf(measured), values); // as exported, to the last digit
}

/// A metric that has no such version keeps the one before it. Another value than the stored one is then a
/// result and no failure; a version that no metric has is refused.
void TestCliInsertion::scoredByAnotherVersionOfItsMetrics() {
    const auto scored = [&](const char* version) {
        return cli({"score", "1", "--metric-version", QString::fromLatin1(version)});
    };
    const auto versionOf = [](const CliRun& run, const char* id) {
        for (const QJsonValue& metric : object(run)["metrics"].toArray())
            if (metric["id"].toString() == QLatin1String(id))
                return metric["version"].toInt();
        return 0;
    };
    const CliRun first = scored("1"), second = scored("2");
    QCOMPARE(first.exitCode, 0);
    QCOMPARE(second.exitCode, 0);
    QVERIFY(!object(first)["same"].toBool(true) && object(second)["same"].toBool()); // level 1 has the second
    QCOMPARE(versionOf(first, "critical_errors"), 1);
    QCOMPARE(versionOf(second, "critical_errors"), 2);
    for (const CliRun& run : {first, second})
        QCOMPARE(versionOf(run, "offset_rms"), 1);
    QCOMPARE(refusalFault(scored("9"), 3, {"score: ", "version 9"}), QString());
}

void TestCliInsertion::aTraceWithoutOrientationIsRefused() {
    const CliRun run =
        cli({"train", "urethra_insertion", "--level", "1", "--operator", write("flat.csv", false)});
    QCOMPARE(run.exitCode, 3);
    QVERIFY2(run.err.contains("qw"), run.err.constData());
}

QTEST_GUILESS_MAIN(TestCliInsertion)
#include "test_cli_insertion.moc"
