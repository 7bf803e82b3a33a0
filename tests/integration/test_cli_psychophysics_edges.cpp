// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <array>
#include <cmath>
#include <cstddef>

// What the psychophysics commands must not take in silence, or make a number of.
class TestCliPsychophysicsEdges : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void answersThatAreNone_data();
    void answersThatAreNone();
    void linesOfCarriageReturnsAlone();
    void stopsByTheGivenRulesAlone();
    void largeTables();
    void noBetterThanGuessing_data();
    void noBetterThanGuessing();
    void aRateWithoutAnEnd_data();
    void aRateWithoutAnEnd();
    void countsGivenTwice();
    void tablesOfCounts();
    void tablesThatHoldNoCounts_data();
    void tablesThatHoldNoCounts();
    void fitsOfWhatIsNotThere();
    void rowsLeftOutAreNamed();
    void tauOfEachJudge();
    void ranksThatAreNone();
    void rankingsLeftOut();
    void pairsRefused_data();
    void pairsRefused();

private:
    QString file(const QString& name, const QByteArray& content) {
        QFile out(m_folder.filePath(name));
        if (!out.open(QIODevice::WriteOnly) || out.write(content) < 0)
            qFatal("the test's own file could not be written");
        return out.fileName();
    }
    QTemporaryDir m_folder;
};

namespace {

const QByteArray kStaircase = R"({"kind":"staircase","start":1,"stop":{"trials":5}})";
const QByteArray kTwoOutcomes =
    R"({"kind":"quest_plus","stimuli":[{"name":"x","values":[1,2,3]}],"parameters":[{"name":"threshold","values":[1,2]},
    {"name":"slope","values":[1]},{"name":"lower_asymptote","values":[0.5]},{"name":"lapse_rate","values":[0.02]}]})";

QJsonObject object(const QByteArray& text) {
    return QJsonDocument::fromJson(text).object();
}

bool warns(const QJsonValue& of, const char* token) {
    for (const QJsonValue& warning : of.toObject()["warnings"].toArray())
        if (warning.toString().startsWith(QLatin1String(token) + QLatin1String(": ")))
            return true;
    return false;
}

} // namespace

void TestCliPsychophysicsEdges::answersThatAreNone_data() {
    QTest::addColumn<QByteArray>("procedure");
    QTest::addColumn<QByteArray>("answer");
    QTest::newRow("an order to a staircase") << kStaircase << QByteArray("b<a<c\n");
    QTest::newRow("a right order to a staircase") << kStaircase << QByteArray("a<b<c\n");
    QTest::newRow("an order to two outcomes") << kTwoOutcomes << QByteArray("a<b<c\n");
    QTest::newRow("one outcome too many") << kStaircase << QByteArray("2\n");
    QTest::newRow("less than") << kStaircase << QByteArray("<\n");
    QTest::newRow("a null byte") << kStaircase << QByteArray("1\0\n", 3);
    QTest::newRow("a sign") << kStaircase << QByteArray("+1\n");
}

/// Nothing that is no answer counts as a wrong one.
void TestCliPsychophysicsEdges::answersThatAreNone() {
    QFETCH(QByteArray, procedure);
    QFETCH(QByteArray, answer);
    const CliRun run =
        runCli({"psychophysics", "adaptive", "--procedure", file("procedure.json", procedure)}, answer);
    QCOMPARE(run.exitCode, 3);
    QVERIFY2(run.err.contains("stdin line 1: ") && run.err.contains("expected 0, 1, undo or spoiled"),
             run.err.constData());
    QCOMPARE(run.out.count('\n'), 1);
}

