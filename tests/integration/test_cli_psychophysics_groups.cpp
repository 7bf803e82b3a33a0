// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <cmath>
#include <utility>

// `psychophysics fit --by` and `psychophysics compare`: one fit for each group, and whether groups differ.
class TestCliPsychophysicsGroups : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void eachGroupIsFittedAlone();
    void groupsByTwoColumns();
    void impossibleTrials_data();
    void impossibleTrials();
    void groupsRefused_data();
    void groupsRefused();
    void likelihoodsOfTheModels();
    void differencesAreFound();
    void pairsOfThree();
    void comparisonsRefused_data();
    void comparisonsRefused();

private:
    QString file(const QString& name, const QByteArray& content) {
        QFile out(m_folder.filePath(name));
        if (!out.open(QIODevice::WriteOnly) || out.write(content) < 0)
            qFatal("the test's own file could not be written");
        return out.fileName();
    }
    QJsonObject answer(const QStringList& arguments) {
        const CliRun run = runCli(QStringList{"psychophysics"} + arguments + QStringList{"--json"});
        if (run.exitCode != 0)
            qWarning("%s", run.err.constData());
        return QJsonDocument::fromJson(run.out).object();
    }
    QTemporaryDir m_folder;
};

namespace {

constexpr int kOf = 40;
const QList<double> kIntensities{1, 2, 3, 4, 5, 6};
const QList<int> kSoft{21, 23, 28, 34, 38, 39}, kHard{20, 20, 22, 25, 32, 37}, kAgain{20, 24, 28, 33, 39, 39};

QByteArray number(double value) {
    return QByteArray::number(value, 'g', 17);
}

QByteArray countsOf(const QByteArray& group, const QList<int>& right) {
    QByteArray rows;
    for (qsizetype i = 0; i < right.size(); ++i)
        rows += group + number(kIntensities[i]) + ',' + QByteArray::number(right[i]) + ',' +
                QByteArray::number(kOf) + '\n';
    return rows;
}

/// One row each; groups take turns, as trials of two interleaved runs do.
QByteArray trialsOf(const QList<std::pair<QByteArray, QList<int>>>& groups) {
    QByteArray rows = "condition,intensity,correct,remark\n";
    for (int trial = 0; trial < kOf; ++trial)
        for (qsizetype i = 0; i < kIntensities.size(); ++i)
            for (const auto& [name, right] : groups)
                rows +=
                    name + ',' + number(kIntensities[i]) + (trial < right[i] ? ",1," : ",0,") + "\"a, b\"\n";
    return rows;
}

const QByteArray kCounts = "intensity,n_correct,n_total\n",
                 kGroups = "condition,intensity,n_correct,n_total\n";

} // namespace

void TestCliPsychophysicsGroups::eachGroupIsFittedAlone() {
    const QString trials = file("trials.csv", trialsOf({{"soft", kSoft}, {"hard", kHard}}));
    const QStringList how{"--method", "ml", "--function", "weibull", "--lapse", "0.02"};
    const QJsonObject both = answer(QStringList{"fit", trials, "--by", "condition"} + how);
    QCOMPARE(both["by"].toArray(), QJsonArray{"condition"});
    QCOMPARE(both["groups"].toArray().size(), 2);
    const QList<QList<int>> right{kSoft, kHard};
    for (int i = 0; i < 2; ++i) {
        const QJsonObject group = both["groups"][i].toObject();
        QCOMPARE(group["group"]["condition"].toString(),
                 i == 0 ? "soft" : "hard"); // as the file has them first
        const QJsonObject alone =
            answer(QStringList{"fit", file("alone.csv", kCounts + countsOf({}, right[i]))} + how);
        QVERIFY(alone["fitted"].toBool());
        for (const char* key :
             {"threshold", "width",
              "deviance"}) // not the likelihood: that of trials has no binomial coefficients
            QVERIFY2(std::abs(group[QLatin1String(key)].toDouble() - alone[QLatin1String(key)].toDouble()) <
                         1e-6,
                     key);
        QCOMPARE(group["levels"].toArray().size(), kIntensities.size());
    }
    QVERIFY(
        runCli(QStringList{"psychophysics", "fit", trials, "--by", "condition"} + how).out.contains("soft"));
}

