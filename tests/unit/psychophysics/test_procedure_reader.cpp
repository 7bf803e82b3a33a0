// SPDX-License-Identifier: GPL-3.0-or-later
// Procedures as JSON: every key there and back, faults told with their place, the schema in step with the
// reader.
#include "catalogue/procedure_reader.h"
#include "catalogue/schema.h"

#include <QJsonDocument>
#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::catalogue;
using namespace chiron::psychophysics;

namespace {

core::Result<ProcedureSpec> read(const QByteArray& json) {
    static const auto schema = readSchema(CHIRON_SOURCE_DIR "/curriculum/content/schema", "procedure");
    return readProcedure(json, "procedure.json", *schema);
}

std::vector<ProcedureSpec> samples() {
    StaircaseSpec staircase;
    staircase.start = -0.3;
    staircase.stepsUp = {0.2, 0.1};
    staircase.stepRatio = 0.7393;
    staircase.stepType = StaircaseSpec::StepType::db;
    staircase.start = 0.5;
    staircase.truncate = false;
    staircase.minimum = 0.01;
    staircase.stop = {.trials = 40, .reversals = 8, .reversalsAndTrials = true};
    QuestPlusSpec plus;
    plus.stimuli = {{"intensity", {-1.0, -0.5, 0.0}}};
    plus.parameters = {{"threshold", {-1.0, 0.0}, {1.0, 3.0}, false},
                       {"slope", {3.5}, {}, false},
                       {"lower_asymptote", {0.5}, {}, false},
                       {"lapse_rate", {0.02, 0.04}, {}, true}};
    plus.catchEvery = 0.1;
    plus.seed = 9007199254740992ULL;
    QuestPlusSpec table;
    table.function = "table";
    table.outcomes = 3;
    table.stimuli = {{"a", {0.0, 1.0}}};
    table.parameters = {{"t", {0.0}, {}, false}};
    table.table = {{{0.2}, {0.5}}, {{0.3}, {0.5}}, {{0.5}, {0.0}}};
    Rank3Spec rank3;
    rank3.differences = {0.01, 0.02, 0.05};
    PestSpec pest;
    pest.start = 1.0;
    ConstantSpec constant;
    constant.levels = {1.0, 2.0};
    DescendingSpec descending;
    descending.levels = {2.0, 1.0};
    QuestSpec quest;
    quest.method = "mean";
    quest.maximum = 0.5;
    return {staircase, pest, constant, descending, quest, plus, table, rank3};
}

} // namespace

class TestProcedureReader : public QObject {
    Q_OBJECT
private slots:
    void thereAndBack();
    void schemaKnowsEveryKey();
    void schemaTakesWhatIsWritten();
    void evenGrids();
    void gridsOfRank3();
    void faults_data();
    void faults();
};

void TestProcedureReader::thereAndBack() {
    for (const ProcedureSpec& spec : samples()) {
        const QByteArray json = QJsonDocument(writeProcedure(spec)).toJson();
        const auto again = read(json);
        QVERIFY2(again, again ? "" : again.error().message.c_str());
        QCOMPARE(again->index(), spec.index());
        QCOMPARE(QJsonDocument(writeProcedure(*again)).toJson(), json);
    }
}

void TestProcedureReader::schemaKnowsEveryKey() {
    const auto schema = readSchema(CHIRON_SOURCE_DIR "/curriculum/content/schema", "procedure");
    QVERIFY2(schema, schema ? "" : schema.error().message.c_str());
    QSet<QString> used;
    for (const ProcedureSpec& spec : samples()) {
        const QJsonObject json = writeProcedure(spec);
        for (const QString& key : json.keys())
            used.insert(key);
    }
    for (const QString& key : used)
        QVERIFY2(schema->properties.contains(key), qPrintable(key));
    for (const auto& [key, property] : schema->properties)
        QVERIFY2(used.contains(key), qPrintable(key));
}

