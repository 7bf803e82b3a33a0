// SPDX-License-Identifier: GPL-3.0-or-later
// How far procedures are off, by simulated participants: psychophysics.md §1, §5.6, §5.7.
// CHIRON_SIMULATED_RUNS: runs of each (100; 400 in the long test). Bounds: the published sd and bias, and
// four standard errors of what so many runs can tell. No procedure is told the observer's lapses: the peers
// estimated them (QUEST+) or took 1 % (QUEST).
#include "core/random.h"
#include "psychophysics/observers/thurstone.h"
#include "psychophysics/procedures/quest_plus.h"
#include "psychophysics/procedures/rank3_quest_plus.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using namespace chiron::psychophysics;

namespace {

int runs() {
    return std::max(20, qEnvironmentVariableIntValue("CHIRON_SIMULATED_RUNS") == 0
                            ? 100
                            : qEnvironmentVariableIntValue("CHIRON_SIMULATED_RUNS"));
}

std::vector<double> even(double from, double to, double step) {
    std::vector<double> values;
    for (double i = 0.0; from + step * i < to + 0.5 * step; i += 1.0)
        values.push_back(from + step * i);
    return values;
}

struct Errors {
    int count = 0;
    double sum = 0.0, squares = 0.0;
    void add(double error) {
        ++count;
        sum += error;
        squares += error * error;
    }
    double bias() const { return sum / count; }
    double sd() const { return std::sqrt((squares - count * bias() * bias()) / (count - 1)); }
};

/// 2AFC Weibull in log10 units, slope 3.5, 2 % lapses.
double weibull(double x, double threshold) {
    return 0.5 + 0.48 * (1.0 - std::exp(-std::pow(10.0, 3.5 * (x - threshold))));
}

QuestPlusSpec fitted(double low, double high) {
    QuestPlusSpec spec;
    spec.stimuli = {{"intensity", even(-2.0, 0.0, 0.05)}};
    spec.parameters = {{"threshold", even(low, high, 0.02), {}, false},
                       {"slope", {2.0, 2.75, 3.5, 4.25, 5.0}, {}, false},
                       {"lower_asymptote", {0.5}, {}, false},
                       {"lapse_rate", {0.0, 0.01, 0.02, 0.04}, {}, false}};
    spec.stop = {.trials = 1000};
    return spec;
}

constexpr int kCounts[] = {20, 40, 60, 100};

/// One run; the error of the estimate after each of kCounts, into `errors`.
template <class Estimate>
void runOnce(Procedure& procedure, int run, std::array<Errors, 4>& errors, Estimate estimate) {
    core::Random random = core::Random::stream(static_cast<std::uint64_t>(run) + 1, "simulated 2afc");
    const double truth = random.uniform(-1.2, -0.4);
    int trial = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (; trial < kCounts[i]; ++trial) {
            const Stimulus x = procedure.next().stimulus;
            (void)procedure.record(random.uniform() < weibull(x[0], truth) ? 1 : 0, x);
        }
        const double value = estimate();
        if (std::isfinite(value))
            errors[i].add(value - truth);
    }
}

void report(const char* name, const std::array<Errors, 4>& errors) {
    for (std::size_t i = 0; i < 4; ++i)
        qInfo("%s, %d trials: sd %.3f, bias %+.3f (%d runs)", name, kCounts[i], errors[i].sd(),
              errors[i].bias(), errors[i].count);
}

/// A factor on an sd, and an amount on a bias, that chance alone exceeds once in ten thousand or less.
double slack(const Errors& errors) {
    return 1.0 + 4.0 / std::sqrt(2.0 * errors.count);
}
double biasSlack(const Errors& errors) {
    return 4.0 * errors.sd() / std::sqrt(static_cast<double>(errors.count));
}

} // namespace

class TestProcedureSimulations : public QObject {
    Q_OBJECT
private slots:
    void questPlus();
    void quest();
    void weightedStaircase();
    void rank3();
    void descendingRule();
};

void TestProcedureSimulations::questPlus() {
    constexpr double kPublished[] = {0.104, 0.057, 0.045, 0.036};
    const auto factory = procedureFactory(fitted(-1.4, -0.2));
    QVERIFY(factory);
    std::array<Errors, 4> errors;
    for (int run = 0; run < runs(); ++run) {
        auto procedure = (*factory)(1);
        runOnce(*procedure, run, errors, [&] { return procedure->estimate().parameters[0].mean; });
    }
    report("QUEST+", errors);
    for (std::size_t i = 0; i < 4; ++i) {
        QVERIFY(errors[i].sd() < kPublished[i] * slack(errors[i]));
        QVERIFY(std::abs(errors[i].bias()) < 0.02 + biasSlack(errors[i]));
    }
}

void TestProcedureSimulations::quest() {
    constexpr double kPublished[] = {0.099, 0.059, 0.044, 0.032};
    QuestSpec spec;
    spec.priorMean = -0.8;
    spec.priorSd = 0.4;
    spec.lapse = 0.01; // QUEST's default, as the peer has it; the observer's is 2 %
    spec.target = 0.01 * 0.5 + 0.99 * (1.0 - 0.5 * std::exp(-1.0)); // at the Weibull's own threshold
    spec.range = 3.0;
    spec.minimum = -2.0;
    spec.maximum = 0.0;
    spec.stop = {.trials = 1000};
    std::array<Errors, 4> errors;
    for (int run = 0; run < runs(); ++run) {
        auto procedure = *makeProcedure(spec, 1);
        runOnce(*procedure, run, errors, [&] { return procedure->estimate().parameters[0].mean; });
    }
    report("QUEST", errors);
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(errors[i].sd() < kPublished[i] * slack(errors[i]));
}

