// SPDX-License-Identifier: GPL-3.0-or-later
// What every procedure chooses, trial after trial, and says, with each of its options, what it refuses and in
// which words, and what observers answer and plans come to, against what was kept: a run that was stored goes
// on only where none of this changes.
#include "support/kept_figures.h"
#include "tests/unit/psychophysics/procedure_runs.h"

#include "core/random.h"
#include "psychophysics/designs/latin_square.h"
#include "psychophysics/designs/williams.h"
#include "psychophysics/observers/simulated_observer.h"
#include "psychophysics/observers/thurstone.h"
#include "psychophysics/observers/tied_orders.h"
#include "psychophysics/planning/fisher_information.h"
#include "psychophysics/planning/run_simulator.h"
#include "psychophysics/planning/study_plan.h"
#include "psychophysics/procedures/blocked_sum.h"
#include "psychophysics/procedures/procedure_spec.h"
#include "psychophysics/procedures/quest.h"
#include "psychophysics/procedures/quest_plus.h"
#include "psychophysics/procedures/staircase.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace chiron;
using namespace psychophysics;
using tests::even;
using tests::Figures;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const QString kFile = QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/psychophysics/data/kept_procedures.txt");

void tell(Figures& out, const ProcedureEstimate& of) {
    out.say(QStringLiteral("estimate"), (of.known ? "known, " : "unknown, ") + of.method);
    for (const NamedEstimate& one : of.parameters) {
        const int cut = one.cutBelow && one.cutAbove ? 2
                        : one.cutBelow               ? -1
                        : one.cutAbove               ? 1
                                                     : 0; // 2: both
        out.add(QString::fromStdString(one.name), one.mean, one.sd, one.low, one.high, one.mode, cut);
    }
    out.say(QStringLiteral("warns"), of.warnings);
}

/// A run of `trials` at most: what was asked for, what was answered, and now and then what is made of it. An
/// observer with a threshold in the procedure's own unit answers; some trials are spoiled, taken back, or
/// presented a little otherwise than asked for.
void run(Figures& out, const char* name, const ProcedureSpec& spec, double threshold, double spread,
         int trials = 40, bool aside = true) {
    out.say(QStringLiteral("-- run"), name);
    auto made = makeProcedure(spec, 77);
    if (!made) {
        out.say(QStringLiteral("refused"), made.error().message);
        return;
    }
    Procedure& procedure = **made;
    out.say(QStringLiteral("id"), std::string(procedure.id()) + " of " + std::string(kindOf(spec)));
    out.add(QStringLiteral("begins"), procedure.outcomes(), procedure.done(), procedure.trials());
    tell(out, procedure.estimate());
    core::Random random(7);
    for (int i = 0; i < trials && !procedure.done(); ++i) {
        const Choice choice = procedure.next();
        Stimulus presented = choice.stimulus;
        if (aside && i % 9 == 4)
            presented[0] += 0.003;
        const bool right =
            random.uniform() < 0.5 + 0.48 / (1.0 + std::exp(-(presented[0] - threshold) / spread));
        const int outcome =
            procedure.outcomes() == 2 ? (right ? 1 : 0)
            : right                   ? 0
                    : static_cast<int>(random.below(static_cast<std::uint64_t>(procedure.outcomes())));
        const auto recorded = procedure.record(outcome, presented);
        out.each(QStringLiteral("%1").arg(i),
                 std::vector<double>{choice.stimulus[0], static_cast<double>(choice.candidate),
                                     choice.entropyMargin, static_cast<double>(outcome), recorded ? 1.0 : 0.0,
                                     static_cast<double>(procedure.trials()),
                                     static_cast<double>(procedure.reversals()),
                                     procedure.done() ? 1.0 : 0.0});
        if (!recorded)
            out.say(QStringLiteral("refused"), recorded.error().message);
        if (i % 11 == 6)
            out.add(QStringLiteral("taken back"), procedure.undo().has_value(), procedure.trials());
        if (i % 7 == 5 && !procedure.done())
            procedure.spoiled();
        if (i % 13 == 3)
            tell(out, procedure.estimate());
    }
    tell(out, procedure.estimate());
    for (const auto& [outcome, presented] :
         std::vector<std::pair<int, Stimulus>>{{-1, procedure.next().stimulus},
                                               {procedure.outcomes(), procedure.next().stimulus},
                                               {1, {}},
                                               {1, {1.0, 2.0, 3.0, 4.0}},
                                               {1, {kNaN}}})
        if (const auto recorded = procedure.record(outcome, presented); !recorded)
            out.say(QStringLiteral("refused"), recorded.error().message);
    while (procedure.trials() > 0 && procedure.undo()) {
    }
    const auto none = procedure.undo();
    out.say(QStringLiteral("none to take back"), none ? "" : none.error().message);
}

template <class Spec, class Change> Spec with(Change change) {
    Spec spec;
    change(spec);
    return spec;
}

template <class Spec>
void refusals(Figures& out, const Spec& good, std::initializer_list<void (*)(Spec&)> changes) {
    for (const auto change : changes) {
        Spec spec = good;
        change(spec);
        const auto made = makeProcedure(spec, 1);
        out.say(QString::fromStdString(std::string(kindOf(ProcedureSpec(spec)))),
                made ? std::string("made") : made.error().message);
    }
}

