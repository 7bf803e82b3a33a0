// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of procedure: undo, spoiled trials, ends, estimates.
#include "procedure_runs.h"
#include "psychophysics/procedures/posterior_grid.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace chiron;
using namespace chiron::tests;

namespace {

std::vector<ProcedureSpec> kinds() {
    StaircaseSpec staircase;
    staircase.stepsUp = {0.2, 0.1, 0.05};
    staircase.stop = {.trials = 30};
    PestSpec pest;
    pest.stop = {.trials = 30};
    ConstantSpec constant;
    constant.levels = {-1.0, -0.5, 0.0};
    constant.repeats = 10;
    DescendingSpec descending;
    descending.levels = {0.0, -0.3, -0.6, -0.9};
    descending.repeats = 10;
    descending.passes = 1;
    Rank3Spec rank3;
    rank3.differences = even(0.01, 0.2, 10);
    rank3.stop = {.trials = 30};
    QuestPlusSpec plus = weibull();
    plus.catchEvery = 0.2;
    plus.repeatLimit = 2;
    return {staircase, pest, constant, descending, QuestSpec{}, plus, rank3};
}

struct Run {
    std::vector<Stimulus> stimuli;
    double estimate = 0.0;
};

/// `disturbed`: every third trial is recorded wrongly and taken back, twice over.
Run runOf(const ProcedureSpec& spec, bool disturbed) {
    auto procedure = *makeProcedure(spec, 7);
    core::Random random(11);
    Run run;
    while (!procedure->done()) {
        const Choice choice = procedure->next();
        const int given = outcome(*procedure, random);
        for (int i = 0; disturbed && run.stimuli.size() % 3 == 1 && i < 2; ++i) {
            (void)procedure->record(0, choice.stimulus);
            (void)procedure->undo();
        }
        run.stimuli.push_back(choice.stimulus);
        (void)procedure->record(given, choice.stimulus);
    }
    const auto estimate = procedure->estimate();
    run.estimate = estimate.known ? estimate.parameters[0].mean : 0.0;
    return run;
}

} // namespace

class TestProcedures : public QObject {
    Q_OBJECT
private slots:
    void nothingIsKnownBeforeAnAnswer();
    void undoLeavesNoTrace();
    void undoAfterTheEnd();
    void spoiledKeepsTheOthersOrder();
    void refusals();
    void spoiledConstantComesLater();
    void pestBySteps();
    void pestStepsThatAreTheSmallest();
    void pestDeviationsJustReached();
    void descendingSaysItsBias();
    void evenNumberOfReversals();
    void questStaysInRange();
    void bothEndsOfAGridAreNamed();
    void logStepsComeBackFromTheEnd();
    void untruncatedStaircaseMayStartOutside();
    void pseInTheMiddleOfAPlateau();
};

/// Without an answer there is no estimate and no warning about the prior. A procedure with a posterior has an
/// estimate from the first answer on, and none again once that answer is undone.
void TestProcedures::nothingIsKnownBeforeAnAnswer() {
    for (const ProcedureSpec& spec : kinds()) {
        auto procedure = *makeProcedure(spec, 7);
        const bool hasPosterior = std::holds_alternative<QuestSpec>(spec) ||
                                  std::holds_alternative<QuestPlusSpec>(spec) ||
                                  std::holds_alternative<Rank3Spec>(spec);
        QVERIFY2(!procedure->estimate().known && procedure->estimate().warnings.empty(), kindOf(spec).data());
        QVERIFY(procedure->record(1, procedure->next().stimulus));
        QCOMPARE(procedure->estimate().known, hasPosterior);
        QVERIFY(procedure->undo());
        QVERIFY2(!procedure->estimate().known && procedure->estimate().warnings.empty(), kindOf(spec).data());
    }
}

void TestProcedures::undoLeavesNoTrace() {
    for (const ProcedureSpec& spec : kinds()) {
        const Run plain = runOf(spec, false);
        const Run disturbed = runOf(spec, true);
        QVERIFY2(plain.stimuli == disturbed.stimuli, kindOf(spec).data());
        QVERIFY(plain.estimate == disturbed.estimate);
        QVERIFY(!plain.stimuli.empty());
        auto procedure = *makeProcedure(spec, 7);
        const auto refused = procedure->undo();
        QVERIFY(!refused && refused.error().code == core::ErrorCode::wrongUse);
    }
}