/// "1\r0\r" is no answer 1 to a stimulus of 0; "1\r\n" is one line.
void TestCliPsychophysicsEdges::linesOfCarriageReturnsAlone() {
    const QString path = file("procedure.json", kStaircase);
    const CliRun bare = runCli({"psychophysics", "adaptive", "--procedure", path}, "1\r0\r");
    QCOMPARE(bare.exitCode, 3);
    QVERIFY2(bare.err.contains(
                 "stdin line 1: a carriage return within the line: expected lines that end in a line feed"),
             bare.err.constData());
    const CliRun later = runCli({"psychophysics", "adaptive", "--procedure", path}, "1\n1\r0\n");
    QVERIFY2(later.exitCode == 3 && later.err.contains("stdin line 2: "), later.err.constData());
    const CliRun both = runCli({"psychophysics", "adaptive", "--procedure", path}, "1\r\n0\r\n1\r");
    QVERIFY2(both.exitCode == 0, both.err.constData());
    QCOMPARE(object(both.out.trimmed().split('\n').last())["trial"].toInt(), 3);
}

/// The rules that are given replace the default ones whole: four trials are four, also where twenty are the
/// default's least.
void TestCliPsychophysicsEdges::stopsByTheGivenRulesAlone() {
    const QString path = file(
        "rank3.json", R"({"kind":"rank3_quest_plus","differences":[0.02,0.05,0.1],"stop":{"trials":4}})");
    const CliRun run = runCli({"psychophysics", "adaptive", "--procedure", path}, "0\n0\n1\n0\n");
    QVERIFY2(run.exitCode == 0, run.err.constData());
    const QList<QByteArray> lines = run.out.trimmed().split('\n');
    QCOMPARE(lines.size(), 6);
    QVERIFY(!object(lines[3])["done"].toBool());
    QVERIFY(object(lines[4])["done"].toBool());
    const QString staircase =
        file("staircase.json", R"({"kind":"staircase","start":50,"stop":{"reversals":2}})");
    const CliRun longer =
        runCli({"psychophysics", "adaptive", "--procedure", staircase}, QByteArray("1\n").repeated(100));
    QVERIFY(!object(longer.out.trimmed().split('\n').last())["done"].toBool());
}

/// Some megabytes of probabilities.
void TestCliPsychophysicsEdges::largeTables() {
    QByteArray cells;
    constexpr int kCells = 20'000;
    for (int i = 0; i < kCells; ++i)
        cells += (i > 0 ? "," : "") + QByteArray::number(0.1 + 0.8 * i / kCells, 'f', 6);
    QByteArray others;
    QByteArray values;
    for (int i = 0; i < kCells; ++i) {
        others += (i > 0 ? "," : "") + QByteArray::number(0.9 - 0.8 * i / kCells, 'f', 6);
        values += (i > 0 ? "," : "") + QByteArray::number(i);
    }
    const auto rows = [](const QByteArray& row) {
        return "[[" + row + "],[" + row + "],[" + row + "],[" + row + "]]";
    };
    const QByteArray json =
        R"({"kind":"quest_plus","function":"table","outcomes":2,"stimuli":[{"name":"x","values":[1,2,3,4]}],"parameters":[{"name":"a","values":[)" +
        values + R"(]}],"table":[)" + rows(cells) + "," + rows(others) + "]}";
    QVERIFY(json.size() > 1 << 20);
    const CliRun run = runCli({"psychophysics", "adaptive", "--procedure", file("table.json", json)}, "1\n");
    QVERIFY2(run.exitCode == 0, run.err.left(300).constData());
    QCOMPARE(run.out.count('\n'), 3);
}

void TestCliPsychophysicsEdges::noBetterThanGuessing_data() {
    QTest::addColumn<QStringList>("options");
    for (const char* task : {"2afc", "mafc", "triangle", "oddity", "abx", "tetrad"})
        QTest::newRow(task) << QStringList{"--task", task, "--proportion", "0.2"};
    QTest::newRow("same-different") << QStringList{
        "--task", "same-different", "--rule", "independent",          "--hits", "10", "--misses",
        "30",     "--false-alarms", "20",     "--correct-rejections", "20"};
}

void TestCliPsychophysicsEdges::noBetterThanGuessing() {
    QFETCH(QStringList, options);
    const CliRun run = runCli(QStringList{"psychophysics", "dprime", "--json"} + options);
    QVERIFY2(run.exitCode == 0, run.err.constData());
    QVERIFY2(warns(object(run.out), "chance"), run.out.constData());
}

