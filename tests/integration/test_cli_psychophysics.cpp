// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <utility>

// The psychophysics commands from outside: keys, warnings, lines in and out, refusals with the place.
class TestCliPsychophysics : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void fitPrintsTheContract_data();
    void fitPrintsTheContract();
    void fitWarnsOfDegenerateData();
    void dPrimeWithoutCorrection();
    void dPrimeOfNothing();
    void intervalsAreThereOrMissed();
    void fitNamesThePlace_data();
    void fitNamesThePlace();
    void adaptiveAnswersLineByLine();
    void adaptiveTakesOrders();
    void adaptiveNamesBadLines_data();
    void adaptiveNamesBadLines();
    void adaptiveNamesBadSpecifications();
    void adaptiveIsTheSameEachTime();

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

const QByteArray kLevels =
    "intensity,n_correct,n_total\n0.5,52,100\n1,61,100\n2,80,100\n4,95,100\n8,99,100\n";
const QByteArray kStaircase =
    R"({"kind":"staircase","start":-0.5,"up":1,"down":2,"steps_up":[0.2,0.1],"minimum":-2,"maximum":0,"stop":{"trials":5}})";
const QByteArray kRank3 =
    R"({"kind":"rank3_quest_plus","differences":[0.02,0.05,0.1,0.2],"log10_sigma":[-2,-1.75,-1.5,-1.25,-1,-0.75],"stop":{"trials":4,"minimum_trials":0,"sd":0}})";

QJsonObject object(const QByteArray& text) {
    return QJsonDocument::fromJson(text).object();
}

QList<QJsonObject> lines(const QByteArray& text) {
    QList<QJsonObject> all;
    for (const QByteArray& line : text.split('\n'))
        if (!line.isEmpty())
            all << object(line);
    return all;
}

} // namespace

void TestCliPsychophysics::fitPrintsTheContract_data() {
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("scale");
    QTest::newRow("ml, logistic") << QStringList{"--method", "ml", "--function", "logistic"} << "linear";
    QTest::newRow("ml, weibull on ln") << QStringList{"--method", "ml", "--function", "weibull"} << "ln";
    QTest::newRow("ml, weibull, equal asymptotes")
        << QStringList{"--method", "ml", "--function", "weibull", "--guess", "equal"} << "ln";
    QTest::newRow("bayes, gauss on log10")
        << QStringList{"--function", "gauss", "--scale", "log10", "--lapse", "0.02"} << "log10";
}

void TestCliPsychophysics::fitPrintsTheContract() {
    QFETCH(QStringList, options);
    QFETCH(QString, scale);
    const CliRun run = runCli(QStringList{"psychophysics", "fit", file("levels.csv", kLevels), "--reference",
                                          "10", "--threshold-at", "0.75", "--json"} +
                              options);
    QVERIFY2(run.exitCode == 0, run.err.constData());
    const QJsonObject fit = object(run.out);
    for (const char* key :
         {"threshold", "width", "lapse", "guess", "eta", "deviance", "log_likelihood", "pse", "jnd", "weber"})
        QVERIFY2(fit.contains(QLatin1String(key)), key);
    QCOMPARE(fit["scale"].toString(), scale);
    QVERIFY(fit["warnings"].isArray());
    const double threshold = fit["threshold"].toDouble();
    const QJsonArray ci = fit["ci"]["threshold"].toArray();
    QVERIFY2(threshold > 0.5 && threshold < 8.0, run.out.constData());
    QVERIFY2(ci.size() == 2 && ci[0].toDouble() < threshold && threshold < ci[1].toDouble(),
             run.out.constData());
    QCOMPARE(fit["threshold_at"]["proportion"].toDouble(), 0.75);
}

void TestCliPsychophysics::fitWarnsOfDegenerateData() {
    const CliRun run = runCli({"psychophysics", "fit",
                               file("right.csv", "intensity,n_correct,n_total\n1,20,20\n2,20,20\nnan,3,5\n"),
                               "--method", "ml", "--json"});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    const QJsonArray warnings = object(run.out)["warnings"].toArray();
    QVERIFY2(!warnings.isEmpty(), run.out.constData());
    for (const QJsonValue& warning : warnings)
        QVERIFY2(warning.toString().contains(": "), qPrintable(warning.toString()));
}

