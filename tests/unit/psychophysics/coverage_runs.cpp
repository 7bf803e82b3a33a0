// SPDX-License-Identifier: GPL-3.0-or-later
#include "coverage_runs.h"

#include "core/random.h"
#include "psychophysics/fits/fit.h"
#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/observers/thurstone.h"
#include "psychophysics/planning/run_simulator.h"
#include "psychophysics/procedures/quest.h"
#include "psychophysics/study/run_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace coverage_runs {

using namespace chiron;
using namespace chiron::psychophysics;

namespace {

constexpr double kFactors[] = {1.0 / 3.0, 1.0, 3.0};

/// What one run gave for one quantity.
struct Outcome {
    bool covered = false, warned = false, interval = true;
    double influence = std::numeric_limits<double>::quiet_NaN();
};

bool holds(double low, double high, double truth) {
    return low <= truth && truth <= high;
}

Row rowOf(const QString& what, const QString& quantity, double factor, const std::vector<Outcome>& outcomes) {
    Row row{what, quantity, factor, static_cast<int>(outcomes.size())};
    std::vector<double> influences;
    for (const Outcome& each : outcomes) {
        row.covered += each.covered ? 1 : 0;
        row.warned += each.warned ? 1 : 0;
        row.withoutInterval += each.interval ? 0 : 1;
        row.missedInSilence += each.covered || each.warned ? 0 : 1;
        if (std::isfinite(each.influence))
            influences.push_back(each.influence);
    }
    std::sort(influences.begin(), influences.end());
    row.influence =
        influences.empty() ? std::numeric_limits<double>::quiet_NaN() : influences[influences.size() / 2];
    return row;
}

// Fits: eight levels of 40 trials over a range of 1 (spacing 0.143), width 0.5 expected.

PsychometricData answersOf(core::Random& random, const FitResult& observer) {
    PsychometricData data;
    for (int i = 0; i < 8; ++i) {
        double right = 0.0;
        for (int trial = 0; trial < 40; ++trial)
            right += random.uniform() < proportionAt(observer, i / 7.0) ? 1.0 : 0.0;
        data.x.push_back(i / 7.0);
        data.k.push_back(right);
        data.n.push_back(40.0);
    }
    return data;
}

struct Fitting {
    const char* name;
    Sigmoid function;
    double guess; ///< of the observer; told to the fit, except in yes-no
    bool yesNo;   ///< the guess is free, too
    std::function<FitResult(const PsychometricData&, FitOptions)> fit;
};

void addFits(std::vector<Row>& rows, int runs, std::uint64_t seed, const QString& only) {
    const auto bayes = [](const PsychometricData& data, FitOptions options) {
        return fitBayesian(data, options);
    };
    const auto wide = [](const PsychometricData& data, FitOptions options) {
        options.widthPrior = WidthPrior::wide;
        return fitBayesian(data, options);
    };
    const auto likely = [](const PsychometricData& data, const FitOptions& options) {
        return fitMaximumLikelihood(data, options);
    };
    const Fitting fittings[] = {{"fit, bayes, 2AFC", Sigmoid::gauss, 0.5, false, bayes},
                                {"fit, bayes, wide prior, 2AFC", Sigmoid::gauss, 0.5, false, wide},
                                {"fit, bayes, 4AFC logistic", Sigmoid::logistic, 0.25, false, bayes},
                                {"fit, bayes, yes-no", Sigmoid::gauss, 0.02, true, bayes},
                                {"fit, ml, 2AFC", Sigmoid::gauss, 0.5, false, likely},
                                {"fit, ml, yes-no", Sigmoid::gauss, 0.02, true, likely}};
    for (const Fitting& fitting : fittings) {
        if (!QString::fromLatin1(fitting.name).contains(only))
            continue;
        for (const double factor : kFactors) {
            std::vector<Outcome> threshold, width;
            for (int run = 0; run < runs; ++run) {
                core::Random random =
                    core::Random::stream(core::Random::mix(seed, "fit " + std::to_string(run)), fitting.name);
                FitResult observer;
                observer.function = fitting.function;
                observer.best = {random.uniform(0.35, 0.65), 0.5 * factor, 0.02, fitting.guess, 0.0};
                FitOptions options;
                options.function = fitting.function;
                options.guess = fitting.yesNo ? Asymptote::fitted() : Asymptote::fixedAt(fitting.guess);
                const FitResult fit = fitting.fit(answersOf(random, observer), options);
                const auto outcome = [&](const FitInterval& ci, double truth, double influence) {
                    return Outcome{holds(ci.low, ci.high, truth), !fit.warnings.empty(),
                                   std::isfinite(ci.low), influence};
                };
                threshold.push_back(
                    outcome(fit.ci.threshold, observer.best.threshold, fit.priorInfluence.threshold));
                width.push_back(outcome(fit.ci.width, observer.best.width, fit.priorInfluence.width));
            }
            rows.push_back(
                rowOf(QString::fromLatin1(fitting.name), QStringLiteral("threshold"), factor, threshold));
            rows.push_back(rowOf(QString::fromLatin1(fitting.name), QStringLiteral("width"), factor, width));
        }
    }
}

// QUEST: slope 3.5 assumed, an observer's slope a third or three times that (a flat one has the larger
// width).

void addQuest(std::vector<Row>& rows, int runs, std::uint64_t seed, const QString& only) {
    if (!QStringLiteral("quest, its own interval").contains(only) &&
        !QStringLiteral("quest, slope open").contains(only))
        return;
    for (const double factor : kFactors) {
        std::vector<Outcome> own, open;
        for (int run = 0; run < runs; ++run) {
            core::Random random =
                core::Random::stream(core::Random::mix(seed, "quest " + std::to_string(run)), "answers");
            QuestSpec spec;
            spec.priorMean = -0.8;
            spec.priorSd = 0.5;
            spec.stop = {.trials = 80};
            Quest quest(spec);
            const double slope = spec.slope / factor,
                         truth = random.uniform(-1.2, -0.4); // where the target is reached
            const double epsilon = questEpsilon(spec.target, slope, 0.5, 0.01);
            while (!quest.done()) {
                const Stimulus x = quest.next().stimulus;
                const double p =
                    0.01 * 0.5 +
                    0.99 * (1.0 - 0.5 * std::exp(-std::pow(10.0, slope * (x[0] - truth + epsilon))));
                (void)quest.record(random.uniform() < p ? 1 : 0, x);
            }
            const ProcedureEstimate estimate = quest.estimate();
            own.push_back({holds(quest.quantile(0.025), quest.quantile(0.975), truth),
                           !estimate.warnings.empty(), true, quest.sd() / spec.priorSd});
            open.push_back({holds(estimate.parameters[0].low, estimate.parameters[0].high, truth),
                            !estimate.warnings.empty(), true, quest.sd() / spec.priorSd});
        }
        rows.push_back(
            rowOf(QStringLiteral("quest, its own interval"), QStringLiteral("threshold"), factor, own));
        rows.push_back(rowOf(QStringLiteral("quest, slope open"), QStringLiteral("threshold"), factor, open));
    }
}

// Runs of studies: the Thurstone observer's σ, made for 0.05 in log10 units.

std::vector<double> spread(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
    return values;
}

Condition conditionOf(Task task, ProcedureSpec procedure, ProcedureScale scale = ProcedureScale::difference) {
    Condition condition;
    condition.id = "coverage";
    condition.task = task;
    condition.stimulus.reference = 200.0;
    condition.stimulus.differences = spread(0.01, 0.4, 41);
    condition.scale = scale;
    condition.procedures = {std::move(procedure)};
    return condition;
}

std::vector<std::pair<QString, Condition>> conditions() {
    const auto constant = [](int repeats) {
        ConstantSpec spec;
        spec.levels = spread(0.02, 0.2, 8);
        spec.repeats = repeats;
        return spec;
    };
    Rank3Spec rank3;
    rank3.differences = spread(0.01, 0.4, 41);
    for (int i = 0; i <= 32; ++i)
        rank3.log10Sigma.push_back(-2.1 + 0.05 * i);
    rank3.stop = {.trials = 60};
    StaircaseSpec staircase;
    staircase.start = std::log10(0.4);
    staircase.stepsUp = {0.3, 0.2, 0.1};
    staircase.down = 3;
    staircase.stepRatio = 0.7393;
    staircase.minimum = std::log10(0.01);
    staircase.maximum = std::log10(0.4);
    staircase.stop = {.trials = 80};
    QuestSpec quest;
    quest.priorMean = -1.1;
    quest.priorSd = 0.5;
    quest.minimum = -2.0;
    quest.maximum = std::log10(0.4);
    quest.stop = {.trials = 80};
    QuestPlusSpec questPlus;
    questPlus.stimuli = {{"difference", {}}};
    for (const double d : spread(0.01, 0.4, 41))
        questPlus.stimuli[0].second.push_back(std::log10(d));
    questPlus.parameters = {{"threshold", {}, {}, false},
                            {"slope", {1.5, 2.5, 3.5}, {}, false},
                            {"lower_asymptote", {0.5}, {}, false},
                            {"lapse_rate", {0.02}, {}, false}};
    for (int i = 0; i <= 40; ++i)
        questPlus.parameters[0].values.push_back(-2.0 + 0.04 * i);
    questPlus.stop = {.trials = 80};
    DescendingSpec descending;
    descending.repeats = 5;
    descending.passes = 4;
    for (int level = 0; level < 16; ++level)
        descending.levels.push_back(0.4 * std::pow(10.0, -0.1 * level));
    PestSpec pest;
    pest.start = std::log10(0.2);
    pest.minimum = std::log10(0.01);
    pest.maximum = std::log10(0.4);
    pest.stop = {.trials = 120};
    return {
        {QStringLiteral("run, constant, rank3"), conditionOf(Task::rank3, constant(8))},
        {QStringLiteral("run, constant, 2afc"), conditionOf(Task::twoAfc, constant(20))},
        {QStringLiteral("run, constant, 3afc"), conditionOf(Task::threeAfc, constant(15))},
        {QStringLiteral("run, constant, oddity"), conditionOf(Task::oddity, constant(20))},
        {QStringLiteral("run, constant, same_different"), conditionOf(Task::sameDifferent, constant(30))},
        {QStringLiteral("run, constant, yes_no"), conditionOf(Task::yesNo, constant(30))},
        {QStringLiteral("run, rank3_quest_plus"), conditionOf(Task::rank3, rank3)},
        {QStringLiteral("run, quest_plus, 2afc"),
         conditionOf(Task::twoAfc, questPlus, ProcedureScale::logDifference)},
        {QStringLiteral("run, quest, 2afc"), conditionOf(Task::twoAfc, quest, ProcedureScale::logDifference)},
        {QStringLiteral("run, staircase, 2afc"),
         conditionOf(Task::twoAfc, staircase, ProcedureScale::logDifference)},
        {QStringLiteral("run, pest, 2afc"), conditionOf(Task::twoAfc, pest, ProcedureScale::logDifference)},
        {QStringLiteral("run, descending, rank3"), conditionOf(Task::rank3, descending)}};
}

void addRuns(std::vector<Row>& rows, int runs, std::uint64_t seed, const QString& only) {
    constexpr double kExpectedSigma = 0.05;
    for (const auto& [name, condition] : conditions()) {
        if (!name.contains(only))
            continue;
        const auto simulator = RunSimulator::make(condition);
        for (const double factor : kFactors) {
            std::vector<Outcome> outcomes;
            const double sigma = kExpectedSigma * factor;
            for (int run = 0; simulator && run < runs; ++run) {
                const std::uint64_t own = core::Random::mix(seed, name.toStdString() + std::to_string(run));
                const RunEstimate estimate = estimateRun(
                    condition,
                    simulator->run({.weber = std::pow(10.0, 0.9538725524089398 * sigma) - 1.0, .lapse = 0.02},
                                   own),
                    own);
                outcomes.push_back({holds(estimate.sigma95.low, estimate.sigma95.high, sigma),
                                    !estimate.warnings.empty(), std::isfinite(estimate.sigma95.low),
                                    estimate.priorInfluence});
            }
            rows.push_back(rowOf(simulator ? name
                                           : name + QStringLiteral(": ") +
                                                 QString::fromStdString(simulator.error().message),
                                 QStringLiteral("sigma"), factor, outcomes));
        }
    }
}

} // namespace

std::vector<Row> coverageTable(int runs, std::uint64_t seed, const QString& only) {
    std::vector<Row> rows;
    addFits(rows, runs, seed, only);
    addQuest(rows, runs, seed, only);
    addRuns(rows, runs, seed, only);
    return rows;
}

int fewestHeld(int runs, int rows) {
    int held = 0;
    while (held < runs && binomialLowerTail(held, runs, 0.95) < 0.05 / rows)
        ++held;
    return held;
}

void print(const std::vector<Row>& rows) {
    std::printf("| procedure and fit | of | true / expected | covered | missed, not warned | warned | no "
                "interval | prior's part |\n|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows)
        std::printf("| %s | %s | %s | %d of %d | %d | %d | %d | %.2f |\n", qPrintable(row.what),
                    qPrintable(row.quantity),
                    row.factor < 1.0   ? "1/3"
                    : row.factor > 1.0 ? "3"
                                       : "1",
                    row.covered, row.runs, row.missedInSilence, row.warned, row.withoutInterval,
                    row.influence);
    std::fflush(stdout);
}

} // namespace coverage_runs