void TestCliPsychophysicsGroups::groupsByTwoColumns() {
    const QByteArray heading = "person,condition,intensity,n_correct,n_total\n";
    const QString table = file("two.csv", heading + countsOf("P1,a,", kSoft) + countsOf("P2,a,", kHard) +
                                              countsOf("P1,b,", kAgain));
    const QJsonArray groups =
        answer({"fit", table, "--by", "person,condition", "--method", "ml", "--lapse", "0.02"})["groups"]
            .toArray();
    QCOMPARE(groups.size(), 3);
    QCOMPARE(groups[2]["group"].toObject(), (QJsonObject{{"person", "P1"}, {"condition", "b"}}));
    const QJsonArray people =
        answer({"fit", table, "--by", "person", "--method", "ml", "--lapse", "0.02"})["groups"].toArray();
    QCOMPARE(people.size(), 2);
    QCOMPARE(people[0]["levels"][0]["n_total"].toDouble(), 2.0 * kOf); // both conditions of P1
}

void TestCliPsychophysicsGroups::impossibleTrials_data() {
    QTest::addColumn<QByteArray>("row");
    QTest::addColumn<QByteArray>("told");
    QTest::newRow("no answer") << QByteArray("soft,3,n/a,x\n") << QByteArray("column correct");
    QTest::newRow("an answer that is none") << QByteArray("soft,3,2,x\n") << QByteArray("column correct");
    QTest::newRow("words") << QByteArray("soft,3,yes,x\n") << QByteArray("column correct");
    QTest::newRow("no intensity") << QByteArray("soft,,1,x\n") << QByteArray("column intensity");
    QTest::newRow("without end") << QByteArray("soft,inf,1,x\n") << QByteArray("column intensity");
    QTest::newRow("no group") << QByteArray(",3,1,x\n") << QByteArray("column condition");
}

/// Refused with the place; with --drop-bad the fit is that of the others, and says what was left out.
void TestCliPsychophysicsGroups::impossibleTrials() {
    QFETCH(QByteArray, row);
    QFETCH(QByteArray, told);
    const QByteArray good = trialsOf({{"soft", kSoft}, {"hard", kHard}});
    const qsizetype second = good.indexOf('\n') + 1;
    const QString bad = file("bad.csv", good.first(second) + row + good.sliced(second));
    const QStringList how{"--by", "condition", "--method", "ml", "--lapse", "0.02"};
    const CliRun run = runCli(QStringList{"psychophysics", "fit", bad} + how);
    QCOMPARE(run.exitCode, 3);
    QVERIFY(run.out.isEmpty());
    QVERIFY2(run.err.contains("bad.csv:2: ") && run.err.contains(told), run.err.constData());
    const QJsonObject without = answer(QStringList{"fit", bad, "--drop-bad"} + how),
                      clean = answer(QStringList{"fit", file("good.csv", good)} + how);
    QCOMPARE(without["groups"].toArray().size(), 2);
    QCOMPARE(without["groups"][0]["threshold"], clean["groups"][0]["threshold"]);
    if (!row.startsWith(','))
        QVERIFY2(without["groups"][0]["warnings"][0].toString().contains("line 2"),
                 qPrintable(without["groups"][0]["warnings"][0].toString()));
}