/// The last answer is taken back: the procedure goes on where it was, and ends as it did.
void TestProcedures::undoAfterTheEnd() {
    for (const ProcedureSpec& spec : kinds()) {
        auto procedure = *makeProcedure(spec, 7);
        core::Random random(11);
        Choice last;
        int given = 0;
        while (!procedure->done()) {
            last = procedure->next();
            given = outcome(*procedure, random);
            QVERIFY(procedure->record(given, last.stimulus));
        }
        const int trials = procedure->trials();
        const auto estimate = procedure->estimate();
        QVERIFY2(procedure->undo(), kindOf(spec).data());
        QVERIFY2(!procedure->done(), kindOf(spec).data());
        QCOMPARE(procedure->trials(), trials - 1);
        QVERIFY2(procedure->next().stimulus == last.stimulus, kindOf(spec).data());
        QVERIFY(procedure->record(given, last.stimulus));
        QVERIFY(procedure->done() && procedure->trials() == trials);
        const auto again = procedure->estimate();
        QVERIFY(again.known == estimate.known &&
                (!again.known || again.parameters[0].mean == estimate.parameters[0].mean));
    }
}

/// A spoiled stimulus comes again at any later place, the last one too; the others stay in their order.
void TestProcedures::spoiledKeepsTheOthersOrder() {
    ConstantSpec spec;
    spec.levels = {1.0, 2.0, 3.0, 4.0, 5.0};
    spec.repeats = 1;
    spec.shuffled = false;
    std::set<std::size_t> places;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        auto procedure = *makeProcedure(spec, seed);
        QVERIFY(procedure->record(1, procedure->next().stimulus)); // 1.0
        procedure->spoiled();                                      // 2.0
        std::vector<double> rest;
        while (!procedure->done()) {
            rest.push_back(procedure->next().stimulus[0]);
            QVERIFY(procedure->record(1, procedure->next().stimulus));
        }
        QCOMPARE(rest.size(), std::size_t{4});
        const auto again = std::find(rest.begin(), rest.end(), 2.0);
        QVERIFY(again != rest.end() && again != rest.begin()); // never at once
        places.insert(static_cast<std::size_t>(again - rest.begin()));
        rest.erase(again);
        QVERIFY(rest == (std::vector<double>{3.0, 4.0, 5.0}));
    }
    QVERIFY(places == (std::set<std::size_t>{1, 2, 3}));
}

void TestProcedures::refusals() {
    for (const ProcedureSpec& spec : kinds()) {
        auto procedure = *makeProcedure(spec, 1);
        const Choice before = procedure->next();
        QVERIFY(!procedure->record(procedure->outcomes(), before.stimulus));
        QVERIFY(!procedure->record(-1, before.stimulus));
        QVERIFY(!procedure->record(0, {}));
        QVERIFY(!procedure->record(0, {std::nan("")}));
        QCOMPARE(procedure->trials(), 0);
        QVERIFY(procedure->next().stimulus == before.stimulus);
    }
    ConstantSpec empty;
    QVERIFY(!makeProcedure(empty, 1));
    QuestPlusSpec unknown = weibull();
    unknown.function = "sine";
    QVERIFY(!makeProcedure(unknown, 1));
    QuestPlusSpec falling;
    falling.function = "norm_cdf";
    falling.stimuli = {{"intensity", {0.0, 1.0}}};
    falling.parameters = {{"mean", {0.5}, {}, false},
                          {"sd", {-1.0, 1.0}, {}, false},
                          {"lower_asymptote", {0.5}, {}, false},
                          {"lapse_rate", {0.0}, {}, false}};
    falling.stop = {.trials = 5};
    const auto negative = makeProcedure(falling, 1);
    QVERIFY(!negative && negative.error().message.find("sd: expected values above 0") != std::string::npos);
}

void TestProcedures::spoiledConstantComesLater() {
    ConstantSpec spec;
    spec.levels = {1.0, 2.0, 3.0, 4.0};
    spec.repeats = 5;
    auto procedure = *makeProcedure(spec, 2);
    std::map<double, int> counts;
    for (int spoils = 0; !procedure->done();) {
        if (spoils++ % 2 == 0)
            procedure->spoiled();
        const Stimulus x = procedure->next().stimulus;
        ++counts[x[0]];
        QVERIFY(procedure->record(1, x));
    }
    QCOMPARE(procedure->trials(), 20);
    for (const auto& [level, count] : counts)
        QCOMPARE(count, 5);
    auto last = *makeProcedure(ConstantSpec{{1.0}, 1, true}, 1);
    last->spoiled();
    QCOMPARE(last->next().stimulus[0], 1.0);
}