void TestCliPsychophysicsEdges::aRateWithoutAnEnd_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<bool>("endless");
    for (const char* task : {"2afc", "mafc", "triangle", "abx", "tetrad"})
        for (const char* proportion : {"0.9", "1"})
            QTest::addRow("%s, %s", task, proportion)
                << QStringList{"--task", task, "--proportion", proportion}
                << (QLatin1String(proportion) == QLatin1String("1"));
    const auto answered = [](const char* hits, const char* misses, const char* alarms,
                             const char* rejections) {
        return QStringList{"--task",   "yes-no", "--uncorrected",  "--hits", hits,
                           "--misses", misses,   "--false-alarms", alarms,   "--correct-rejections",
                           rejections};
    };
    QTest::newRow("every signal is told") << answered("50", "0", "7", "43") << true;
    QTest::newRow("never a false alarm") << answered("40", "10", "0", "50") << true;
    QTest::newRow("some of each") << answered("40", "10", "7", "43") << false;
}

/// Where a rate is 0 or 1, d' has no value, and that is said; elsewhere nothing is said of it.
void TestCliPsychophysicsEdges::aRateWithoutAnEnd() {
    QFETCH(QStringList, options);
    QFETCH(bool, endless);
    const CliRun run = runCli(QStringList{"psychophysics", "dprime", "--json"} + options);
    QVERIFY2(run.exitCode == 0, run.err.constData());
    QCOMPARE(warns(object(run.out), "no_limit"), endless);
    QCOMPARE(object(run.out)["d_prime"].isDouble(), !endless);
}