void TestCliPsychophysicsGroups::groupsRefused_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("status");
    QTest::newRow("a column that is not there") << QStringList{"--by", "person"} << 3;
    QTest::newRow("the intensity") << QStringList{"--by", "intensity"} << 2;
    QTest::newRow("a column twice") << QStringList{"--by", "condition,condition"} << 2;
    QTest::newRow("answers that are not there")
        << QStringList{"--by", "condition", "--correct", "right"} << 3;
    QTest::newRow("intensities that are not there")
        << QStringList{"--by", "condition", "--intensity", "x"} << 3;
}

void TestCliPsychophysicsGroups::groupsRefused() {
    QFETCH(QStringList, options);
    QFETCH(int, status);
    const CliRun run = runCli(QStringList{"psychophysics", "fit",
                                          file("trials.csv", trialsOf({{"soft", kSoft}, {"hard", kHard}}))} +
                              options);
    QCOMPARE(run.exitCode, status);
    QVERIFY(run.out.isEmpty() && !run.err.isEmpty());
}

/// With nothing in common the larger model is each group's own fit, the smaller that of all rows as if they
/// were one group's.
void TestCliPsychophysicsGroups::likelihoodsOfTheModels() {
    const QStringList how{"--function", "logistic", "--lapse", "0.02", "--guess", "0.5"};
    const QString table = file("groups.csv", kGroups + countsOf("soft,", kSoft) + countsOf("hard,", kHard));
    const QJsonObject compared =
        answer(QStringList{"compare", table, "--by", "condition", "--test", "threshold,width"} + how);
    QList<int> nearlyAsSoft = kSoft;
    nearlyAsSoft[nearlyAsSoft.size() / 2] -= 3;
    const QString alike =
        file("alike.csv", kGroups + countsOf("soft,", kSoft) + countsOf("hard,", nearlyAsSoft));
    const auto drawn = [&](const QStringList& seed) {
        return answer(QStringList{"compare", alike, "--by", "condition", "--monte-carlo", "20"} + how + seed);
    };
    QCOMPARE(drawn({}), drawn({"--seed", "1"}));
    QVERIFY(drawn({}) != drawn({"--seed", "2"}));
    double apart = 0.0;
    for (const QList<int>& right : {kSoft, kHard})
        apart += answer(QStringList{"fit", file("one.csv", kCounts + countsOf({}, right)), "--method", "ml"} +
                        how)["log_likelihood"]
                     .toDouble();
    const double pooled =
        answer(QStringList{"fit", file("all.csv", kCounts + countsOf({}, kSoft) + countsOf({}, kHard)),
                           "--method", "ml"} +
               how)["log_likelihood"]
            .toDouble();
    QVERIFY2(std::abs(compared["larger"]["log_likelihood"].toDouble() - apart) < 1e-5,
             qPrintable(QString::number(apart)));
    QVERIFY2(std::abs(compared["smaller"]["log_likelihood"].toDouble() - pooled) < 1e-5,
             qPrintable(QString::number(pooled)));
    QVERIFY(std::abs(compared["likelihood_ratio"].toDouble() - 2.0 * (apart - pooled)) < 2e-5);
    QCOMPARE(compared["degrees_of_freedom"].toInt(), 2);
    // Chi-square with two degrees of freedom: P(X > x) = exp(−x/2).
    QVERIFY(std::abs(compared["p_value"].toDouble() -
                     std::exp(-0.5 * compared["likelihood_ratio"].toDouble())) < 1e-9);
    QCOMPARE(compared["aic_difference"].toDouble(), compared["likelihood_ratio"].toDouble() - 4.0);
}