/// Taylor & Creelman's rules, by hand: target 0.75, W 1: four right in a row (excess 0.25 each) leave the
/// bound at the fifth; two wrong do.
void TestProcedures::pestBySteps() {
    PestSpec spec;
    spec.start = 0.0;
    spec.step = 0.4;
    spec.smallestStep = 0.1;
    auto procedure = *makeProcedure(spec, 1);
    const auto feed = [&](int outcome, int times) {
        for (int i = 0; i < times; ++i)
            (void)procedure->record(outcome, procedure->next().stimulus);
        return procedure->next().stimulus[0];
    };
    QCOMPARE(feed(1, 4), 0.0);
    QCOMPARE(feed(1, 1), -0.4);
    QCOMPARE(feed(1, 5), -0.8);       // the second step is like the first
    QCOMPARE(feed(1, 5), -0.8 - 0.8); // the third doubles: no doubling before the last reversal
    QCOMPARE(feed(0, 2), -1.6 + 0.4); // a reversal halves
    QVERIFY(!procedure->done());
    QVERIFY(std::abs(feed(1, 5) - (-1.4)) < 1e-12); // another
    feed(0, 2);                                     // 0.1: the smallest
    QVERIFY(procedure->done());
    QCOMPARE(procedure->reversals(), 3);
    QVERIFY(std::abs(procedure->estimate().parameters[0].mean + 1.3) < 1e-12);
}

/// A step no larger than the smallest is the last, the first one too.
void TestProcedures::pestStepsThatAreTheSmallest() {
    PestSpec spec;
    spec.step = spec.smallestStep = 0.05;
    auto procedure = *makeProcedure(spec, 1);
    QCOMPARE(procedure->id(), std::string_view("pest@2")); // what ends otherwise has another id
    for (int trial = 0; trial < 5; ++trial) {
        QVERIFY(!procedure->done());
        QVERIFY(procedure->record(1, {0.0}));
    }
    QVERIFY(procedure->done());
    QVERIFY(procedure->estimate().known);
    QCOMPARE(procedure->estimate().parameters[0].mean, -0.05);
}

/// 6 right and 2 wrong where 0.9 are wanted: 6 - 8 * 0.9 is -1.2, and in binary fractions a little less. What
/// is just reached is not exceeded.
void TestProcedures::pestDeviationsJustReached() {
    struct Case {
        double target, wald;
        int right, wrong; ///< in this order; after them |k - n target| is the deviation
    };
    for (const Case& one : {Case{0.9, 1.2, 6, 2}, Case{0.7, 1.2, 4, 0}, Case{0.6, 1.2, 3, 0},
                            Case{0.9, 0.7, 7, 0}, Case{0.9, 1.4, 14, 0}, Case{0.55, 1.2, 1, 3}}) {
        PestSpec spec;
        spec.target = one.target;
        spec.waldDeviation = one.wald;
        auto procedure = *makeProcedure(spec, 1);
        for (int trial = 0; trial < one.right + one.wrong; ++trial)
            QVERIFY(procedure->record(trial < one.right ? 1 : 0, {0.0}));
        QVERIFY2(procedure->next().stimulus[0] == 0.0,
                 qPrintable(QStringLiteral("%1 %2").arg(one.target).arg(one.wald)));
        QVERIFY(procedure->record(one.wrong == 0 ? 1 : 0, {0.0}));
        QVERIFY(procedure->next().stimulus[0] != 0.0); // and now it is exceeded
    }
}

void TestProcedures::descendingSaysItsBias() {
    DescendingSpec spec;
    spec.levels = {0.3, 0.2, 0.1};
    auto procedure = *makeProcedure(spec, 1);
    for (const int outcome : {1, 0, 1, 0, 0, 1})
        QVERIFY(procedure->record(outcome, procedure->next().stimulus));
    QVERIFY(procedure->done());
    QCOMPARE(procedure->estimate().parameters[0].mean, 0.3);
    QVERIFY(procedure->estimate().method.find("overestimates") != std::string::npos);
    QVERIFY(procedure->id().find("legacy") != std::string_view::npos);
    QVERIFY(!procedure->record(1, {0.2}));
}

/// Half of the answers at two levels: the point of equality lies between them, whichever way round the axis
/// goes.
void TestProcedures::pseInTheMiddleOfAPlateau() {
    auto run = *makeProcedure(ConstantSpec{{1.0, 2.0, 3.0, 4.0}, 4, false}, 1);
    const int right[] = {0, 2, 2, 4};
    for (int block = 0; block < 4; ++block)
        for (const int most : right)
            QVERIFY(run->record(block < most ? 1 : 0, run->next().stimulus));
    double pse = 0.0;
    for (const auto& parameter : run->estimate().parameters)
        if (parameter.name == "pse")
            pse = parameter.mean;
    QCOMPARE(pse, 2.5);
}

/// Where only what is presented is truncated, the level itself may lie outside.
void TestProcedures::untruncatedStaircaseMayStartOutside() {
    StaircaseSpec spec;
    spec.start = 1.25;
    spec.maximum = 1.0;
    spec.truncate = false;
    auto run = makeProcedure(spec, 1);
    QVERIFY2(run, run ? "" : run.error().message.c_str());
    std::vector<double> presented;
    for (int trial = 0; trial < 4; ++trial) {
        presented.push_back((*run)->next().stimulus[0]);
        QVERIFY((*run)->record(1, {presented.back()}));
    }
    QVERIFY(presented[0] == 1.0 && presented[1] == 1.0 && presented[2] == 1.0 &&
            std::abs(presented[3] - 0.95) < 1e-12);
}