void TestProcedureReader::schemaTakesWhatIsWritten() {
    const auto schema = readSchema(CHIRON_SOURCE_DIR "/curriculum/content/schema", "procedure");
    QVERIFY(schema);
    for (const ProcedureSpec& spec : samples()) {
        Problems problems;
        validated(writeProcedure(spec), *schema, "$", problems);
        QVERIFY2(problems.empty(),
                 problems.empty() ? "" : qPrintable(problems.front().path + " " + problems.front().expected));
    }
}

void TestProcedureReader::evenGrids() {
    const auto spec = read(R"({"kind": "quest_plus", "function": "norm_cdf_2",
        "stimuli": [{"name": "intensity", "from": -1, "to": 1, "step": 0.1}],
        "parameters": [{"name": "sd", "values": [0.1, 0.2]}, {"name": "mean", "from": -0.3, "to": 0.3, "step": 0.05},
                       {"name": "lapse_rate", "values": [0.02], "nuisance": false}]})");
    QVERIFY2(spec, spec ? "" : spec.error().message.c_str());
    const auto& plus = std::get<QuestPlusSpec>(*spec);
    QCOMPARE(plus.stimuli[0].second.size(), std::size_t(21));
    QCOMPARE(plus.parameters[1].values.size(), std::size_t(13));
    QVERIFY(std::abs(plus.stimuli[0].second.back() - 1.0) < 1e-12);
}