/// Interval and standard error belong to the rates that d' is of.
void TestCliPsychophysics::dPrimeWithoutCorrection() {
    const auto dprime = [](const QStringList& counts, const QStringList& more = {}) {
        return object(runCli(QStringList{"psychophysics", "dprime", "--hits", counts[0], "--misses",
                                         counts[1], "--false-alarms", counts[2], "--correct-rejections",
                                         counts[3], "--uncorrected", "--json"} +
                             more)
                          .out);
    };
    const QJsonObject some = dprime({"40", "10", "10", "40"});
    const double d = some["d_prime"].toDouble();
    QVERIFY(std::abs(d - 2.0 * 0.8416212335729143) < 1e-9);
    QVERIFY(std::abs(0.5 * (some["ci_low"].toDouble() + some["ci_high"].toDouble()) - d) < 1e-9);
    const QJsonObject whole = dprime({"50", "0", "0", "50"});
    QVERIFY(whole["d_prime"].isNull() && whole["ci_low"].isNull() && whole["se"].isNull() &&
            !whole["warnings"].toArray().isEmpty());
    const QJsonObject pairs = dprime({"40", "10", "10", "40"}, {"--task", "same-different"});
    QCOMPARE(pairs["correction"].toString(), QStringLiteral("none"));
    QCOMPARE(pairs["proportion_correct"].toDouble(), 0.8);
    QVERIFY(dprime({"50", "0", "0", "50"}, {"--task", "same-different"})["d_prime"].isNull());
}

void TestCliPsychophysics::dPrimeOfNothing() {
    const QJsonObject none = object(runCli({"psychophysics", "dprime", "--hits", "0", "--misses", "0",
                                            "--false-alarms", "0", "--correct-rejections", "50", "--json"})
                                        .out);
    QVERIFY(none["d_prime"].isNull() && !none["warnings"].toArray().isEmpty());
    const QJsonObject perfect =
        object(runCli({"psychophysics", "dprime", "--task", "2afc", "--proportion", "1", "--json"}).out);
    QVERIFY(perfect["d_prime"].isNull() && !perfect["warnings"].toArray().isEmpty());
}

/// What was asked for has an interval, or a warning says how to get one.
void TestCliPsychophysics::intervalsAreThereOrMissed() {
    const auto fit = [this](const QStringList& options) {
        return object(runCli(QStringList{"psychophysics", "fit", file("asked.csv", kLevels), "--threshold-at",
                                         "0.75", "--json"} +
                             options)
                          .out);
    };
    const auto missed = [](const QJsonObject& fitted) {
        const QJsonArray warnings = fitted["warnings"].toArray();
        return std::any_of(warnings.begin(), warnings.end(), [](const QJsonValue& w) {
            return w.toString().startsWith(QLatin1String("no_interval: "));
        });
    };
    const QJsonObject bayes = fit({});
    const QJsonArray ci = bayes["threshold_at"]["ci"].toArray();
    const double value = bayes["threshold_at"]["value"].toDouble();
    QVERIFY(ci[0].toDouble() < value && value < ci[1].toDouble() && !missed(bayes));
    QVERIFY(missed(fit({"--method", "ml"})) && missed(fit({"--method", "ml", "--bootstrap", "50"})) &&
            !missed(fit({"--method", "ml", "--bootstrap", "200"})));
}

void TestCliPsychophysics::fitNamesThePlace_data() {
    QTest::addColumn<QByteArray>("csv");
    QTest::addColumn<QStringList>("mentions");
    QTest::newRow("empty") << QByteArray() << QStringList{"given.csv", "empty"};
    QTest::newRow("no rows") << QByteArray("intensity,n_correct,n_total\n")
                             << QStringList{"given.csv", "no rows"};
    QTest::newRow("no such column") << QByteArray("intensity,right,n_total\n1,2,3\n")
                                    << QStringList{"given.csv:1", "n_correct"};
    QTest::newRow("words") << QByteArray("intensity,n_correct,n_total\n1,2,3\n2,two,3\n")
                           << QStringList{"given.csv:3", "two", "expected a number"};
    QTest::newRow("short row") << QByteArray("intensity,n_correct,n_total\n1,2\n")
                               << QStringList{"given.csv:2", "expected 3"};
}

void TestCliPsychophysics::fitNamesThePlace() {
    QFETCH(QByteArray, csv);
    QFETCH(QStringList, mentions);
    const QString fault = refusalFault(runCli({"psychophysics", "fit", file("given.csv", csv)}), 3, mentions);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
}