/// Down for thousands of trials and up again: never 0, never infinite.
void TestProcedures::logStepsComeBackFromTheEnd() {
    StaircaseSpec spec;
    spec.stepType = StaircaseSpec::StepType::log;
    spec.start = 1.0;
    spec.up = spec.down = 1;
    spec.stepsUp = {0.5};
    spec.truncate = false;
    spec.stop = {.trials = 5000};
    for (const int first : {1, 0}) {
        auto run = makeProcedure(spec, 1);
        QVERIFY2(run, run ? "" : run.error().message.c_str());
        for (int trial = 0; trial < 1500; ++trial)
            QVERIFY((*run)->record(first, (*run)->next().stimulus));
        const double end = (*run)->next().stimulus[0];
        QVERIFY(end > 0.0 && std::isfinite(end));
        for (int trial = 0; trial < 100; ++trial)
            QVERIFY((*run)->record(1 - first, (*run)->next().stimulus));
        QVERIFY(std::abs(std::log10((*run)->next().stimulus[0] / end)) > 30.0);
    }
}

/// Five reversals at 1, 0, 1, 0, 1 by a 1-up/1-down of step 1: the last four count, as many peaks as valleys
/// (Levitt 1971).
void TestProcedures::evenNumberOfReversals() {
    StaircaseSpec spec;
    spec.start = 1.0;
    spec.up = spec.down = 1;
    spec.stepsUp = {1.0};
    spec.stop = {.reversals = 5};
    auto run = *makeProcedure(spec, 1);
    for (int trial = 0; !run->done(); ++trial)
        QVERIFY(trial < 7 && run->record(run->next().stimulus[0] > 0.5 ? 1 : 0, run->next().stimulus));
    QCOMPARE(run->reversals(), 5);
    QCOMPARE(run->estimate().method, std::string("mean of the last 4 reversals"));
    QCOMPARE(run->estimate().parameters[0].mean, 0.5);
}

void TestProcedures::questStaysInRange() {
    QuestSpec spec;
    spec.minimum = -1.0;
    spec.maximum = 0.3;
    auto procedure = *makeProcedure(spec, 1);
    for (int trial = 0; trial < 40; ++trial) {
        const Stimulus x = procedure->next().stimulus;
        QVERIFY(x[0] >= -1.0 && x[0] <= 0.3);
        QVERIFY(procedure->record(0, x));
    }
    QVERIFY(procedure->done());
    const NamedEstimate e = procedure->estimate().parameters[0];
    QVERIFY(e.low < e.mean && e.mean < e.high);
}

/// Where the grid cuts the posterior off at both ends, the warning names both.
void TestProcedures::bothEndsOfAGridAreNamed() {
    QuestSpec spec;
    spec.range = 0.2; // an answer hardly distinguishes thresholds this close together
    auto narrow = *makeProcedure(spec, 1);
    QVERIFY(narrow->record(1, narrow->next().stimulus));
    const ProcedureEstimate both = narrow->estimate();
    QVERIFY(both.parameters[0].cutBelow && both.parameters[0].cutAbove);
    QCOMPARE(
        QString::fromStdString(both.warnings.at(0)),
        QStringLiteral("grid_edge: answers do not tell how small or how large threshold is: its estimate "
                       "and interval end with the procedure's grid"));
    const auto estimateOf = [](const std::vector<double>& prior) {
        return PosteriorGrid::make({ParameterGrid{"slope", {1.0, 2.0, 3.0}, prior, false}})
            .value()
            .estimate(0);
    };
    const NamedEstimate flat = estimateOf({1.0, 1.0, 1.0}), low = estimateOf({1.0, 1.0, 0.1}),
                        high = estimateOf({0.1, 1.0, 1.0}), inside = estimateOf({0.1, 1.0, 0.1});
    QVERIFY(flat.cutBelow && flat.cutAbove);
    QVERIFY(low.cutBelow && !low.cutAbove);
    QVERIFY(!high.cutBelow && high.cutAbove);
    QVERIFY(!inside.cutBelow && !inside.cutAbove);
    ProcedureEstimate named;
    named.parameters = {low, high, flat};
    warnOfGridEdges(named, 2);
    QCOMPARE(named.warnings.size(), std::size_t{2});
    QVERIFY(named.warnings[0].find("how small slope") != std::string::npos &&
            named.warnings[1].find("how large slope") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestProcedures)
#include "test_procedures.moc"
