// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <vector>

// The study of the apex from outside: rendered sphere by sphere in the exercise's own scene, gone on with at
// the trial, replayed, scored, analysed and exported; and the observer for planning, which says what it is.
class TestCliApexStudy : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void everyMarkIsATrialOfASession();
    void aRunIsGoneOnWithAtTheTrial();
    void theRecordingHoldsWhatTheTrialsSay();
    void theAnalysisIsThatOfTheRows();
    void thePlannedObserverSaysSo();
    void planTellsOfErrors();
    void exportsHoldTheErrors();
    void eachKindOfConditionHasItsTable();
    void refusals();

private:
    CliRun cli(const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", m_database, "--json"});
    }
    QJsonObject apex(const QString& participant, const QStringList& more = {}) {
        const CliRun run = cli(QStringList{"study", "run", "apex", "--participant", participant, "--observer",
                                           "weber:0.1", "--seed", "4"} +
                               more);
        if (run.exitCode != 0)
            qWarning("%s", run.err.constData());
        return QJsonDocument::fromJson(run.out).object();
    }

    QTemporaryDir m_folder;
    QString m_database;
    QJsonArray m_trials; ///< of S01
};

namespace {

QJsonObject object(const CliRun& run) {
    if (run.exitCode != 0)
        qWarning("%s", run.err.constData());
    return QJsonDocument::fromJson(run.out).object();
}

bool counts(const QJsonValue& trial) {
    return !trial["practice"].toBool() && trial["spoiled"].toString().isEmpty();
}

int scored(const QJsonArray& trials) {
    return static_cast<int>(
        std::count_if(trials.begin(), trials.end(), [](const QJsonValue& trial) { return counts(trial); }));
}

std::vector<double> errors(const QJsonArray& trials, const char* key) {
    std::vector<double> out;
    for (const QJsonValue& trial : trials)
        if (counts(trial))
            out.push_back(trial["mark"][QLatin1String(key)].toDouble(std::nan("")));
    return out;
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

double sd(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += (value - mean(values)) * (value - mean(values));
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b));
}

} // namespace

void TestCliApexStudy::initTestCase() {
    QVERIFY(m_folder.isValid());
    m_database = m_folder.filePath("study.db");
    const QJsonObject run = apex("S01");
    QVERIFY(run["runs"][0]["completed"].toBool());
    m_trials = run["trials"].toArray();
}

void TestCliApexStudy::everyMarkIsATrialOfASession() {
    QCOMPARE(scored(m_trials), 10);
    for (const QJsonValue& trial : std::as_const(m_trials)) {
        QVERIFY(trial["session_id"].toInt() > 0);
        if (!counts(trial))
            continue;
        const double x = trial["mark"]["error_x_m"].toDouble(1.0),
                     y = trial["mark"]["error_y_m"].toDouble(1.0);
        QVERIFY(near(trial["value"].toDouble(), std::hypot(x, y)));
        QVERIFY2(std::hypot(x, y) < 0.02, "a mark off the ball");
        QVERIFY(near(trial["mark"]["error_x_percent"].toDouble(), x / 0.02 * 100.0));
        QVERIFY(!trial["mark"]["planned"].toBool(true));
        QVERIFY(trial["mark"]["in_contact"].toBool());
        QVERIFY(trial["fidelity"]["contacts"].toInt() > 0);
        QVERIFY2(std::abs(trial["fidelity"]["places"].toArray().first()["rendered"].toDouble() / 500.0 -
                          1.0) < 0.15,
                 "the sphere felt other than asked for");
    }
    QVERIFY(sd(errors(m_trials, "error_x_m")) > 0.0002);
    QCOMPARE(apex("S01")["trials"].toArray(), m_trials); // completed: nothing is added
}

void TestCliApexStudy::aRunIsGoneOnWithAtTheTrial() {
    const QJsonArray before = apex("S02", {"--trials", "4"})["trials"].toArray();
    QCOMPARE(before.size(), 4);
    const QJsonObject whole = apex("S02");
    const QJsonArray after = whole["trials"].toArray();
    QVERIFY(whole["runs"][0]["completed"].toBool());
    QCOMPARE(scored(after), 10);
    for (qsizetype i = 0; i < before.size(); ++i)
        QCOMPARE(after[i], before[i]);
    QVERIFY(after.last()["session_id"] != before.last()["session_id"]);
    QVERIFY(errors(after, "error_x_m") != errors(m_trials, "error_x_m")); // other places, another hand
    QVERIFY(object(cli({"study", "rerun", "apex"}))["identical"].toBool());
}

