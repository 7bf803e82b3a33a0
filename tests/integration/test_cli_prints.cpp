// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"
#include "support/content_copy.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QtTest>

// What good command lines print: help with an example for everything, one JSON document with --json, numbers
// that are the law's.
class TestCliPrints : public QObject {
    Q_OBJECT
private slots:
    void helpOfEveryCommand_data();
    void helpOfEveryCommand();
    void helpOfGroupsAndAll();
    void versionOfTheProgram();
    void optionsBeforeTheCommand();
    void jsonIsOneDocument_data();
    void jsonIsOneDocument();
    void lawsAreListed();
    void hemisphereByHand();
    void hemisphereWithoutStiffness();
    void columnsInAnyOrder();
    void parametersChangeTheLaw();
    void palpationByHand();
    void polarForcesBothWays();
    void passMarksAsStored();
    void textsThatALanguageLacks();
    void metricsOfAStraightLine();
    void brokenPipeIsAnError();

private:
    QString file(const QString& name, const QByteArray& content) {
        QFile out(m_folder.filePath(name));
        if (!out.open(QIODevice::WriteOnly) || out.write(content) != content.size())
            qFatal("the test's own file could not be written");
        return out.fileName();
    }
    QTemporaryDir m_folder;
};

namespace {

const QByteArray kHeader = "px_m,py_m,pz_m,vx_m_per_s,vy_m_per_s,vz_m_per_s\n";

// Exactly one document: nothing before, nothing after.
QJsonDocument document(const CliRun& run) {
    QJsonParseError error;
    const QJsonDocument json = QJsonDocument::fromJson(run.out, &error);
    if (!run.ended || run.exitCode != 0 || error.error != QJsonParseError::NoError || json.isNull())
        qWarning("%s %s", qPrintable(error.errorString()), run.err.constData());
    return error.error == QJsonParseError::NoError ? json : QJsonDocument();
}

// The table's first row by column name.
QMap<QString, double> firstRow(const CliRun& run) {
    const QStringList lines = QString::fromUtf8(run.out).split(QLatin1Char('\n'));
    const QStringList names = lines.value(0).split(QLatin1Char(','));
    const QStringList cells = lines.value(1).split(QLatin1Char(','));
    QMap<QString, double> row;
    for (qsizetype i = 0; i < names.size(); ++i)
        row[names[i]] = cells.value(i).toDouble();
    return row;
}

} // namespace

void TestCliPrints::helpOfEveryCommand_data() {
    QTest::addColumn<QString>("name");
    for (const QString& name : cliCommands())
        QTest::newRow(qPrintable(name)) << name;
}

void TestCliPrints::helpOfEveryCommand() {
    QFETCH(QString, name);
    const CliRun run = runCli(name.split(QLatin1Char(' ')) + QStringList{"--help"});
    QVERIFY(run.ended);
    QCOMPARE(run.exitCode, 0);
    QVERIFY(run.err.isEmpty());
    QVERIFY(run.out.contains("\nUsage: chiron-cli " + name.toUtf8()));
    const qsizetype example = run.out.indexOf("\nExample:\n");
    QVERIFY(example > 0);
    QVERIFY2(run.out.mid(example).contains("chiron-cli " + name.toUtf8()), "the example shows this command");
    const QJsonDocument json =
        document(runCli(name.split(QLatin1Char(' ')) + QStringList{"--help", "--json"}));
    QCOMPARE(json.object().value("help").toString().toUtf8(), run.out);
}

void TestCliPrints::helpOfGroupsAndAll() {
    const CliRun all = runCli({"--help"});
    QCOMPARE(all.exitCode, 0);
    QVERIFY(all.out.contains("Example:"));
    for (const QString& name : cliCommands()) {
        QVERIFY(all.out.contains(name.toUtf8()));
        if (!name.contains(QLatin1Char(' ')))
            continue;
        const CliRun group = runCli({name.section(QLatin1Char(' '), 0, 0), "--help"});
        QCOMPARE(group.exitCode, 0);
        QVERIFY(group.out.contains(name.toUtf8()));
        QVERIFY(group.out.contains("Example:"));
    }
}

void TestCliPrints::versionOfTheProgram() {
    const CliRun words = runCli({"--version"}), json = runCli({"--version", "--json"});
    QVERIFY2(words.exitCode == 0 && words.out.startsWith("chiron-cli ") && words.err.isEmpty(),
             words.err.constData());
    const QJsonObject program = document(json).object()["program"].toObject();
    QVERIFY(QRegularExpression(QStringLiteral("^\\d+\\.\\d+\\.\\d+$"))
                .match(program["version"].toString())
                .hasMatch());
    QVERIFY(words.out.contains(program["version"].toString().toUtf8()) &&
            program["build"].toString().contains(QLatin1String("models")));
}