void TestProcedureReader::faults_data() {
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("said");
    const auto add = [](const char* name, const QByteArray& json, const char* said) {
        QTest::newRow(name) << json << QString(said);
    };
    add("no kind", "{}", "$.kind: missing: expected a text");
    add("another kind", R"({"kind": "quest_pluss"})", "did you mean \"quest_plus\"?");
    add("unknown key", R"({"kind": "staircase", "stpes_up": [1]})",
        "$.stpes_up: unknown key: expected a key of the procedure staircase");
    add("key of another kind", R"({"kind": "quest", "up": 2})", "$.up: unknown key");
    add("type", R"({"kind": "staircase", "up": "2"})", "$.up: another type: expected a number");
    add("fraction", R"({"kind": "staircase", "up": 1.5})", "$.up: 1.5: expected a whole number");
    add("list", R"({"kind": "staircase", "steps_up": [0.1, "b"]})",
        "$.steps_up[1]: another type: expected a number");
    add("range", R"({"kind": "staircase", "estimate_reversals": 1})",
        "$.estimate_reversals: 1: expected at least 2");
    add("stop", R"({"kind": "staircase", "stop": {"trails": 3}})", "$.stop.trails: unknown key");
    add("stop below 0", R"({"kind": "staircase", "stop": {"trials": 5, "reversals": -1}})",
        "$.stop.reversals: -1: expected at least 0");
    add("stop of another kind", R"({"kind": "staircase", "stop": {"sd": 0.1}})",
        "$.stop: not usable: expected trials or reversals");
    add("stop against itself", R"({"kind": "quest", "stop": {"trials": 5, "minimum_trials": 6}})",
        "$.stop.minimum_trials: 6: expected at most trials, 5");
    add("values and a grid",
        R"({"kind": "quest_plus", "stimuli": [{"name": "x", "values": [1], "from": 0}], "parameters": []})",
        "$.stimuli[0].from: beside values");
    add("sum",
        R"({"kind": "quest_plus", "function": "table", "stimuli": [{"name": "x", "values": [1]}], "parameters": [{"name": "a", "values": [0, 1]}],
        "table": [[[0.2, 0.5]], [[0.8, 0.6]]]})",
        "$.table: stimulus 0, cell 1: probabilities sum to 1.100000: expected 1");
    add("step type", R"({"kind": "staircase", "step_type": "lin"})",
        "$.step_type: \"lin\": expected one of linear, log, db");
    add("no levels", R"({"kind": "constant"})", "$.levels: missing: expected finite numbers, at least one");
    add("method", R"({"kind": "quest", "method": "median"})",
        "$.method: \"median\": expected quantile, mean or mode");
    add("function",
        R"({"kind": "quest_plus", "function": "weibul", "stimuli": [{"name": "x", "values": [1]}], "parameters": []})",
        "$.function: \"weibul\": expected one of weibull_db, weibull_log10, weibull, ");
    add("parameter",
        R"({"kind": "quest_plus", "stimuli": [{"name": "x", "values": [1]}], "parameters": [{"name": "threshold", "values": [1]}]})",
        "slope is missing");
    add("grid",
        R"({"kind": "quest_plus", "stimuli": [{"name": "x", "from": 1, "to": 0, "step": 1}], "parameters": []})",
        "$.stimuli[0].step");
    add("grid of more than a million",
        R"({"kind": "quest_plus", "stimuli": [{"name": "x", "from": 0, "to": 1e6, "step": 1}], "parameters": []})",
        "$.stimuli[0].step: 1: expected a step above 0");
    add("target at the lower asymptote", R"({"kind": "quest", "target": 0.5})",
        "$.target: 0.5: expected a proportion above guess, 0.5, and below 1 - lapse (1 - guess), 0.995");
    add("target at the upper asymptote", R"({"kind": "quest", "target": 0.995})",
        "$.target: 0.995: expected a proportion above guess");
    add("target beyond it", R"({"kind": "quest", "target": 0.2, "guess": 0.25})",
        "$.target: 0.2: expected a proportion above guess, 0.25,");
    add("start above the maximum", R"({"kind": "staircase", "start": 10, "maximum": 1})",
        "$.start: 10: expected a number from minimum to maximum, where levels are truncated");
    add("start below the minimum", R"({"kind": "staircase", "minimum": 0.1})",
        "$.start: 0 by default: expected a number from minimum to maximum");
    add("down beside up", R"({"kind": "staircase", "up": 2, "down": 0})", "$.down: 0: expected at least 1");
    add("lapse beside guess", R"({"kind": "quest", "guess": 0.5, "lapse": 1})",
        "$.lapse: 1: expected a share from 0 to below 1");
    add("passes beside repeats", R"({"kind": "descending", "levels": [2, 1], "repeats": 3, "passes": 4})",
        "$.passes: 4: expected at least 1, and no more than repeats");
    add("no table",
        R"({"kind": "quest_plus", "function": "table", "stimuli": [{"name": "x", "values": [1]}], "parameters": [{"name": "a", "values": [1]}]})",
        "$.table: missing: expected as many outcomes as outcomes says");
    add("no lapse rate", R"({"kind": "rank3_quest_plus", "differences": [0.1], "lapse_rates": []})",
        "$.lapse_rates: not usable: expected shares from 0 to below 1, at least one");
    const QByteArray grids =
        R"({"kind": "quest_plus", "stimuli": [{"name": "x", "values": [1]}], "parameters": [{"name": "threshold", "values": [-1, 1]},
        {"name": "slope", "values": [2], "prior": [1, 2]}, {"name": "lower_asymptote", "values": [0.1, 0.5]}, {"name": "lapse_rate", "values": [0, 0.6]}]})";
    const auto grid = [&grids](const char* what, const char* with) {
        return QByteArray(grids).replace(R"(, "prior": [1, 2])", "").replace(what, with);
    };
    add("prior", grids, "$.parameters[1].prior: not usable: expected as many numbers as values");
    add("lapse and guess", grid("$", ""),
        "$.parameters[3]: not usable: expected values that come to at most 1 with those of lower_asymptote");
    add("lapse of both sides",
        grid(R"({"name": "lower_asymptote", "values": [0.1, 0.5]}, )", "")
            .replace(R"("threshold")", R"("mean")")
            .replace(R"("slope")", R"("sd")")
            .replace(R"("kind")", R"("function": "norm_cdf_2", "kind")"),
        "$.parameters[2]: not usable: expected values of at most 0.5");
    add("threshold of a ratio", grid("0.6", "0.02").replace(R"("kind")", R"("function": "weibull", "kind")"),
        "$.parameters[0]: not usable: expected values above 0 with the function weibull");
    add("default against what is given", R"({"kind": "quest", "guess": 0.9})",
        "$.target: 0.82 by default: expected a proportion above guess, 0.9,");
    add("more than the schema has", R"({"kind": "staircase", "up": 101})",
        "$.up: 101: expected a whole number, 1 to 100");
    add("start beyond it", R"({"kind": "staircase", "start": 1e300})", "$.start: 1e+300: expected ");
    add("steps beyond it", R"({"kind": "staircase", "start": 1e308, "steps_up": [1e308]})",
        "$.start: 1e+308: expected ");
    add("one step beyond it", R"({"kind": "staircase", "steps_up": [0.1, 1e10]})",
        "$.steps_up[1]: 1e+10: expected ");
    add("list beyond it",
        "{\"kind\": \"staircase\", \"steps_up\": [0.1" + QByteArray(",0.1").repeated(1000) + "]}",
        "$.steps_up: an array of 1001: expected an array of this many elements, 1 to 1000");
    add("inside a list", R"({"kind": "constant", "levels": [1, 1e10]})",
        "$.levels[1]: 1e+10: expected a number, -1e+09 to 1e+09 x");
    add("catch trials",
        R"({"kind": "quest_plus", "catch_every": 0.999, "stimuli": [{"name": "x", "values": [1]}], "parameters": [{"name": "threshold", "values": [1]},
        {"name": "slope", "values": [2]}, {"name": "lower_asymptote", "values": [0.5]}, {"name": "lapse_rate", "values": [0]}]})",
        "$.catch_every: 0.999: expected a number, 0 to 0.99");
    add("ties",
        R"({"kind": "rank3_quest_plus", "differences": [0.1], "allow_ties": true, "tie_thresholds": [0]})",
        "$.tie_thresholds: not usable: expected positive numbers");
    add("place", "{\"kind\": \"staircase\",\n \"down\": 0}", "procedure.json:2:");
}