void TestCliApexStudy::theRecordingHoldsWhatTheTrialsSay() {
    const int session = m_trials.at(0)["session_id"].toInt();
    const QString id = QString::number(session);
    QCOMPARE(cli({"replay", id}).exitCode, 0);
    QCOMPARE(cli({"verify"}).exitCode, 0);
    std::vector<double> x; // practice, too: the session's scores know of no study
    for (const QJsonValue& trial : std::as_const(m_trials))
        if (trial["session_id"].toInt() == session && trial["mark"].isObject())
            x.push_back(trial["mark"]["error_x_percent"].toDouble());
    const QJsonObject score = object(cli({"score", id}));
    double bias = std::nan("");
    for (const QJsonValue& metric : score["metrics"].toArray())
        if (metric["id"].toString() == QLatin1String("apex_bias_x"))
            bias = metric["value"].toDouble(std::nan(""));
    QVERIFY2(std::abs(bias - mean(x)) < 1e-6, qPrintable(QStringLiteral("%1 %2").arg(bias).arg(mean(x))));
}

void TestCliApexStudy::theAnalysisIsThatOfTheRows() {
    const CliRun told = cli({"study", "analyse", "apex"});
    const QJsonObject analysis = object(told);
    const QJsonObject own = analysis["runs"][0]["apex"].toObject();
    QCOMPARE(analysis["runs"][0]["participant"].toString(), QStringLiteral("S01"));
    for (const char* axis : {"x", "y"}) {
        const QByteArray key = QByteArray("error_") + axis + "_m";
        const QJsonObject said = own["axes"][QLatin1String(axis)].toObject();
        const std::vector<double> marks = errors(m_trials, key.constData());
        QVERIFY(near(said["bias_mm"].toDouble(), 1000.0 * mean(marks)));
        QVERIFY(near(said["sd_mm"].toDouble(), 1000.0 * sd(marks)));
        QVERIFY(near(said["bias_percent"].toDouble(), mean(marks) / 0.02 * 100.0));
    }
    std::vector<double> absolutes;
    for (const char* key : {"error_x_percent", "error_y_percent"})
        for (const double error : errors(m_trials, key))
            absolutes.push_back(std::abs(error));
    QVERIFY(near(own["mean_absolute_percent"].toDouble(), mean(absolutes)));
    QVERIFY(near(own["sd_absolute_percent"].toDouble(), sd(absolutes)));
    const QJsonObject group = analysis["conditions"][0]["apex"].toObject();
    QCOMPARE(group["participants"].toInt(), 2);
    QCOMPARE(group["trials"].toInt(), 20);
    QVERIFY(group["axes"]["x"]["sd_between_mm"].isDouble());
    QCOMPARE(group["axes"]["x"]["bias_ci_mm"].toArray().size(), 2);
    const QByteArray text = runCli({"study", "analyse", "apex", "--database", m_database}).out;
    for (const char* word : {"S01", "S02", "(group of 2)", "bias x (mm)", "sd y (mm)"})
        QVERIFY2(text.contains(word), word);
}

// Nothing is rendered, and everything that tells of it says so.
void TestCliApexStudy::thePlannedObserverSaysSo() {
    const QString elsewhere = m_folder.filePath("planned.db");
    const CliRun run = runCli({"study", "run", "apex", "--participant", "S01", "--observer", "weber:0.1",
                               "--quick", "--database", elsewhere, "--json"});
    const QJsonArray trials = object(run)["trials"].toArray();
    QCOMPARE(scored(trials), 10);
    for (const QJsonValue& trial : trials) {
        QCOMPARE(trial["session_id"].toInt(), 0);
        QVERIFY(trial["mark"]["planned"].toBool());
    }
    const QJsonObject analysis =
        object(runCli({"study", "analyse", "apex", "--database", elsewhere, "--json"}));
    QVERIFY(analysis["conditions"][0]["apex"]["warnings"].toVariant().toStringList().join(u' ').contains(
        "planned:"));
}

// By the observer for planning, whose mean absolute error is the published one: 17.8 √(2/π) = 14.2 % of the
// radius.
void TestCliApexStudy::planTellsOfErrors() {
    const QJsonObject plan = object(runCli({"study", "plan", "apex", "--observer", "weber:0.1", "--runs",
                                            "200", "--database", m_folder.filePath("none.db"), "--json"}));
    const QJsonObject apex = plan["conditions"].toArray().first()["apex"].toObject();
    QVERIFY(std::abs(apex["mean_absolute_percent"].toDouble() - 14.2) < 0.3);
    QCOMPARE(apex["participants"].toInt(), 12);
    QCOMPARE(apex["marks_each"].toInt(), 10);
    QVERIFY(apex["half_width_percent"].toDouble() > 0.5 && apex["half_width_percent"].toDouble() < 3.0);
    QCOMPARE(apex["power"].toDouble(), 1.0); // the earlier device's 29.7 % is far away
    QVERIFY(plan["minutes"].toDouble() > 4.0);
}