void TestCliPrints::optionsBeforeTheCommand() {
    const CliRun before = runCli({"--json", "--database", "x.db", "device", "list"});
    const CliRun behind = runCli({"device", "list", "--json"});
    QCOMPARE(before.exitCode, 0);
    QCOMPARE(before.out, behind.out);
    for (const char* asked : {"--version", "--help"}) {
        QVERIFY(document(runCli({"--json", asked})).isObject());
        QCOMPARE(runCli({"--json", asked}).out, runCli({asked, "--json"}).out);
    }
    QCOMPARE(runCli({"version"}).out, runCli({"--version"}).out);
    for (const char* asked : {"help", "-h"})
        QCOMPARE(runCli({asked}).out, runCli({"--help"}).out);
    QCOMPARE(runCli({"--json", "device"}).exitCode,
             2); // "device" alone is no command, and no request for help or version
}

void TestCliPrints::jsonIsOneDocument_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("input");
    const QString trace =
        file("line.csv", "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0.01,1,0,0\n0.02,2,0,0\n0.03,3,0,0\n");
    QTest::newRow("evaluate --list") << QStringList{"evaluate", "--list"} << QByteArray();
    QTest::newRow("evaluate") << QStringList{"evaluate", "hemisphere"} << kHeader + "0,0,0.019,0,0,0\n";
    QTest::newRow("evaluate no rows")
        << QStringList{"evaluate", "friction"} << QByteArray("normal_force_N,velocity_m_per_s\n");
    QTest::newRow("metrics") << QStringList{"metrics", trace} << QByteArray();
    QTest::newRow("device list") << QStringList{"device", "list"} << QByteArray();
    QTest::newRow("exercise list") << QStringList{"exercise", "list"} << QByteArray();
    QTest::newRow("exercise show") << QStringList{"exercise", "show", "sphere_apex", "--language", "el"}
                                   << QByteArray();
}

void TestCliPrints::jsonIsOneDocument() {
    QFETCH(QStringList, arguments);
    QFETCH(QByteArray, input);
    const CliRun json = runCli(arguments + QStringList{"--json"}, input);
    QVERIFY(!document(json).isNull());
    QVERIFY(json.err.isEmpty());
    const CliRun plain = runCli(arguments, input);
    QCOMPARE(plain.exitCode, 0);
    QVERIFY(!plain.out.isEmpty());
    QVERIFY2(QJsonDocument::fromJson(plain.out).isNull(), "without --json it is for people");
}

void TestCliPrints::lawsAreListed() {
    QStringList ids;
    for (const QJsonValue& law : document(runCli({"evaluate", "--list", "--json"})).array()) {
        ids << law["id"].toString();
        QVERIFY(!law["source"].toString().isEmpty());
        QVERIFY(!law["inputs"].toArray().isEmpty());
        QVERIFY(!law["outputs"].toArray().isEmpty());
        for (const QJsonValue& column : law["inputs"].toArray())
            QVERIFY2(!column["unit"].toString().isEmpty(), qPrintable(column["name"].toString()));
    }
    for (const char* id :
         {"hemisphere", "friction", "polar_forces", "polar_weight", "urethra-centreline", "urethra-profile",
          "urethra-surface", "elasticity", "strain-stiffening", "mass", "deformation", "roughness",
          "bristle-friction", "viscosity", "elastic-tube", "voigt", "palpation-contact", "palpation-lump"})
        QVERIFY2(ids.contains(QLatin1String(id)), id);
}

// 1 mm deep at the apex of a 20 mm sphere of 500 N/m: 0.5 N straight up, 0.25 mJ; nothing above the surface.
void TestCliPrints::hemisphereByHand() {
    const CliRun run = runCli({"evaluate", "hemisphere"}, kHeader + "0,0,0.019,0,0,0\n0,0,0.0201,0,0,0\n");
    QCOMPARE(run.exitCode, 0);
    const auto row = firstRow(run);
    QVERIFY(qAbs(row["fz_N"] - 0.5) < 1e-12);
    QVERIFY(qAbs(row["energy_J"] - 0.25e-3) < 1e-15);
    QCOMPARE(row["fx_N"], 0.0);
    QVERIFY(run.out.split('\n')[2].startsWith("0,0,0,"));
}