QuestPlusSpec grid(const char* function, std::vector<double> intensities,
                   std::vector<ParameterGrid> parameters) {
    QuestPlusSpec spec;
    spec.function = function;
    spec.stimuli = {{"intensity", std::move(intensities)}};
    spec.parameters = std::move(parameters);
    spec.stop = {.trials = 25};
    return spec;
}

} // namespace

class TestKeptProcedures : public QObject {
    Q_OBJECT
private slots:
    void staircases();
    void pestAndFixedOnes();
    void quest();
    void questPlus();
    void rank3();
    void refused();
    void sums();
    void observers();
    void planning();
    void designs();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const char* name, const Figures& figures) {
        const QString differs = m_kept.differs(QLatin1String(name), figures.lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_kept{kFile, tests::sameFigures};
};

void TestKeptProcedures::staircases() {
    Figures out;
    using Type = StaircaseSpec::StepType;
    run(out, "usual", StaircaseSpec{}, -0.4, 0.1);
    run(out, "sizes", with<StaircaseSpec>([](StaircaseSpec& s) {
            s.start = 1.0;
            s.up = 2;
            s.down = 2;
            s.stepsUp = {0.4, 0.2, 0.1};
            s.stepsDown = {0.3, 0.1};
            s.estimateReversals = 5;
            s.stop = {.reversals = 9};
        }),
        0.2, 0.1);
    run(out, "ratio", with<StaircaseSpec>([](StaircaseSpec& s) {
            s.start = 1.0;
            s.up = 1;
            s.down = 2;
            s.stepsUp = {0.2};
            s.stepRatio = 0.5488;
            s.initialOneUpOneDown = false;
            s.stop = {.trials = 35, .minimumTrials = 12, .reversals = 4};
        }),
        0.2, 0.1);
    run(out, "log", with<StaircaseSpec>([](StaircaseSpec& s) {
            s.start = 10.0;
            s.stepsUp = {0.2, 0.1};
            s.stepType = Type::log;
            s.minimum = 0.5;
            s.maximum = 10.0;
            s.stop = {.trials = 30};
        }),
        3.0, 0.5);
    run(out, "db", with<StaircaseSpec>([](StaircaseSpec& s) {
            s.start = 10.0;
            s.stepsUp = {4, 2};
            s.stepType = Type::db;
            s.newStepAtReversal = false;
            s.stop = {.trials = 30};
        }),
        3.0, 0.5);
    run(out, "not truncated", with<StaircaseSpec>([](StaircaseSpec& s) {
            s.start = 0.0;
            s.down = 1;
            s.stepsUp = {0.3};
            s.resetCounters = false;
            s.truncate = false;
            s.minimum = -0.2;
            s.maximum = 0.2;
            s.stop = {.trials = 30, .reversals = 3, .reversalsAndTrials = true};
        }),
        0.0, 0.05);
    run(out, "counts on", with<StaircaseSpec>([](StaircaseSpec& s) {
            s.start = 1.0;
            s.down = 2;
            s.stepsUp = {0.1};
            s.resetCounters = false;
            s.stop = {.trials = 30};
        }),
        0.3, 0.1);
    run(out, "truncated", with<StaircaseSpec>([](StaircaseSpec& s) {
            s.start = 0.0;
            s.down = 1;
            s.stepsUp = {0.3};
            s.minimum = -0.2;
            s.maximum = 0.2;
            s.stop = {.trials = 20};
        }),
        0.0, 0.05);
    for (const int up : {1, 2, 3})
        for (const int down : {1, 2, 4})
            out.add(QStringLiteral("target"), up, down, staircaseTarget(up, down),
                    staircaseTarget(up, down, 0.5));
    hold("staircases", out);
}

void TestKeptProcedures::pestAndFixedOnes() {
    Figures out;
    run(out, "pest", PestSpec{.start = 1.0}, 0.3, 0.1, 90, false);
    run(out, "pest, narrow",
        PestSpec{.start = 0.4,
                 .target = 0.8,
                 .waldDeviation = 0.5,
                 .step = 0.2,
                 .smallestStep = 0.02,
                 .largestStep = 0.3,
                 .minimum = 0.0,
                 .maximum = 0.6,
                 .stop = {.trials = 60}},
        0.3, 0.1, 90, false);
    run(out, "pest, one step",
        PestSpec{.start = 0.4, .step = 0.1, .smallestStep = 0.1, .stop = {.reversals = 2}}, 0.3, 0.1, 30,
        false);
    run(out, "pest, by reversals",
        PestSpec{.start = 0.4,
                 .waldDeviation = 0.6,
                 .smallestStep = 0.001,
                 .stop = {.trials = 80, .minimumTrials = 5, .reversals = 2}},
        0.3, 0.1, 80, false);
    run(out, "constant", ConstantSpec{{0.1, 0.2, 0.3, 0.4, 0.5}, 6, true}, 0.3, 0.1);
    run(out, "constant, in order", ConstantSpec{{0.5, 0.1, 0.3}, 4, false}, 0.3, 0.05, 40, false);
    run(out, "constant, one", ConstantSpec{{0.5}, 1, true}, 0.3, 0.05, 40, false);
    run(out, "descending", DescendingSpec{{0.8, 0.6, 0.4, 0.3, 0.2, 0.1}, 3, 2}, 0.4, 0.05, 60, false);
    run(out, "descending, all", DescendingSpec{{0.8, 0.6, 0.4}, 4, 2}, 0.0, 0.01, 60, false);
    run(out, "descending, none", DescendingSpec{{0.8, 0.6, 0.4}, 3, 3}, 2.0, 0.01, 60, false);
    // Proportions that fall, lie level or never cross.
    for (const std::vector<int>& right : std::vector<std::vector<int>>{{0, 1, 2, 3, 4},
                                                                       {2, 1, 3, 2, 4},
                                                                       {2, 2, 2, 2, 2},
                                                                       {4, 3, 2, 1, 0},
                                                                       {0, 0, 2, 4, 4},
                                                                       {1, 1, 3, 3, 4},
                                                                       {4, 4, 4, 4, 4},
                                                                       {0, 2, 2, 2, 4}}) {
        auto made = makeProcedure(ConstantSpec{{1, 2, 3, 4, 5}, 4, false}, 1);
        for (int i = 0; i < 20; ++i) {
            const Stimulus at = (*made)->next().stimulus;
            QVERIFY((*made)->record(i / 5 < right[static_cast<std::size_t>(i) % 5] ? 1 : 0, at));
        }
        tell(out, (*made)->estimate());
    }
    hold("pest and fixed ones", out);
}

void TestKeptProcedures::quest() {
    Figures out;
    run(out, "usual", QuestSpec{}, 0.2, 0.1);
    run(out, "mean", with<QuestSpec>([](QuestSpec& s) {
            s.priorMean = -1.0;
            s.priorSd = 0.3;
            s.target = 0.75;
            s.slope = 2.0;
            s.lapse = 0.03;
            s.guess = 0.25;
            s.grain = 0.02;
            s.range = 3.0;
            s.method = "mean";
            s.minimum = -1.4;
            s.maximum = -0.8;
            s.stop = {.trials = 30};
        }),
        -1.1, 0.1);
    run(out, "mode", with<QuestSpec>([](QuestSpec& s) {
            s.lapse = 0.0;
            s.grain = 0.05;
            s.range = 2.0;
            s.method = "mode";
            s.stop = {.trials = 30, .minimumTrials = 10, .sd = 0.12};
        }),
        -0.3, 0.1);
    run(out, "cut off", with<QuestSpec>([](QuestSpec& s) {
            s.priorSd = 2.0;
            s.grain = 0.05;
            s.range = 1.0;
            s.stop = {.trials = 15};
        }),
        3.0, 0.1);
    run(out, "yes-no", with<QuestSpec>([](QuestSpec& s) {
            s.target = 0.5;
            s.guess = 0.0;
            s.stop = {.trials = 20};
        }),
        0.1, 0.1);
    for (const double target : {0.6, 0.75, 0.9})
        for (const double lapse : {0.0, 0.05})
            out.add(QStringLiteral("epsilon"), target, lapse, questEpsilon(target, 3.5, 0.5, lapse),
                    questEpsilon(target, 1.2, 0.0, lapse), optimalQuantileOrder(1.0 - target, 1.0 - lapse));
    Quest fresh(QuestSpec{});
    for (const double order : {0.0, 0.025, 0.3, 0.5, 0.975, 1.0})
        out.add(QStringLiteral("quantile"), order, fresh.quantile(order), fresh.quantileOrder(), fresh.mode(),
                fresh.sd());
    hold("quest", out);
}

void TestKeptProcedures::questPlus() {
    Figures out;
    const std::vector<ParameterGrid> ends{{"lower_asymptote", {0.5}, {}, false},
                                          {"lapse_rate", {0.0, 0.03}, {}, false}};
    const auto shaped = [&](std::vector<ParameterGrid> shape) {
        shape.insert(shape.end(), ends.begin(), ends.end());
        return shape;
    };
    for (const char* function :
         {"weibull_log10", "logistic", "gumbel", "reverse_gumbel", "hyperbolic_secant"})
        run(out, function,
            grid(function, even(-1.0, 1.0, 11),
                 shaped({{"threshold", even(-0.8, 0.8, 9), {}, false}, {"slope", {1.0, 3.0}, {}, false}})),
            0.1, 0.2, 18);
    run(out, "weibull_db",
        grid("weibull_db", even(-20.0, 0.0, 11),
             shaped({{"threshold", even(-18.0, -2.0, 9), {}, false}, {"slope", {2.0, 5.0}, {}, false}})),
        -8.0, 2.0, 18);
    run(out, "weibull",
        grid("weibull", even(0.0, 2.0, 11),
             shaped({{"threshold", even(0.2, 1.8, 9), {}, false}, {"slope", {2.0, 5.0}, {}, false}})),
        0.8, 0.2, 18);
    run(out, "norm_cdf",
        grid("norm_cdf", even(-1.0, 1.0, 11),
             shaped({{"mean", even(-0.8, 0.8, 9), {}, false}, {"sd", {0.1, 0.4}, {}, false}})),
        0.1, 0.2, 18);
    run(out, "norm_cdf_2",
        grid("norm_cdf_2", even(-1.0, 1.0, 11),
             {{"mean", even(-0.8, 0.8, 9), {}, false},
              {"sd", {0.1, 0.4}, {}, false},
              {"lapse_rate", {0.0, 0.05}, {}, false}}),
        0.1, 0.2, 18);
    QuestPlusSpec spec = tests::weibull();
    run(
        out, "parameters in another order",
        [&] {
            QuestPlusSpec other = spec;
            std::swap(other.parameters[0], other.parameters[3]);
            return other;
        }(),
        -0.9, 0.1, 12);
    spec.parameters[1].nuisance = spec.parameters[3].nuisance = true;
    spec.parameters[0].prior = std::vector<double>(17, 1.0);
    spec.parameters[0].prior[8] = 5.0;
    spec.parameters[0].prior[2] = 0.0;
    run(out, "nuisance", spec, -0.9, 0.1, 20);
    spec = tests::weibull();
    spec.repeatLimit = 2;
    spec.catchEvery = 0.3;
    spec.seed = 3;
    run(out, "limited, catch trials", spec, -0.9, 0.1, 30);
    spec.catchEvery = 0.0;
    spec.stimuli = {{"intensity", {-1.0, -0.5, -0.5, -1.0}}};
    run(out, "alike", spec, -0.9, 0.1, 12);
    spec.stimuli = {{"intensity", {-1.0, -1.0}}};
    run(out, "all alike", spec, -0.9, 0.1, 6);
    spec = tests::weibull(61);
    spec.stop = {.trials = 60, .minimumTrials = 8, .sd = 0.15};
    run(out, "until it is known", spec, -0.9, 0.1, 60);
    spec = {};
    spec.function = "csf";
    spec.stimuli = {{"contrast", even(-40.0, 0.0, 6)},
                    {"spatial_freq", {0.0, 10.0, 20.0}},
                    {"temporal_freq", {0.0, 16.0}}};
    spec.parameters = {{"min_thresh", {-40.0, -30.0}, {}, false},
                       {"c0", {-60.0, -45.0}, {}, false},
                       {"cf", {0.8, 1.4}, {}, false},
                       {"cw", {0.0, 0.3}, {}, false},
                       {"slope", {3.0}, {}, false},
                       {"lower_asymptote", {0.5}, {}, false},
                       {"lapse_rate", {0.01}, {}, false}};
    spec.stop = {.trials = 12};
    run(out, "csf", spec, -25.0, 4.0, 12, false);
    spec = {};
    spec.function = "table";
    spec.outcomes = 3;
    spec.stimuli = {{"which", {0.0, 1.0, 2.0}}};
    spec.parameters = {{"sort", {1.0, 2.0}, {}, false}, {"aside", {0.0, 1.0}, {}, true}};
    spec.table = {{{0.7, 0.6, 0.1, 0.2}, {0.3, 0.3, 0.3, 0.3}, {0.5, 0.4, 0.4, 0.5}},
                  {{0.2, 0.2, 0.3, 0.3}, {0.3, 0.4, 0.4, 0.3}, {0.2, 0.2, 0.3, 0.3}},
                  {{0.1, 0.2, 0.6, 0.5}, {0.4, 0.3, 0.3, 0.4}, {0.3, 0.4, 0.3, 0.2}}};
    spec.stop = {.trials = 8};
    run(out, "table", spec, 1.0, 0.5, 8, false);
    spec.parameters[1].nuisance = false;
    run(out, "table, nothing aside", spec, 1.0, 0.5, 8, false);
    hold("quest plus", out);
}

void TestKeptProcedures::rank3() {
    Figures out;
    Rank3Spec spec;
    spec.differences = even(0.02, 0.3, 10);
    spec.stop = {.trials = 30, .minimumTrials = 10, .sd = 0.12};
    run(out, "rank3", spec, 0.1, 0.04, 30);
    spec.allowTies = true;
    spec.lapse = {0.02};
    run(out, "ties", spec, 0.1, 0.04, 16);
    spec.allowTies = false;
    spec.log10Sigma = even(-2.0, -0.5, 12);
    spec.repeatLimit = 1;
    spec.stop = {.trials = 15};
    run(out, "limited", spec, 0.1, 0.04, 16);
    hold("rank3", out);
}

void TestKeptProcedures::refused() {
    Figures out;
    using S = StaircaseSpec;
    refusals<S>(out, with<S>([](S& s) { s.stop = {.trials = 10}; }),
                {[](S&) {},
                 [](S& s) { s.start = kNaN; },
                 [](S& s) { s.start = 1e100; },
                 [](S& s) { s.start = -1.1e100; },
                 [](S& s) { s.up = 0; },
                 [](S& s) { s.down = 0; },
                 [](S& s) { s.stepsUp = {}; },
                 [](S& s) {
                     s.stepsUp = {0.1, 0.0};
                 },
                 [](S& s) { s.stepsDown = {1e101}; },
                 [](S& s) { s.stepsDown = {1e100}; },
                 [](S& s) { s.stepRatio = -0.1; },
                 [](S& s) { s.stepRatio = 1e101; },
                 [](S& s) {
                     s.minimum = 1.0;
                     s.maximum = 0.0;
                 },
                 [](S& s) { s.minimum = s.maximum = 0.0; },
                 [](S& s) { s.minimum = 0.1; },
                 [](S& s) { s.maximum = -0.1; },
                 [](S& s) {
                     s.minimum = 0.1;
                     s.truncate = false;
                 },
                 [](S& s) { s.stepType = S::StepType::db; },
                 [](S& s) {
                     s.stepType = S::StepType::log;
                     s.start = 1e-3;
                 },
                 [](S& s) { s.estimateReversals = 1; },
                 [](S& s) { s.estimateReversals = 2; },
                 [](S& s) { s.stop = {}; },
                 [](S& s) { s.stop = {.reversals = 1}; },
                 [](S& s) { s.stop = {.trials = -1}; }});
    using P = PestSpec;
    refusals<P>(out, {},
                {[](P&) {}, [](P& s) { s.start = kNaN; }, [](P& s) { s.minimum = 0.0; },
                 [](P& s) { s.minimum = 0.1; }, [](P& s) { s.maximum = 0.0; }, [](P& s) { s.maximum = -0.1; },
                 [](P& s) { s.target = 0.0; }, [](P& s) { s.target = 1.0; }, [](P& s) { s.target = 0.01; },
                 [](P& s) { s.waldDeviation = 0.0; }, [](P& s) { s.waldDeviation = HUGE_VAL; },
                 [](P& s) { s.smallestStep = 0.0; }, [](P& s) { s.smallestStep = 0.4; },
                 [](P& s) { s.smallestStep = 0.41; }, [](P& s) { s.largestStep = 0.4; },
                 [](P& s) { s.largestStep = 0.39; }, [](P& s) { s.largestStep = HUGE_VAL; }});
    using C = ConstantSpec;
    refusals<C>(out, {{0.1, 0.2}, 2, true},
                {[](C&) {}, [](C& s) { s.levels = {}; }, [](C& s) { s.levels = {kNaN}; },
                 [](C& s) { s.repeats = 0; }, [](C& s) { s.repeats = 500'000; },
                 [](C& s) { s.repeats = 500'001; }});
    using D = DescendingSpec;
    refusals<D>(out, {{0.3, 0.2}, 3, 2},
                {[](D&) {}, [](D& s) { s.levels = {}; }, [](D& s) { s.levels = {kNaN}; },
                 [](D& s) {
                     s.levels = {0.2, 0.3};
                 },
                 [](D& s) {
                     s.levels = {0.2, 0.2};
                 },
                 [](D& s) { s.repeats = 0; }, [](D& s) { s.passes = 0; }, [](D& s) { s.passes = 1; },
                 [](D& s) { s.passes = 3; }, [](D& s) { s.passes = 4; }});
    using Q = QuestSpec;
    refusals<Q>(out, {},
                {[](Q&) {},
                 [](Q& s) { s.priorMean = kNaN; },
                 [](Q& s) { s.priorSd = 0.0; },
                 [](Q& s) { s.priorSd = HUGE_VAL; },
                 [](Q& s) { s.slope = 0.0; },
                 [](Q& s) { s.slope = HUGE_VAL; },
                 [](Q& s) { s.guess = -0.1; },
                 [](Q& s) { s.guess = 0.0; },
                 [](Q& s) { s.guess = 1.0; },
                 [](Q& s) { s.lapse = -0.1; },
                 [](Q& s) { s.lapse = 0.0; },
                 [](Q& s) { s.lapse = 1.0; },
                 [](Q& s) { s.target = 0.5; },
                 [](Q& s) { s.target = 0.501; },
                 [](Q& s) { s.target = 0.995; },
                 [](Q& s) { s.target = 0.994; },
                 [](Q& s) { s.grain = 0.0; },
                 [](Q& s) { s.grain = 2.5; },
                 [](Q& s) { s.grain = 2.6; },
                 [](Q& s) { s.range = 0.0; },
                 [](Q& s) { s.grain = 4e-6; },
                 [](Q& s) { s.method = "median"; },
                 [](Q& s) {
                     s.minimum = 1.0;
                     s.maximum = 0.0;
                 },
                 [](Q& s) { s.minimum = s.maximum = 0.0; },
                 [](Q& s) { s.stop = {}; },
                 [](Q& s) { s.stop = {.sd = 0.1}; },
                 [](Q& s) { s.stop = {.trials = -1}; }});
    using W = QuestPlusSpec;
    refusals<W>(out, tests::weibull(5),
                {[](W&) {},
                 [](W& s) { s.function = "none"; },
                 [](W& s) { s.outcomes = 3; },
                 [](W& s) { s.stimuli = {}; },
                 [](W& s) { s.stimuli[0].second = {}; },
                 [](W& s) { s.stimuli[0].second = {kNaN}; },
                 [](W& s) { s.stimuli[0].first = "contrast"; },
                 [](W& s) { s.stimuli.push_back(s.stimuli[0]); },
                 [](W& s) { s.parameters.pop_back(); },
                 [](W& s) { s.parameters[0].name = "mean"; },
                 [](W& s) { s.parameters.push_back(s.parameters[0]); },
                 [](W& s) { s.parameters[0].values = {}; },
                 [](W& s) { s.parameters[0].values[3] = kNaN; },
                 [](W& s) { s.parameters[0].prior = {1.0}; },
                 [](W& s) { s.parameters[0].prior = std::vector<double>(17, 0.0); },
                 [](W& s) { s.parameters[0].prior = std::vector<double>(17, -1.0); },
                 [](W& s) { s.parameters[0].prior = std::vector<double>(17, 1e308); },
                 [](W& s) { s.parameters[2].values = {1.1}; },
                 [](W& s) { s.parameters[2].values = {-0.1}; },
                 [](W& s) { s.parameters[3].values = {0.6}; },
                 [](W& s) { s.parameters[3].values = {0.5}; },
                 [](W& s) { s.repeatLimit = -1; },
                 [](W& s) { s.catchEvery = -0.1; },
                 [](W& s) { s.catchEvery = 1.0; },
                 [](W& s) { s.catchEvery = 1.1; },
                 [](W& s) { s.catchEvery = 0.99; },
                 [](W& s) { s.stop = {}; },
                 [](W& s) { s.stop = {.sd = 0.1}; },
                 [](W& s) { s.stop = {.trials = -3}; },
                 [](W& s) { s.function = "weibull"; },
                 [](W& s) { s.function = "table"; },
                 [](W& s) {
                     s.stimuli[0].second = even(-2.0, 0.0, 200'000);
                     s.parameters[0].values = even(-1.8, -0.2, 2000);
                 }});
    W table;
    table.function = "table";
    table.stimuli = {{"which", {0.0, 1.0}}};
    table.parameters = {{"sort", {1.0, 2.0}, {}, false}, {"aside", {0.0}, {}, true}};
    table.table = {{{0.7, 0.1}, {0.3, 0.5}}, {{0.3, 0.9}, {0.7, 0.5}}};
    refusals<W>(out, table,
                {[](W&) {}, [](W& s) { s.outcomes = 3; },
                 [](W& s) {
                     s.outcomes = 1;
                     s.table.pop_back();
                 },
                 [](W& s) { s.table[0].pop_back(); },
                 [](W& s) {
                     s.table[0].pop_back();
                     s.table[1].pop_back();
                 },
                 [](W& s) { s.table[1][1].pop_back(); }, [](W& s) { s.table[0][0][0] = 0.71; },
                 [](W& s) {
                     s.table[0][0][0] = -0.1;
                     s.table[1][0][0] = 1.1;
                 },
                 [](W& s) { s.table[0][0][0] = kNaN; },
                 [](W& s) {
                     s.table = {{}, {}};
                 },
                 [](W& s) { std::swap(s.parameters[0], s.parameters[1]); }});
    using R = Rank3Spec;
    R rank;
    rank.differences = {0.1, 0.2};
    refusals<R>(out, rank,
                {[](R&) {}, [](R& s) { s.differences = {}; }, [](R& s) { s.differences = {0.0}; },
                 [](R& s) { s.differences = {kNaN}; }, [](R& s) { s.log10Sigma = {20.0}; },
                 [](R& s) {
                     s.log10Sigma = {-1.0, kNaN};
                 },
                 [](R& s) { s.lapse = {}; }, [](R& s) { s.lapse = {1.0}; }, [](R& s) { s.lapse = {-0.1}; },
                 [](R& s) {
                     s.lapse = {0.0, 0.99};
                 },
                 [](R& s) { s.stop = {}; }, [](R& s) { s.stop = {.sd = 0.1}; },
                 [](R& s) {
                     s.allowTies = true;
                     s.tieThresholds = {};
                 },
                 [](R& s) {
                     s.allowTies = true;
                     s.tieThresholds = {0.0};
                 },
                 [](R& s) {
                     s.allowTies = true;
                     s.tieThresholds = {20.1};
                 },
                 [](R& s) { s.tieThresholds = {}; }, [](R& s) { s.repeatLimit = -1; },
                 [](R& s) {
                     s.differences = even(0.01, 1.0, 100'000);
                     s.log10Sigma = even(-2.0, 0.0, 11);
                 },
                 [](R& s) {
                     s.differences = even(0.01, 1.0, 400'000);
                     s.log10Sigma = even(-2.0, 0.0, 11);
                     s.lapse = {0.0};
                 }});
    hold("refused", out);
}

void TestKeptProcedures::sums() {
    Figures out;
    core::Random random(13);
    std::vector<double> a(160, 0.0), b(160, 0.0);
    std::vector<float> high(160), low(160), rough(160);
    for (std::size_t i = 0; i < 150; ++i) {
        a[i] = random.uniform();
        b[i] = random.normal();
        high[i] = static_cast<float>(b[i]);
        low[i] = static_cast<float>(b[i] - static_cast<double>(high[i]));
        rough[i] = static_cast<float>(a[i]);
    }
    for (const ActiveBlocks& blocks :
         {ActiveBlocks{}, ActiveBlocks{0}, ActiveBlocks{1, 4}, ActiveBlocks{0, 1, 2, 3, 4}})
        out.add(QStringLiteral("blocks"), blocks.size(), blockedDot(a.data(), b.data(), blocks),
                blockedDot(a.data(), high.data(), low.data(), blocks),
                std::round(1e5 * roughDot(rough.data(), rough.data(), blocks)) / 1e5);
    for (const std::size_t count : {0U, 8U, 24U, 32U, 160U})
        out.add(QStringLiteral("sums"), count, blockedSum(a.data(), count),
                blockedDot(a.data(), b.data(), count), padded(count), padded(count + 1));
    hold("sums", out);
}

void TestKeptProcedures::observers() {
    Figures out;
    for (const char* text : {"weber:0.12",
                             "weber:0.1,lapse:0.02,bias:-0.5,ties:0.7",
                             "operator:expert",
                             "weber:0.2,operator:novice",
                             "weber:0.000001",
                             "weber:100",
                             "weber:0.1,lapse:0",
                             "weber:0.1,lapse:1",
                             "weber:0.1,bias:100,ties:100",
                             "lapse:0.1",
                             "weber:101",
                             "weber:0.0000009",
                             "weber:0.1,lapse:1.01",
                             "weber:0.1,lapse:-0.01",
                             "weber:0.1,bias:-101",
                             "weber:0.1,ties:-1",
                             "weber:0.1,ties:101",
                             "",
                             "weber",
                             "weber:",
                             "weber:x",
                             "weber:1x",
                             "weber:0.1,",
                             "weber:0.1,weber:0.2",
                             "weber:0.1,lapse:0.1,weber:0.2",
                             "speed:1",
                             "operator:",
                             "operator:A",
                             "operator:a_name",
                             "operator:abcdefghijabcdefghijabcdefghijab",
                             "operator:abcdefghijabcdefghijabcdefghijabc",
                             "operator:az,operator:az",
                             "operator:{",
                             "operator:`"}) {
        const auto spec = parseObserver(text);
        out.say(QLatin1String(text), spec ? observerText(*spec) : spec.error().message);
        if (spec)
            out.add(QStringLiteral("sigma"), sigmaOf(*spec));
    }
    for (int task = 0; task < kTasks; ++task)
        for (const ObserverSpec& spec :
             {ObserverSpec{}, ObserverSpec{.weber = 0.3, .lapse = 0.2, .bias = 0.8},
              ObserverSpec{.weber = 0.2, .ties = 2.0}}) {
            SimulatedObserver observer(spec, 19);
            std::vector<int> said;
            const auto which = static_cast<Task>(task);
            for (int i = 0; i < 36; ++i) {
                std::vector<double> places;
                const auto& all = arrangements(which);
                for (const int multiple : all[static_cast<std::size_t>(i) % all.size()])
                    places.push_back(multiple * 0.05);
                said.push_back(observer.answer(which, places));
            }
            said.push_back(observer.answer(which, {0.1, 0.2, 0.3, 0.4}));
            out.each(QStringLiteral("task %1").arg(task), said);
            out.add(QStringLiteral("sets, says"), observer.sigma(), observer.adjust(-0.02, 0.3),
                    observer.adjust(-1.0, 1.0), observer.adjust(-1.0, 1.0), observer.magnitude(0.3),
                    observer.magnitude(-0.3, 0.5), observer.magnitude(0.0, 2.0));
        }
    for (const double d : {-2.0, 0.0, 0.5, 1.3, 4.0, 12.0, 40.0}) {
        const auto pure = rankProbabilities(d), lapsing = rankProbabilities(d, 0.1);
        out.each(QStringLiteral("orders at %1").arg(d), std::vector<double>(pure.begin(), pure.end()));
        out.each(QStringLiteral("with lapses"), std::vector<double>(lapsing.begin(), lapsing.end()));
        for (const double tie : {0.0, 0.3, 1.0, 3.0}) {
            const auto tied = tiedRankProbabilities(d, tie), looked = TiedOrderTable(tie).at(d);
            out.each(QStringLiteral("ties of %1").arg(tie), std::vector<double>(tied.begin(), tied.end()));
            out.each(QStringLiteral("looked up"), std::vector<double>(looked.begin(), looked.end()));
            out.add(QStringLiteral("right"), rightOrderProbability(d, tie));
        }
    }
    for (int task = 0; task < kTasks; ++task) {
        const auto which = static_cast<Task>(task);
        for (int arrangement = -1; arrangement <= static_cast<int>(arrangements(which).size());
             ++arrangement) {
            const bool there = arrangement >= 0 && arrangement < static_cast<int>(arrangements(which).size());
            std::vector<int> outcomesOf{there ? correctAnswer(which, arrangement) : -9,
                                        there && showsDifference(which, arrangement) ? 1 : 0};
            for (int answer = -1; answer <= answers(which); ++answer)
                outcomesOf.push_back(outcomeOf(which, arrangement, answer));
            out.each(QStringLiteral("outcomes of task %1").arg(task), outcomesOf);
        }
        out.add(QStringLiteral("task"), task, answers(which), outcomes(which), placesOf(which),
                scoredOutcome(which, 0, 2), scoredOutcome(which, 1, 2),
                scoredOutcome(which, 0, outcomes(which)), scoredOutcome(which, 1, outcomes(which)));
        out.say(QStringLiteral("token"), std::string(token(which)));
    }
    hold("observers", out);
}

void TestKeptProcedures::planning() {
    Figures out;
    for (int task = 0; task < kTasks; ++task) {
        const auto which = static_cast<Task>(task);
        for (const double lapse : {0.0, 0.05})
            for (const bool all : {false, true}) {
                out.add(QStringLiteral("information"), task, lapse, all,
                        fisherInformation(which, 0.7, lapse, all),
                        fisherInformation(which, 2.0, lapse, all, 1.0),
                        fisherInformation(which, 2.0, lapse, all, 0.0));
                if (which != Task::rank3Ties) { // of ties it takes long, and is in the plans below
                    const BestSpacing best = bestSpacing(which, lapse, all);
                    out.add(QStringLiteral("best"), best.spacing, best.information, best.trialsFor10Percent);
                }
            }
        Condition condition;
        condition.id = "planned";
        condition.task = which;
        condition.stimulus.reference = 200.0;
        condition.stimulus.differences = even(0.01, 0.3, 30);
        condition.procedures = {ConstantSpec{{0.03, 0.06, 0.12, 0.24}, 10, true}};
        if (which == Task::twoAfc) {
            condition.procedures.push_back(with<StaircaseSpec>([](StaircaseSpec& s) {
                s.start = -1.0;
                s.stop = {.trials = 25};
            }));
            condition.procedures[0] = with<QuestSpec>([](QuestSpec& s) {
                s.priorMean = -1.2;
                s.stop = {.trials = 20};
            });
            condition.scale = ProcedureScale::logDifference;
        }
        if (which == Task::rank3)
            condition.procedures = {with<Rank3Spec>([&](Rank3Spec& s) {
                s.differences = condition.stimulus.differences;
                s.stop = {.trials = 25};
            })};
        TrialRules rules;
        rules.breakEvery = 15;
        for (const int runs : which == Task::rank3Ties ? std::vector<int>{3} : std::vector<int>{1, 5}) {
            const ConditionPlan plan =
                planCondition(condition, rules, {.weber = 0.15, .lapse = 0.02}, runs, 12);
            out.add(QStringLiteral("plan"), plan.runs, plan.withoutEstimate, plan.biasLog10, plan.sdLog10,
                    plan.coverage, plan.meanTrials, plan.biasError, plan.sdError, plan.coverageError,
                    plan.trialsError, plan.minutesError);
            out.add(QStringLiteral("and"), plan.weber10, plan.weber50, plan.weber90, plan.minutes,
                    plan.fisherPerTrial, plan.bestSpacing, plan.bestDifference);
            for (const Warning& warning : plan.warnings)
                out.say(QStringLiteral("warns"), warningText(warning));
        }
        const auto simulator = RunSimulator::make(condition);
        for (const ScoredTrial& trial : simulator->run({.weber = 0.2, .lapse = 0.1, .ties = 0.8}, 5))
            out.add(QStringLiteral("trial"), trial.procedure, trial.arrangement, trial.answer, trial.outcome,
                    trial.difference, trial.value.value_or(kNaN));
        rules.exploreLimit_s = task % 2 == 0 ? 0.0 : 5.0;
        rules.breakEvery = task % 3 == 0 ? 0 : 10;
        condition.stimulus.differences = {0.01, 0.02};
        condition.stimulus.attribute = Attribute::apex;
        const ConditionPlan apex = planCondition(condition, rules, {}, 0, 1);
        out.add(QStringLiteral("apex"), apex.minutes, apex.bestDifference, apex.warnings.size());
        condition.procedures = {};
        const auto refused = RunSimulator::make(condition);
        out.say(QStringLiteral("refused"), refused ? "" : refused.error().message);
        condition.stimulus.differences = {};
        condition.procedures = {with<QuestSpec>([](QuestSpec& s) { s.priorSd = -1.0; })};
        for (const Warning& warning : planCondition(condition, rules, {}, 2, 1).warnings)
            out.say(QStringLiteral("warns"), warningText(warning));
    }
    for (const double difference : {0.0, 0.02, 0.001, 1e-30, -0.1})
        out.add(QStringLiteral("scale"), difference, scaledDifference(ProcedureScale::difference, difference),
                scaledDifference(ProcedureScale::logDifference, difference),
                differenceOf(ProcedureScale::difference, difference),
                differenceOf(ProcedureScale::logDifference, difference),
                nearestCandidate({0.01, 0.02, 0.03}, difference), nearestCandidate({}, difference));
    out.add(QStringLiteral("nearest"), nearestCandidate({1.0, 2.0}, 1.5), nearestCandidate({1.0, 2.0}, 1.51),
            nearestCandidate({1.0, 2.0}, 9.0));
    for (const int participants : {1, 2, 12, 40})
        for (const bool paired : {true, false}) {
            PowerQuestion question;
            question.participants = participants;
            question.paired = paired;
            out.add(QStringLiteral("power"), participants, paired, power(question),
                    detectableRatio(question, 0.8), participants == 12 ? participantsFor(question, 0.9) : 0);
            question.alpha = 0.01;
            question.differenceLog10 = -0.2;
            question.personSdLog10 = 0.05;
            out.add(QStringLiteral("power"), power(question));
            question.runSdLog10 = question.personSdLog10 = question.effectSdLog10 = 0.0;
            out.add(QStringLiteral("without spread"), power(question));
            question.differenceLog10 = 0.0;
            out.add(QStringLiteral("nor difference"), power(question));
        }
    PowerQuestion hopeless;
    hopeless.runSdLog10 = 40.0;
    out.add(QStringLiteral("hopeless"), detectableRatio(hopeless, 0.8));
    hold("planning", out);
}

void TestKeptProcedures::designs() {
    Figures out;
    for (int n = 0; n <= 7; ++n) {
        for (const auto& row : williamsDesign(n))
            out.each(QStringLiteral("williams %1").arg(n), row);
        for (const auto& row : latinSquare(n, 5))
            out.each(QStringLiteral("latin %1").arg(n), row);
        for (const OrderDesign design :
             {OrderDesign::fixed, OrderDesign::random, OrderDesign::latinSquare, OrderDesign::williams})
            for (const int row : {0, 1, 4, 15})
                out.each(QStringLiteral("order %1, row %2").arg(static_cast<int>(design)).arg(row),
                         orderFor(design, n, row, 5));
    }
    hold("designs", out);
}

QTEST_APPLESS_MAIN(TestKeptProcedures)
#include "test_kept_procedures.moc"