/// Garcia-Perez's steps, 1-up/3-down, then a fit to all trials over the range that QUEST+ is given too: from
/// 40 trials on, half the published sd of the fixed-step 1-up/2-down. At 20 trials a staircase from 0 has
/// hardly come down, and is only better.
void TestProcedureSimulations::weightedStaircase() {
    constexpr double kPublished[] = {0.256, 0.207, 0.158, 0.098};
    StaircaseSpec spec;
    spec.start = 0.0;
    spec.stepsUp = {0.3, 0.2, 0.1};
    spec.stepRatio = 0.7393;
    spec.minimum = -2.0;
    spec.maximum = 0.0;
    spec.stop = {.trials = 1000};
    const auto model = *questPlusModel(fitted(-1.4, -0.2));
    std::array<Errors, 4> errors, reversals;
    for (int run = 0; run < runs(); ++run) {
        auto procedure = *makeProcedure(spec, 1);
        QuestPlus fit(model, 1);
        const auto& log = static_cast<LoggedProcedure&>(*procedure).log();
        runOnce(*procedure, run, errors, [&] {
            for (std::size_t i = static_cast<std::size_t>(fit.trials()); i < log.size(); ++i)
                (void)fit.record(log[i].outcome, log[i].presented);
            return fit.estimate().parameters[0].mean;
        });
        auto again = *makeProcedure(spec, 1);
        runOnce(*again, run, reversals, [&] {
            return again->estimate().known ? again->estimate().parameters[0].mean : std::nan("");
        });
    }
    report("weighted 1-up/3-down, fitted", errors);
    report("weighted 1-up/3-down, reversals", reversals);
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(errors[i].sd() < (i == 0 ? 1.0 : 0.5) * kPublished[i] * slack(errors[i]));
}

void TestProcedureSimulations::rank3() {
    constexpr double kPublished[] = {0.155, 0.110, 0.080, 0.062};
    constexpr int kTrials[] = {10, 20, 40, 60};
    Rank3Spec spec;
    for (const double log10D : even(-2.4, -0.4, 0.05))
        spec.differences.push_back(std::pow(10.0, log10D));
    spec.log10Sigma = even(-2.2, -0.6, 0.025);
    spec.stop = {.trials = 1000};
    const auto factory = procedureFactory(spec);
    QVERIFY(factory);
    std::array<Errors, 4> errors;
    for (int run = 0; run < runs(); ++run) {
        core::Random random = core::Random::stream(static_cast<std::uint64_t>(run) + 1, "simulated rank3");
        const double truth = random.uniform(-1.8, -1.0);
        auto procedure = (*factory)(1);
        for (std::size_t i = 0; i < 4; ++i) {
            while (procedure->trials() < kTrials[i]) {
                const Stimulus x = procedure->next().stimulus;
                const auto p = rankProbabilities(x[0] / std::pow(10.0, truth), 0.02);
                int outcome = 0;
                for (double u = random.uniform() - p[0]; u >= 0.0 && outcome < 5;)
                    u -= p[static_cast<std::size_t>(++outcome)];
                QVERIFY(procedure->record(outcome, x));
            }
            errors[i].add(procedure->estimate().parameters[0].mean - truth);
        }
    }
    for (std::size_t i = 0; i < 4; ++i) {
        qInfo("rank-3 QUEST+, %d trials: sd %.3f, bias %+.3f (%d runs)", kTrials[i], errors[i].sd(),
              errors[i].bias(), errors[i].count);
        QVERIFY(errors[i].sd() < kPublished[i] * slack(errors[i]));
        QVERIFY(std::abs(errors[i].bias()) < 0.02 + biasSlack(errors[i]));
    }
}

/// P2's rule with rankings of three, 2 % lapses, 0.1 log10 steps from ten times the JND down.
void TestProcedureSimulations::descendingRule() {
    const struct {
        int repeats, passes;
    } rules[] = {{3, 2}, {3, 3}, {5, 4}};
    for (const auto& rule : rules) {
        Errors errors;
        for (int run = 0; run < 5 * runs(); ++run) {
            core::Random random =
                core::Random::stream(static_cast<std::uint64_t>(run) + 1, "simulated descent");
            DescendingSpec spec;
            spec.repeats = rule.repeats;
            spec.passes = rule.passes;
            const double log10Jnd = random.uniform(-1.6, -1.5); // wherever the levels fall
            for (int level = 0; level < 25; ++level)
                spec.levels.push_back(std::pow(10.0, -0.5 - 0.1 * level));
            auto procedure = *makeProcedure(spec, 1);
            while (!procedure->done()) {
                const Stimulus x = procedure->next().stimulus;
                const auto p = rankProbabilities(x[0] * kJndPerSigma / std::pow(10.0, log10Jnd), 0.02);
                QVERIFY(procedure->record(random.uniform() < p[0] ? 1 : 0, x));
            }
            if (procedure->estimate().known)
                errors.add(std::log10(procedure->estimate().parameters[0].mean) - log10Jnd);
        }
        qInfo("descending rule, %d of %d: bias %+.3f, sd %.3f log10 units (%d runs)", rule.passes,
              rule.repeats, errors.bias(), errors.sd(), errors.count);
        QVERIFY(errors.bias() > 0.17 - biasSlack(errors) && errors.bias() < 0.51 + biasSlack(errors));
    }
}

QTEST_APPLESS_MAIN(TestProcedureSimulations)
#include "test_procedure_simulations.moc"