// A surface without stiffness answers with no force and is no mistake, though a force of 0 in contact is how
// a surface that would pull shows.
void TestCliPrints::hemisphereWithoutStiffness() {
    const QString parameters = file("soft.json", "{\"stiffness_N_per_m\": 0}");
    const CliRun run =
        runCli({"evaluate", "hemisphere", "--parameters", parameters}, kHeader + "0,0,0.019,0,0,0\n");
    QCOMPARE(run.exitCode, 0);
    QCOMPARE(firstRow(run)["fz_N"], 0.0);
}

void TestCliPrints::columnsInAnyOrder() {
    const CliRun usual = runCli({"evaluate", "hemisphere"}, kHeader + "0.001,0.002,0.018,0,0,0\n");
    const CliRun other =
        runCli({"evaluate", "hemisphere"},
               "pz_m,vx_m_per_s,py_m,vz_m_per_s,px_m,vy_m_per_s\r\n0.018,0,0.002,0,0.001,0\r\n");
    QCOMPARE(other.out, usual.out);
    const CliRun repeated =
        runCli({"evaluate", "hemisphere", "--with-inputs"}, kHeader + "0.001,0.002,0.018,0,0,0\n");
    QVERIFY(repeated.out.startsWith(kHeader.trimmed() + ","));
    QCOMPARE(firstRow(repeated)["py_m"], 0.002);
    QCOMPARE(firstRow(repeated)["fz_N"], firstRow(usual)["fz_N"]);
}

void TestCliPrints::parametersChangeTheLaw() {
    const QString parameters = file("p.json", "{\"stiffness_N_per_m\": 1000, \"centre_x_m\": 0.01}");
    const auto row = firstRow(
        runCli({"evaluate", "hemisphere", "--parameters", parameters}, kHeader + "0.01,0,0.019,0,0,0\n"));
    QVERIFY(qAbs(row["fz_N"] - 1.0) < 1e-12);
}

// P3's figure 6 at 1 mm, 2 mm and 3 mm; 1 N at 45° along the finger; models.md §3's first lump at 4 mm: +45
// %.
void TestCliPrints::palpationByHand() {
    auto row =
        firstRow(runCli({"evaluate", "voigt"},
                        "dx_m,dy_m,dz_m,vx_m_per_s,vy_m_per_s,vz_m_per_s\n0.001,0.002,0.003,0.1,0,-0.1\n"));
    QVERIFY(qAbs(row["fx_N"] - 0.805) < 1e-12 && qAbs(row["fy_N"] - 1.4) < 1e-12 &&
            qAbs(row["fz_N"] - 1.9445) < 1e-12);
    row = firstRow(runCli({"evaluate", "palpation-contact"}, "fx_N,fy_N,fz_N,nx,ny,nz\n0,-1,1,0,0,2\n"));
    QVERIFY(qAbs(row["alpha_rad"] - 0.785398163397448) < 1e-12 && qAbs(row["normal_force_N"] - 1.0) < 1e-12);
    QVERIFY(qAbs(row["pitch_rad"] - 0.523598775598299) < 1e-12 && row["roll_rad"] == 0.0 &&
            row["saturated"] == 1.0);
    const CliRun lump = runCli({"evaluate", "palpation-lump"}, "depth_m,rho_m\n0.004,0\n0.004,0.2\n");
    row = firstRow(lump);
    QVERIFY(qAbs(row["normal_force_N"] / (0.004 * 680.0 / 3.0) - 1.45) < 0.005 &&
            row["lateral_force_N"] == 0.0);
    QVERIFY(qAbs(row["energy_J"] - 0.5 * 680.0 / 3.0 * 16e-6 * (1.0 + row["chi"])) < 1e-15);
}

// P2's mapping is exact where heading or pitch is zero, and not elsewhere (models.md §2.1).
void TestCliPrints::polarForcesBothWays() {
    const QJsonArray laws = document(runCli({"evaluate", "--list", "--json"})).array();
    for (const QJsonValue& law : laws) {
        if (law["id"].toString() != QLatin1String("polar_forces"))
            continue;
        QStringList outputs;
        for (const QJsonValue& column : law["outputs"].toArray())
            outputs << column["name"].toString();
        const QString all = outputs.join(QLatin1Char(' '));
        QVERIFY2(all.contains("published") && all.contains("exact"), qPrintable(all));
        return;
    }
    QFAIL("no polar_forces");
}