void TestProcedureReader::gridsOfRank3() {
    QByteArray numbers = "0.1";
    for (int i = 1; i < 3000; ++i)
        numbers += "," + QByteArray::number(0.1 + 1e-5 * i);
    const auto spec = read(R"({"kind": "rank3_quest_plus", "differences": [)" + numbers +
                           R"(], "log10_sigma": [)" + numbers + "]}");
    QVERIFY(!spec);
    QVERIFY2(
        QString::fromStdString(spec.error().message)
            .contains("$.differences: times log10_sigma, lapse_rates and tie_thresholds more than 4000000"),
        spec.error().message.c_str());
    QByteArray many = "1e-4"; // the grid of sigma left out counts too
    for (int i = 1; i < 60'000; ++i)
        many += "," + QByteArray::number(1e-4 + 1e-5 * i);
    const QByteArray lapses = "0.02" + QByteArray(",0.02").repeated(49);
    const auto byDefault = read(R"({"kind": "rank3_quest_plus", "differences": [)" + many +
                                R"(], "lapse_rates": [)" + lapses + "]}");
    QVERIFY(!byDefault);
    QVERIFY2(
        QString::fromStdString(byDefault.error().message)
            .contains("$.differences: times log10_sigma, lapse_rates and tie_thresholds more than 4000000"),
        byDefault.error().message.c_str());
}

void TestProcedureReader::faults() {
    QFETCH(QByteArray, json);
    QFETCH(QString, said);
    const auto spec = read(json);
    QVERIFY(!spec);
    QVERIFY2(QString::fromStdString(spec.error().message).contains(said), spec.error().message.c_str());
    QCOMPARE(spec.error().code, core::ErrorCode::badInput);
}

QTEST_APPLESS_MAIN(TestProcedureReader)
#include "test_procedure_reader.moc"