void TestCliPsychophysicsGroups::differencesAreFound() {
    const QStringList how{"--by", "condition",     "--shared", "width",  "--lapse",
                          "0.02", "--monte-carlo", "400",      "--seed", "5"};
    const QString differ = file("differ.csv", kGroups + countsOf("soft,", kSoft) + countsOf("hard,", kHard));
    QList<int> nearlyAsSoft = kSoft;
    nearlyAsSoft[nearlyAsSoft.size() / 2] -= 3;
    const QString alike = file("alike.csv", kGroups + countsOf("soft,", kSoft) + countsOf("again,", kAgain));
    const QJsonObject found = answer(QStringList{"compare", differ} + how),
                      none = answer(QStringList{"compare", alike} + how);
    QVERIFY(found["p_value"].toDouble() < 0.01 && found["p_chi_square"].toDouble() < 0.001 &&
            found["aic_difference"].toDouble() > 5.0);
    QVERIFY(none["p_value"].toDouble() > 0.2 && none["aic_difference"].toDouble() < 0.0);
    QVERIFY(std::abs(none["p_value"].toDouble() - none["p_chi_square"].toDouble()) < 0.15);
    QCOMPARE(found["simulated"].toInt(), 400);
    QCOMPARE(found["groups"][0]["larger"]["width"],
             found["groups"][1]["larger"]["width"]); // in common in both
    QVERIFY(found["groups"][0]["larger"]["threshold"].toDouble() <
            found["groups"][1]["larger"]["threshold"].toDouble() - 0.5);
    QCOMPARE(found["groups"][0]["smaller"]["threshold"], found["groups"][1]["smaller"]["threshold"]);
    QCOMPARE(answer(QStringList{"compare", differ} + how), found);
}

void TestCliPsychophysicsGroups::pairsOfThree() {
    const QString three = file("three.csv", kGroups + countsOf("soft,", kSoft) + countsOf("hard,", kHard) +
                                                countsOf("again,", kAgain));
    const QJsonObject compared =
        answer({"compare", three, "--by", "condition", "--lapse", "0.02", "--shared", "none"});
    QCOMPARE(compared["degrees_of_freedom"].toInt(), 2);
    const QJsonArray pairs = compared["pairs"].toArray();
    QCOMPARE(pairs.size(), 3);
    QCOMPARE(pairs[1]["group_a"]["condition"].toString(), "soft");
    QCOMPARE(pairs[1]["group_b"]["condition"].toString(), "again");
    QVERIFY(pairs[0]["p_holm"].toDouble() < 0.01 && pairs[1]["p_holm"].toDouble() > 0.2);
    for (const QJsonValue& pair : pairs)
        QVERIFY(pair["p_holm"].toDouble() >= pair["p_value"].toDouble());
}

void TestCliPsychophysicsGroups::comparisonsRefused_data() {
    QTest::addColumn<QByteArray>("table");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<int>("status");
    const QByteArray both = kGroups + countsOf("soft,", kSoft) + countsOf("hard,", kHard);
    QTest::newRow("without groups") << both << QStringList{} << 2;
    QTest::newRow("one group") << QByteArray(kGroups + countsOf("soft,", kSoft))
                               << QStringList{"--by", "condition"} << 3;
    QTest::newRow("of something else") << both << QStringList{"--by", "condition", "--test", "slope"} << 2;
    QTest::newRow("of nothing") << both << QStringList{"--by", "condition", "--test", "none"} << 2;
    QTest::newRow("of a lapse that is given")
        << both << QStringList{"--by", "condition", "--test", "lapse", "--lapse", "0.02"} << 2;
    QTest::newRow("of a guess that is given")
        << both << QStringList{"--by", "condition", "--test", "guess"} << 2;
    QTest::newRow("more right than there were")
        << QByteArray(both + "hard,7,41,40\n") << QStringList{"--by", "condition"} << 3;
}

void TestCliPsychophysicsGroups::comparisonsRefused() {
    QFETCH(QByteArray, table);
    QFETCH(QStringList, options);
    QFETCH(int, status);
    const CliRun run = runCli(QStringList{"psychophysics", "compare", file("refused.csv", table)} + options);
    QCOMPARE(run.exitCode, status);
    QVERIFY(run.out.isEmpty() && !run.err.isEmpty());
}

QTEST_APPLESS_MAIN(TestCliPsychophysicsGroups)
#include "test_cli_psychophysics_groups.moc"