void TestCliPsychophysicsEdges::countsGivenTwice() {
    const QString table = file("counts.csv", "n_correct,n_total\n5,10\n");
    QString fault = refusalFault(
        runCli({"psychophysics", "dprime", table, "--task", "2afc", "--correct", "3", "--total", "5"}), 2,
        QStringList{"--correct beside a table"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    fault = refusalFault(runCli({"psychophysics", "dprime", "--task", "2afc", "--correct", "3", "--total",
                                 "5", "--proportion", "0.6"}),
                         2, QStringList{"beside --proportion"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

/// d' of each line of a table is d' of the same counts as options, wherever its columns stand.
void TestCliPsychophysicsEdges::tablesOfCounts() {
    const auto lines = [](const QStringList& arguments) {
        const CliRun run = runCli(QStringList{"psychophysics", "dprime"} + arguments + QStringList{"--json"});
        return object(run.out);
    };
    const QJsonObject pairs =
        lines({file("pairs.csv", "n_correct,n_total,who\n40,50,a\n30,50,b\n"), "--task", "2afc"});
    const QJsonArray two = pairs["rows"].toArray();
    QCOMPARE(two.size(), 2);
    const QJsonObject first = lines({"--task", "2afc", "--correct", "40", "--total", "50"}),
                      second = lines({"--task", "2afc", "--correct", "30", "--total", "50"});
    QVERIFY(first["d_prime"].toDouble() > second["d_prime"].toDouble() && second["d_prime"].toDouble() > 0.0);
    QCOMPARE(two[0].toObject()["d_prime"], first["d_prime"]);
    QCOMPARE(two[1].toObject()["d_prime"], second["d_prime"]);
    const QJsonArray rates = lines({file(
        "rates.csv", "correct_rejections,hits,misses,false_alarms\n40,35,15,10\n45,20,30,5\n")})["rows"]
                                 .toArray();
    QCOMPARE(rates.size(), 2);
    QCOMPARE(rates[0].toObject()["d_prime"], lines({"--hits", "35", "--misses", "15", "--false-alarms", "10",
                                                    "--correct-rejections", "40"})["d_prime"]);
    QCOMPARE(rates[1].toObject()["d_prime"], lines({"--hits", "20", "--misses", "30", "--false-alarms", "5",
                                                    "--correct-rejections", "45"})["d_prime"]);
}

void TestCliPsychophysicsEdges::tablesThatHoldNoCounts_data() {
    QTest::addColumn<QByteArray>("table");
    QTest::addColumn<QString>("task");
    QTest::addColumn<QStringList>("words");
    QTest::newRow("no column") << QByteArray("n_correct\n5\n") << "2afc"
                               << QStringList{"counts.csv:1", "column n_total is missing"};
    QTest::newRow("none of four") << QByteArray("hits,misses,false_alarms\n5,5,5\n") << "yes-no"
                                  << QStringList{"counts.csv:1", "correct_rejections"};
    QTest::newRow("half a trial") << QByteArray("n_correct,n_total\n5,10\n4.5,10\n") << "2afc"
                                  << QStringList{"counts.csv:3", "n_correct", "a whole number from 0 to 1e9"};
    QTest::newRow("below nothing") << QByteArray("n_correct,n_total\n-1,10\n") << "2afc"
                                   << QStringList{"counts.csv:2", "a whole number from 0 to 1e9"};
    QTest::newRow("too many") << QByteArray("n_correct,n_total\n5,2e9\n") << "2afc"
                              << QStringList{"counts.csv:2", "n_total", "a whole number from 0 to 1e9"};
    QTest::newRow("more than all") << QByteArray("n_correct,n_total\n11,10\n") << "2afc"
                                   << QStringList{"counts.csv:2", "at most n_total"};
}

void TestCliPsychophysicsEdges::tablesThatHoldNoCounts() {
    QFETCH(QByteArray, table);
    QFETCH(QString, task);
    QFETCH(QStringList, words);
    const QString fault = refusalFault(
        runCli({"psychophysics", "dprime", file("counts.csv", table), "--task", task}), 3, words);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

void TestCliPsychophysicsEdges::fitsOfWhatIsNotThere() {
    const QByteArray head = "intensity,n_correct,n_total\n";
    const QString levels = file("levels.csv", head + "1,10,20\n2,12,20\n3,15,20\n4,19,20\n5,20,20\n");
    const CliRun below = runCli({"psychophysics", "fit", levels, "--threshold-at", "0.4", "--json"});
    QVERIFY2(below.exitCode == 0 &&
                 object(below.out).value("threshold_at").toObject().value("value").isNull() &&
                 warns(object(below.out), "never_reached"),
             below.out.constData());
    QVERIFY(warns(object(runCli({"psychophysics", "fit", levels, "--reference", "0", "--json"}).out),
                  "no_reference"));
    const CliRun read = runCli(
        {"psychophysics", "fit", levels, "--threshold-at", "0.75", "--reference", "2", "--curve", "3"});
    for (const char* asked : {"threshold at 0.75: ", "Weber fraction at 2: ", "intensity"})
        QVERIFY2(read.out.contains(asked), read.out.constData());
    QString fault = refusalFault(runCli({"psychophysics", "fit", levels, "--guess", "0.6", "--lapse", "0.5"}),
                                 2, QStringList{"--guess", "less than 1 together"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    fault = refusalFault(runCli({"psychophysics", "fit", file("many.csv", head + "1,10,20\n2,15,1e12\n")}), 3,
                         QStringList{"many.csv:3: column n_total", "at most 1e9"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    fault = refusalFault(
        runCli({"psychophysics", "fit", file("sum.csv", head + "1,10,20\n2,15,6e8\n3,15,6e8\n")}), 3,
        QStringList{"sum.csv:4: column n_total", "of all rows together"});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

/// Rows that cannot be used are named by their lines; standard errors are told beside intervals.
void TestCliPsychophysicsEdges::rowsLeftOutAreNamed() {
    const CliRun run = runCli(
        {"psychophysics", "fit",
         file("holes.csv",
              "intensity,n_correct,n_total\n1,3,30\n2,,30\n# a note\n3,14,30\n4,31,30\n5,28,30\n6,29,30\n"),
         "--method", "ml", "--guess", "0", "--json"});
    const QJsonObject fit = object(run.out);
    QVERIFY2(fit["warnings"].toArray().first().toString().contains(QStringLiteral("holes.csv: lines 3, 6)")),
             run.out.constData());
    QVERIFY(fit["error"].toObject()["threshold"].toDouble() > 0.0 &&
            fit["error"].toObject()["width"].toDouble() > 0.0);
}

/// Of each judge with the expected order: 1, a neighbour swapped (1/3), all turned round.
void TestCliPsychophysicsEdges::tauOfEachJudge() {
    const CliRun run =
        runCli({"psychophysics", "rank", file("ranks.csv", "a,b,c\n1,2,3\n1,3,2\n3,2,1\n1,,2\n"), "--json"});
    const QJsonObject tau = object(run.out)["kendall_tau"].toObject();
    const QJsonArray each = tau["each"].toArray();
    QCOMPARE(each.size(), 4);
    const std::array expected{1.0, 1.0 / 3.0, -1.0};
    for (int i = 0; i < 3; ++i)
        QVERIFY(std::abs(each[i].toObject()["tau"].toDouble() - expected[static_cast<std::size_t>(i)]) <
                1e-12);
    QVERIFY(each[3].toObject()["tau"].isNull());
    QCOMPARE(tau["judges"].toInt(), 3);
    QVERIFY(std::abs(tau["mean"].toDouble() - 1.0 / 9.0) < 1e-12);
    const QJsonObject turned =
        object(runCli({"psychophysics", "rank", m_folder.filePath("ranks.csv"), "--order", "c,b,a", "--json"})
                   .out)["kendall_tau"]
            .toObject();
    QVERIFY(std::abs(turned["mean"].toDouble() + 1.0 / 9.0) < 1e-12);
}

void TestCliPsychophysicsEdges::ranksThatAreNone() {
    const CliRun run =
        runCli({"psychophysics", "rank", file("ranks.csv", "a,b,c\n1,2,7\n2,1,-3\n3,1,2\n"), "--json"});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    QVERIFY2(warns(object(run.out), "not_ranks"), run.out.constData());
    QVERIFY(object(run.out)["warnings"].toArray()[0].toString().contains(" 2 rows"));
    const CliRun midranks =
        runCli({"psychophysics", "rank", file("ranks.csv", "a,b,c\n1.5,1.5,3\n2,1,3\n"), "--json"});
    QVERIFY2(!warns(object(midranks.out), "not_ranks"), midranks.out.constData());
}

void TestCliPsychophysicsEdges::rankingsLeftOut() {
    const CliRun run = runCli(
        {"psychophysics", "rank", file("ranks.csv", "a,b,c\n1,2,3\n2,3,1\n3,1,2\n1,1,2\n1,2,\n"), "--json"});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    for (const char* model : {"plackett_luce", "thurstone"})
        QVERIFY2(warns(object(run.out)[QLatin1String(model)], "left_out"), run.out.constData());
}

void TestCliPsychophysicsEdges::pairsRefused_data() {
    QTest::addColumn<QByteArray>("table");
    QTest::addColumn<QString>("mention");
    QTest::newRow("no loser") << QByteArray("winner,loser\na,b\nb,\n") << "pairs.csv:3: column loser";
    QTest::newRow("no winner") << QByteArray("winner,loser\n,b\n") << "pairs.csv:2: column winner";
    QTest::newRow("more than can be counted")
        << QByteArray("winner,loser,count\na,b,1e300\nb,a,2\n") << "pairs.csv:2: column count";
}

void TestCliPsychophysicsEdges::pairsRefused() {
    QFETCH(QByteArray, table);
    QFETCH(QString, mention);
    const QString fault =
        refusalFault(runCli({"psychophysics", "rank", file("pairs.csv", table)}), 3, {mention});
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

QTEST_GUILESS_MAIN(TestCliPsychophysicsEdges)
#include "test_cli_psychophysics_edges.moc"