// Every pass mark of every level: the text says the same limits as the document, and which way they go.
void TestCliPrints::passMarksAsStored() {
    int minima = 0, maxima = 0;
    for (const QJsonValue& listed : document(runCli({"exercise", "list", "--json"})).array()) {
        const QString id = listed["id"].toString();
        QVERIFY(!id.isEmpty());
        const QJsonObject exercise = document(runCli({"exercise", "show", id, "--json"})).object();
        const QStringList text =
            QString::fromUtf8(runCli({"exercise", "show", id}).out).split(QLatin1Char('\n'));
        qsizetype from = 0;
        for (const QJsonValue& level : exercise["levels"].toArray()) {
            while (from < text.size() &&
                   !text[from].startsWith(QStringLiteral("level %1, ").arg(level["level"].toInt())))
                ++from;
            QVERIFY2(from < text.size(), qPrintable(id));
            for (const QJsonValue& gate : level["gates"].toArray()) {
                const bool low = gate["minimum"].isDouble(), high = gate["maximum"].isDouble();
                minima += low;
                maxima += high;
                QString mark = low ? QStringLiteral(">= %1 ").arg(gate["minimum"].toDouble()) : QString();
                mark += high ? QStringLiteral("<= %1").arg(gate["maximum"].toDouble()) : QString();
                qsizetype at = from;
                while (at < text.size() && !text[at].startsWith(gate["metric"].toString() + QLatin1Char(' ')))
                    ++at;
                QVERIFY2(at < text.size() &&
                             text[at].trimmed().endsWith(QStringLiteral("  ") + mark.trimmed()),
                         qPrintable(id + ": " + text.value(at) + ": " + mark));
            }
            ++from;
        }
    }
    QVERIFY2(minima > 0 && maxima > 20,
             qPrintable(QStringLiteral("%1 minima, %2 maxima").arg(minima).arg(maxima)));
}

void TestCliPrints::metricsOfAStraightLine() {
    QByteArray csv = "t_s,x_mm,y_mm,z_mm\n";
    for (int i = 0; i <= 100; ++i)
        csv += QByteArray::number(i * 0.01, 'f', 2) + "," + QByteArray::number(i) + ",0,0\n";
    const QJsonObject json =
        document(runCli({"metrics", file("straight.csv", csv), "--metric", "path_length", "--json"}))
            .object();
    const QJsonArray metrics = json["metrics"].toArray();
    QCOMPARE(metrics.size(), 1);
    QCOMPARE(metrics[0]["id"].toString(), QStringLiteral("path_length"));
    QCOMPARE(metrics[0]["unit"].toString(), QStringLiteral("mm"));
    QVERIFY(qAbs(metrics[0]["value"].toDouble() - 100.0) <
            1.0); // 100 mm, less what the 20 Hz filter does at the ends
}

// Missing translations are no fault: they are named, and English is shown. The task is the same with and
// without them.
void TestCliPrints::textsThatALanguageLacks() {
    const ContentCopy content;
    const auto list = [&](const QStringList& more) {
        return runCli(QStringList{"exercise", "list", "--language", "de", "--content",
                                  QString::fromStdString(content.directory())} +
                      more);
    };
    const auto level = [](const CliRun& run) {
        return QJsonDocument::fromJson(run.out).array()[0].toObject()["levels"].toArray()[0].toObject();
    };
    QVERIFY(!list({}).out.contains("no text in"));
    const QJsonObject whole = level(list({"--json"}));
    QVERIFY(QFile::remove(content.path("exercises/sphere_apex/texts/de.json")));
    const CliRun run = list({});
    QCOMPARE(run.exitCode, 0);
    QVERIFY2(run.out.contains(content.path("exercises/sphere_apex/exercise.json").toUtf8() +
                              ": $.title: no text in de; English is shown\n"),
             run.out.constData());
    QVERIFY(run.out.contains("Visible sphere") && !run.out.contains("no text in el"));
    const QJsonObject lacking = level(list({"--json"}));
    QCOMPARE(whole["task_sha256"].toString().size(), 64);
    QCOMPARE(lacking["task_sha256"], whole["task_sha256"]);
    QVERIFY(lacking["content_sha256"] != whole["content_sha256"] && lacking["title"] != whole["title"]);
}

void TestCliPrints::brokenPipeIsAnError() {
    if (!QFile::exists("/dev/full"))
        QSKIP("this system has no /dev/full");
    QProcess process;
    process.start("/bin/sh",
                  {"-c", QStringLiteral("'%1' evaluate --list > /dev/full").arg(QStringLiteral(CHIRON_CLI))});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 4);
    QVERIFY(process.readAllStandardError().contains("stdout"));
}

QTEST_GUILESS_MAIN(TestCliPrints)
#include "test_cli_prints.moc"