void TestCliPsychophysics::adaptiveAnswersLineByLine() {
    const CliRun run =
        runCli({"psychophysics", "adaptive", "--procedure", file("staircase.json", kStaircase)},
               "1\n1\nundo\n0\nspoiled\n1 -0.4\n");
    QVERIFY2(run.exitCode == 0, run.err.constData());
    const auto out = lines(run.out);
    QCOMPARE(out.size(), 8); // the first stimulus, a line each, the end
    QCOMPARE(out[0]["stimulus"].toDouble(), -0.5);
    QCOMPARE(out[0]["trial"].toInt(), 0);
    const QList<int> trials{0, 1, 2, 1, 2, 2, 3, 3};
    for (qsizetype i = 0; i < out.size(); ++i) {
        QCOMPARE(out[i]["trial"].toInt(), trials[i]);
        for (const char* key : {"stimulus", "reversals", "done", "entropy_margin", "estimate"})
            QVERIFY2(out[i].contains(QLatin1String(key)), key);
    }
    QCOMPARE(out[3]["stimulus"], out[1]["stimulus"]); // undone
    QVERIFY(out[7]["final"].toBool());
}

void TestCliPsychophysics::adaptiveTakesOrders() {
    const QString path = file("rank3.json", kRank3);
    const CliRun orders =
        runCli({"psychophysics", "adaptive", "--procedure", path}, "a<b<c\nb<a<c\nc < b < a\nb<c<a\n");
    const CliRun numbers = runCli({"psychophysics", "adaptive", "--procedure", path}, "0\n2\n5\n4\n");
    QVERIFY2(orders.exitCode == 0, orders.err.constData());
    QCOMPARE(orders.out, numbers.out);
    const auto out = lines(orders.out);
    QVERIFY(out.last()["done"].toBool());
    QVERIFY(out.last()["stimulus"].isNull());
    QVERIFY(out.last()["estimate"]["log10_sigma"].isDouble());
    QVERIFY(out.first()["entropy_margin"].isDouble());
}

void TestCliPsychophysics::adaptiveNamesBadLines_data() {
    QTest::addColumn<QByteArray>("procedure");
    QTest::addColumn<QByteArray>("input");
    QTest::addColumn<QByteArray>("mention");
    QTest::newRow("no outcome") << kStaircase << QByteArray("1\n2\n")
                                << QByteArray("stdin line 2: \"2\": expected 0, 1, undo or spoiled");
    QTest::newRow("a word") << kStaircase << QByteArray("yes\n") << QByteArray("stdin line 1");
    QTest::newRow("nothing to undo") << kStaircase << QByteArray("undo\n") << QByteArray("stdin line 1");
    QTest::newRow("not a stimulus") << kStaircase << QByteArray("1 loud\n")
                                    << QByteArray("expected the stimulus presented");
    QTest::newRow("not an order") << kRank3 << QByteArray("a<b<b\n")
                                  << QByteArray("expected an order such as b<a<c");
    QTest::newRow("a tie") << kRank3 << QByteArray("a=b<c\n") << QByteArray("ties are not allowed");
}

void TestCliPsychophysics::adaptiveNamesBadLines() {
    QFETCH(QByteArray, procedure);
    QFETCH(QByteArray, input);
    QFETCH(QByteArray, mention);
    const CliRun run =
        runCli({"psychophysics", "adaptive", "--procedure", file("procedure.json", procedure)}, input);
    QCOMPARE(run.exitCode, 3);
    QVERIFY2(run.err.contains(mention), run.err.constData());
    QVERIFY(!lines(run.out).last()["final"].toBool());
}

void TestCliPsychophysics::adaptiveNamesBadSpecifications() {
    for (const auto& [json, mention] : {std::pair<QByteArray, QString>{R"({"kind":"magic"})", "kind"},
                                        {R"({"kind":"staircase","stepsize":1})", "stepsize"},
                                        {"{", "procedure.json"}}) {
        const QString fault = refusalFault(
            runCli({"psychophysics", "adaptive", "--procedure", file("procedure.json", json)}, "1\n"), 3,
            {mention});
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }
}

void TestCliPsychophysics::adaptiveIsTheSameEachTime() {
    const QString path = file("constant.json", R"({"kind":"constant","levels":[0.1,0.2,0.3],"repeats":3})");
    const CliRun first =
        runCli({"psychophysics", "adaptive", "--procedure", path, "--seed", "7"}, "1\n1\n0\n1\n");
    QVERIFY2(first.exitCode == 0, first.err.constData());
    QCOMPARE(runCli({"psychophysics", "adaptive", "--procedure", path, "--seed", "7"}, "1\n1\n0\n1\n").out,
             first.out);
}

QTEST_GUILESS_MAIN(TestCliPsychophysics)
#include "test_cli_psychophysics.moc"
