// SPDX-License-Identifier: GPL-3.0-or-later
// What a trial of QUEST+ costs (choose and take the answer in), beside jsquest-plus (npm) on the same grid
// and answers, in turn; and the set-up of three grids.
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "core/fp_environment.h"
#include "psychophysics/procedures/quest_plus.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <unistd.h>

using namespace chiron;
using namespace chiron::bench;
using namespace chiron::psychophysics;

namespace {

constexpr int kRounds = 5;
constexpr int kTrials = 64;

std::vector<double> even(double from, double to, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(count == 1 ? from : from + (to - from) * i / (count - 1));
    return values;
}

QuestPlusSpec grid(int stimuli, int thresholds, int slopes, int lapses) {
    QuestPlusSpec spec;
    spec.stimuli = {{"intensity", even(-2.0, 0.0, stimuli)}};
    spec.parameters = {{"threshold", even(-2.0, 0.0, thresholds), {}, false},
                       {"slope", even(1.0, 7.0, slopes), {}, false},
                       {"lower_asymptote", {0.5}, {}, false},
                       {"lapse_rate", even(0.0, 0.09, lapses), {}, false}};
    spec.stop = {.trials = kTrials};
    return spec;
}

/// Answers of a participant with its threshold in the middle; the same for all.
std::vector<int> answersOf(const QuestPlusModel& model) {
    QuestPlus run(std::make_shared<QuestPlusModel>(model), 1);
    std::vector<int> answers;
    for (int trial = 0; trial < kTrials; ++trial) {
        const Stimulus x = run.next().stimulus;
        answers.push_back(x[0] > -0.95 || trial % 7 == 3 ? 1 : trial % 2);
        (void)run.record(answers.back(), x);
    }
    return answers;
}

struct Ours {
    double trial_ms = 0.0;
    std::vector<double> chosen;
};

Ours ours(const std::shared_ptr<const QuestPlusModel>& model, const std::vector<int>& answers) {
    Ours result;
    constexpr int kRuns = 20;
    const double cpu = cpuSeconds([&] {
        for (int repeat = 0; repeat < kRuns; ++repeat) {
            QuestPlus run(model, 1);
            result.chosen.clear();
            for (const int answer : answers) {
                const Stimulus x = run.next().stimulus;
                result.chosen.push_back(x[0]);
                (void)run.record(answer, x);
            }
        }
    });
    result.trial_ms = 1e3 * cpu / kRuns / static_cast<double>(answers.size());
    return result;
}

std::string said(const std::string& command) {
    std::string text;
    if (std::FILE* pipe = popen(command.c_str(), "r"); pipe != nullptr) {
        char buffer[4096];
        while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe))
            text.append(buffer, n);
        pclose(pipe);
    }
    return text;
}

QJsonArray array(const std::vector<double>& values) {
    QJsonArray list;
    for (const double value : values)
        list.append(value);
    return list;
}

/// The peer's answer; empty where it is not installed.
QJsonObject peer(const QuestPlusSpec& spec, const std::vector<int>& answers, const std::string& folder) {
    const std::string module = CHIRON_SOURCE_DIR "/build/npm/jsquest-plus/package/dist/jsQuestPlus.module.js";
    if (!std::ifstream(module))
        return {};
    const std::string file = folder + "/quest_plus_task.json";
    const QJsonObject task{{"stimuli", array(spec.stimuli[0].second)},
                           {"threshold", array(spec.parameters[0].values)},
                           {"slope", array(spec.parameters[1].values)},
                           {"lapse", array(spec.parameters[3].values)},
                           {"responses", array({answers.begin(), answers.end()})}};
    std::ofstream(file) << QJsonDocument(task).toJson().toStdString();
    const std::string out =
        said("node '" CHIRON_SOURCE_DIR "/tests/bench/quest_plus_peer.mjs' '" + module + "' '" + file + "'");
    return QJsonDocument::fromJson(QByteArray::fromStdString(out)).object();
}

void compare(std::vector<BenchRow>& rows, const char* name, const QuestPlusSpec& spec, double goal,
             const std::string& folder) {
    std::shared_ptr<const QuestPlusModel> model = *questPlusModel(spec);
    const std::vector<int> answers = answersOf(*model);
    std::vector<double> own, theirs;
    BenchRow row{.work = name, .peer = "jsquest-plus 2.1.0", .unit = "ms"};
    for (int round = 0; round < kRounds; ++round) {
        const QJsonObject given = peer(spec, answers, folder);
        const Ours mine = ours(model, answers);
        own.push_back(mine.trial_ms);
        if (given.isEmpty())
            continue;
        theirs.push_back(given["trial"].toDouble());
        int same = 0;
        for (int trial = 0; trial < kTrials; ++trial)
            same += given["chosen"][trial].toDouble() == mine.chosen[static_cast<std::size_t>(trial)] ? 1 : 0;
        row.agreement = text("%d of %d choices", same, kTrials);
    }
    row.oursMedian = median(own);
    if (!theirs.empty())
        row.peerMedian = median(theirs);
    if (goal > 0.0) {
        row.goal = text(">= %.0f times", goal);
        row.reached = theirs.empty() ? verdict(std::nullopt) : verdict(*row.ratio() >= goal);
    }
    rows.push_back(row);
}

void setUp(std::vector<BenchRow>& rows, const char* name, const QuestPlusSpec& spec, double goal_ms) {
    std::vector<double> own;
    for (int round = 0; round < kRounds; ++round)
        own.push_back(1e3 * cpuSeconds([&] { (void)questPlusModel(spec); }));
    BenchRow row{.work = name, .unit = "ms"};
    row.oursMedian = median(own);
    row.goal = text("< %.0f ms", goal_ms);
    row.reached = verdict(*row.oursMedian < goal_ms);
    rows.push_back(row);
}

} // namespace

int main(int argc, char** argv) {
    core::setModelFloatingPointEnvironment();
    const std::string folder = argc > 1 ? argv[1] : ".";
    printHeading("QUEST+: choose a stimulus and take its answer in, a trial");
    std::vector<BenchRow> rows;
    compare(rows, "40 stimuli x 4,000 parameters", grid(40, 40, 10, 10), 300.0, folder);
    compare(rows, "40 x 4,000, lapse fixed", grid(40, 80, 50, 1), 300.0, folder);
    compare(rows, "41 x 825", grid(41, 33, 5, 5), 0.0, folder);
    compare(rows, "61 x 3,075", grid(61, 41, 15, 5), 0.0, folder);
    compare(rows, "100 x 15,000", grid(100, 100, 30, 5), 0.0, folder);
    setUp(rows, "set-up, 40 x 4,000", grid(40, 40, 10, 10), 50.0);
    setUp(rows, "set-up, 100 x 15,000", grid(100, 100, 30, 5), 50.0);
    printTable(rows);
    std::printf("%d rounds in turn of %d trials; processor time; the peer in node.\n", kRounds, kTrials);
    return 0;
}