void TestCliApexStudy::exportsHoldTheErrors() {
    QCOMPARE(
        cli({"study", "export", "apex", "--format", "csv,bids", "--out", m_folder.filePath("out")}).exitCode,
        0);
    QFile file(m_folder.filePath("out/csv/trials.csv"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
    const QList<QByteArray> heading = lines.first().trimmed().split(',');
    const qsizetype column = heading.indexOf("mark_error_x"), practice = heading.indexOf("scored");
    QVERIFY(column > 0 && heading.contains("mark_error_y_percent"));
    std::vector<double> stored;
    for (qsizetype i = 1; i < lines.size(); ++i) {
        const QList<QByteArray> cells = lines[i].trimmed().split(',');
        if (cells[1] == "S01" && cells[practice] == "1")
            stored.push_back(cells[column].toDouble());
    }
    const std::vector<double> marks = errors(m_trials, "error_x_m");
    QCOMPARE(stored.size(), marks.size());
    for (std::size_t i = 0; i < marks.size(); ++i)
        QVERIFY2(std::abs(stored[i] - marks[i]) < 1e-9,
                 qPrintable(QStringLiteral("%1 %2").arg(stored[i]).arg(marks[i])));
    const QStringList beh =
        QDir(m_folder.filePath("out/bids/sub-S01/beh")).entryList({"*_beh.tsv"}, QDir::Files);
    QCOMPARE(beh.size(), 1);
    QFile tsv(m_folder.filePath("out/bids/sub-S01/beh/" + beh.first()));
    QVERIFY(tsv.open(QIODevice::ReadOnly));
    QVERIFY(tsv.readLine().contains("mark_error_y"));
}

/// A design of a sphere and of two tubes: errors of marks in one table, Weber fractions in the other.
void TestCliApexStudy::eachKindOfConditionHasItsTable() {
    const auto designOf = [](const char* name) {
        QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content/studies/%1.json").arg(name));
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()
                                              : QJsonObject();
    };
    QJsonObject design = designOf("apex"), tubes = designOf("stiffness_2afc")["conditions"][0].toObject();
    QJsonObject sphere = design["conditions"][0].toObject();
    sphere["procedures"] =
        QJsonArray{QJsonObject{{"kind", "constant"}, {"levels", QJsonArray{0}}, {"repeats", 2}}};
    const QJsonArray levels{0.1, 0.5};
    QJsonObject stimulus = tubes["stimulus"].toObject();
    stimulus["differences"] = levels;
    tubes["stimulus"] = stimulus;
    tubes["scale"] = "difference";
    tubes["procedures"] = QJsonArray{QJsonObject{{"kind", "constant"}, {"levels", levels}, {"repeats", 4}}};
    design["id"] = "sphere_and_tubes";
    design["conditions"] = QJsonArray{sphere, tubes};
    QFile file(m_folder.filePath("mixed.json"));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(design).toJson()) > 0);
    file.close();
    const QString database = m_folder.filePath("mixed.db");
    const CliRun run = runCli({"study", "run", file.fileName(), "--participant", "S01", "--observer",
                               "weber:0.1", "--seed", "4", "--database", database});
    QVERIFY2(run.exitCode == 0, run.err.constData());
    const QList<QByteArray> lines =
        runCli({"study", "analyse", "sphere_and_tubes", "--database", database}).out.split('\n');
    const auto rowsOf = [&](const char* heading) { // of the table that has a column of that name
        QList<QByteArray> rows;
        bool inside = false;
        for (const QByteArray& line : lines) {
            if (line.startsWith("participant "))
                inside = line.contains(heading);
            else if (inside && (line.startsWith("S01 ") || line.startsWith("(group of 1) ")))
                rows << line;
        }
        return rows;
    };
    QCOMPARE(rowsOf("Weber").size(), 2); // the participant's and the group's
    for (const QByteArray& row : rowsOf("Weber"))
        QVERIFY2(row.contains(" tube_60 ") && row.count("prior_bound") <= 1, row.constData());
    QCOMPARE(rowsOf("bias x (mm)").size(), 2);
    for (const QByteArray& row : rowsOf("bias x (mm)"))
        QVERIFY2(row.contains(" sphere_20mm "), row.constData());
}

void TestCliApexStudy::refusals() {
    const auto fault = [&](const QStringList& observer, int status, const QStringList& mentions) {
        return refusalFault(cli(QStringList{"study", "run"} + observer), status, mentions);
    };
    const QString unknown =
        fault({"apex", "--participant", "X1", "--observer", "operator:nobody"}, 3, {"nobody", "expert"});
    QVERIFY2(unknown.isEmpty(), qPrintable(unknown));
    const QString elsewhere = fault(
        {"stiffness_elastic_tube", "--participant", "X1", "--observer", "operator:expert"}, 2, {"apex"});
    QVERIFY2(elsewhere.isEmpty(), qPrintable(elsewhere));
    const QString other =
        fault({"apex", "--participant", "S01", "--observer", "operator:expert"}, 2, {"enrolled"});
    QVERIFY2(other.isEmpty(), qPrintable(other));
    const QString mixed = fault({"apex", "--participant", "S01", "--observer", "weber:heavy"}, 3, {"heavy"});
    QVERIFY2(mixed.isEmpty(), qPrintable(mixed));
}

QTEST_GUILESS_MAIN(TestCliApexStudy)
#include "test_cli_apex_study.moc"
