// SPDX-License-Identifier: GPL-3.0-or-later
// QUEST+ against entropy summed by brute force; ties, caps, catch trials, stimuli off the grid.
#include "procedure_runs.h"
#include "psychophysics/procedures/quest_plus.h"
#include "psychophysics/procedures/rank3_quest_plus.h"

#include <QtTest>
#include <cmath>
#include <map>

using namespace chiron;
using namespace chiron::tests;

namespace {

/// Expected entropy of every stimulus, from scratch.
std::vector<double> bruteForce(const QuestPlusModel& model, const PosteriorGrid& posterior) {
    std::vector<double> expected(model.stimuli.size(), 0.0);
    std::vector<double> likelihood;
    for (std::size_t x = 0; x < expected.size(); ++x)
        for (int r = 0; r < model.tables->outcomes(); ++r) {
            model.tables->likelihood(x, r, likelihood);
            double total = 0.0;
            std::vector<double> joint(posterior.cells());
            for (std::size_t c = 0; c < joint.size(); ++c)
                total += joint[c] = likelihood[c] * posterior.probability()[c];
            for (const double p : joint)
                expected[x] -= p > 0.0 ? p * std::log(p / total) : 0.0;
        }
    return expected;
}

/// Whether each of 40 choices has the least entropy within 1e-9, and its margin is right.
QString compareWithBruteForce(const core::Result<std::shared_ptr<const QuestPlusModel>>& model) {
    if (!model)
        return QString::fromStdString(model.error().message);
    QuestPlus run(*model, 1);
    core::Random random(3);
    for (int trial = 0; trial < 40; ++trial) {
        const std::vector<double> expected = bruteForce(**model, run.posterior());
        const Choice choice = run.next();
        std::vector<double> sorted = expected;
        std::sort(sorted.begin(), sorted.end());
        std::size_t lowest = 0;
        while (expected[lowest] > sorted[0] + 1e-9)
            ++lowest;
        if (expected[static_cast<std::size_t>(choice.candidate)] > sorted[0] + 2e-9)
            return QString("trial %1: another stimulus").arg(trial);
        if (std::abs(choice.entropyMargin - (sorted[1] - sorted[0])) > 1e-9)
            return QString("trial %1: margin").arg(trial);
        if (sorted[1] - sorted[0] > 2e-9 && choice.candidate != static_cast<int>(lowest))
            return QString("trial %1: not the best").arg(trial);
        if (std::abs(run.expectedEntropy() - sorted[0]) > 1e-9)
            return QString("trial %1: entropy").arg(trial);
        if (!run.record(outcome(run, random), choice.stimulus))
            return QString("trial %1: refused").arg(trial);
    }
    return {};
}

} // namespace

class TestQuestPlus : public QObject {
    Q_OBJECT
private slots:
    void entropyByBruteForce();
    void theLeastIsFoundAmongThoseThatAreLeft();
    void duplicatedStimulusIsATie();
    void impossibleOutcome();
    void repeatLimitAndCatchTrials();
    void offGridStimulus();
    void nuisanceByBruteForce();
    void offsetChangesNothing();
    void capHoldsForRoundedStimuli();
    void undoTakesTheRowThatWasChosen();
    void dimensionsGoByName();
    void rankingThatIsCheckedCanBeMade();
};

void TestQuestPlus::theLeastIsFoundAmongThoseThatAreLeft() {
    const std::vector<double> gains{-0.1, -0.4, -0.4, -0.3};
    const BestStimulus tied = bestOf(gains, {});
    QCOMPARE(tied.index, 1); // the lowest of the two
    QCOMPARE(tied.gain, -0.4);
    QCOMPARE(tied.margin, 0.0);
    const std::vector<int> both{1, 2}, all{0, 1, 2, 3}, allButOne{0, 1, 2};
    const BestStimulus other = bestOf(gains, both);
    QCOMPARE(other.index, 3);
    QVERIFY(std::abs(other.margin - 0.2) < 1e-15);
    QVERIFY(bestOf(gains, allButOne).index == 3 &&
            std::isnan(bestOf(gains, allButOne).margin)); // there is no second one
    QCOMPARE(bestOf(gains, all).index, -1);
}

void TestQuestPlus::entropyByBruteForce() {
    QCOMPARE(compareWithBruteForce(questPlusModel(weibull())), QString());
    QuestPlusSpec shuffled = weibull();
    std::reverse(shuffled.stimuli[0].second.begin(), shuffled.stimuli[0].second.end());
    std::swap(shuffled.stimuli[0].second[2], shuffled.stimuli[0].second[15]);
    shuffled.parameters[0].prior = even(1.0, 3.0, 17);
    QCOMPARE(compareWithBruteForce(questPlusModel(shuffled)), QString());
    QuestPlusSpec certain = weibull(); // likelihoods of exactly 0 and 1
    certain.stimuli[0].second = even(-8.0, 6.0, 29);
    certain.parameters[2].values = {0.0, 0.5};
    certain.parameters[0].prior = std::vector<double>(17, 0.0);
    certain.parameters[0].prior[3] = certain.parameters[0].prior[9] = 1.0;
    QCOMPARE(compareWithBruteForce(questPlusModel(certain)), QString());
    Rank3Spec rank3;
    rank3.differences = even(0.005, 0.3, 25);
    QCOMPARE(compareWithBruteForce(rank3Model(rank3)), QString());
}

void TestQuestPlus::duplicatedStimulusIsATie() {
    QuestPlusSpec spec = weibull();
    spec.stimuli[0].second.insert(spec.stimuli[0].second.end(), spec.stimuli[0].second.begin(),
                                  spec.stimuli[0].second.end());
    auto twice = *makeProcedure(spec, 1);
    auto once = *makeProcedure(weibull(), 1);
    core::Random random(5);
    for (int trial = 0; trial < 30; ++trial) {
        const Choice choice = twice->next();
        QVERIFY(choice.candidate < 21);
        QVERIFY(choice.entropyMargin < 1e-12);
        QCOMPARE(choice.candidate, once->next().candidate);
        const int given = outcome(*once, random);
        QVERIFY(twice->record(given, choice.stimulus) && once->record(given, choice.stimulus));
    }
}

void TestQuestPlus::impossibleOutcome() {
    QuestPlusSpec spec = weibull();
    spec.parameters[2].values = {1.0};
    spec.parameters[3].values = {0.0};
    auto procedure = *makeProcedure(spec, 1);
    const Choice before = procedure->next();
    const auto refused = procedure->record(0, before.stimulus);
    QVERIFY(!refused && refused.error().code == core::ErrorCode::badInput);
    QCOMPARE(procedure->trials(), 0);
    QVERIFY(procedure->record(1, before.stimulus));
}

void TestQuestPlus::repeatLimitAndCatchTrials() {
    QuestPlusSpec spec = weibull();
    spec.repeatLimit = 1;
    spec.stop = {.trials = 200};
    auto capped = *makeProcedure(spec, 1);
    int last = -1;
    while (!capped->done()) {
        const Choice choice = capped->next();
        QVERIFY(choice.candidate != last);
        last = choice.candidate;
        QVERIFY(capped->record(1, choice.stimulus));
    }
    spec.repeatLimit = 0;
    spec.catchEvery = 0.25;
    auto withCatch = *makeProcedure(spec, 1);
    int caught = 0;
    while (!withCatch->done()) {
        const Choice choice = withCatch->next();
        caught += std::isnan(choice.entropyMargin) ? 1 : 0;
        QVERIFY(!std::isnan(choice.entropyMargin) || choice.stimulus[0] == 0.0); // the easiest
        QVERIFY(withCatch->record(choice.stimulus[0] > -1.0 ? 1 : 0, choice.stimulus));
    }
    QVERIFY(caught > 30 && caught < 70);
}

/// What was presented counts, on the grid or not: between two grid points, an estimate between theirs.
void TestQuestPlus::offGridStimulus() {
    double means[3];
    int i = 0;
    for (const double presented : {-1.0, -0.96, -0.9}) {
        auto procedure = *makeProcedure(weibull(), 1);
        QVERIFY(procedure->record(0, {presented}));
        means[i++] = procedure->estimate().parameters[0].mean;
    }
    QVERIFY(means[0] < means[1] && means[1] < means[2]);
}

void TestQuestPlus::nuisanceByBruteForce() {
    QuestPlusSpec spec = weibull();
    spec.parameters[1].nuisance = spec.parameters[3].nuisance = true;
    const auto model = *questPlusModel(spec);
    QuestPlus run(model, 1);
    core::Random random(8);
    std::vector<double> likelihood;
    for (int trial = 0; trial < 15; ++trial) {
        const Choice choice = run.next();
        std::vector<double> expected;
        for (std::size_t x = 0; x < model->stimuli.size(); ++x) {
            double entropy = 0.0;
            for (const int r : {0, 1}) {
                model->tables->likelihood(x, r, likelihood);
                std::map<double, double> threshold;
                double total = 0.0;
                for (std::size_t c = 0; c < run.posterior().cells(); ++c) {
                    const double p = likelihood[c] * run.posterior().probability()[c];
                    threshold[run.posterior().value(0, c)] += p;
                    total += p;
                }
                for (const auto& [t, p] : threshold)
                    entropy -= p > 0.0 ? p * std::log(p / total) : 0.0;
            }
            expected.push_back(entropy);
        }
        const auto least = std::min_element(expected.begin(), expected.end());
        QVERIFY(expected[static_cast<std::size_t>(choice.candidate)] <= *least + 2e-9);
        QVERIFY(std::abs(run.expectedEntropy() - *least) < 1e-9);
        QVERIFY(run.record(outcome(run, random), choice.stimulus));
    }
}

/// The same grid shifted by an exact constant: the same choices.
void TestQuestPlus::offsetChangesNothing() {
    QuestPlusSpec shifted = weibull();
    for (double& x : shifted.stimuli[0].second)
        x += 1024.0;
    for (double& t : shifted.parameters[0].values)
        t += 1024.0;
    auto here = *makeProcedure(weibull(), 1);
    auto there = *makeProcedure(shifted, 1);
    core::Random random(4);
    for (int trial = 0; trial < 30; ++trial) {
        const Choice a = here->next();
        const Choice b = there->next();
        QVERIFY(a.candidate == b.candidate || a.entropyMargin < 1e-9);
        const int given = outcome(*here, random);
        QVERIFY(here->record(given, a.stimulus) && there->record(given, {a.stimulus[0] + 1024.0}));
    }
    QVERIFY(std::abs(here->estimate().parameters[0].mean + 1024.0 - there->estimate().parameters[0].mean) <
            1e-6);
}

/// Presented as a table of candidates with four digits has it, always right: nothing more than repeat_limit
/// times in a row.
void TestQuestPlus::capHoldsForRoundedStimuli() {
    QuestPlusSpec spec;
    spec.function = "weibull_log10";
    spec.stimuli = {{"intensity", {}}};
    for (int i = 0; i <= 38; ++i)
        spec.stimuli[0].second.push_back(-2.2 + 0.05 * i);
    spec.parameters = {{"threshold", spec.stimuli[0].second, {}, false},
                       {"slope", {0.9, 1.3, 1.8, 2.6}, {}, false},
                       {"lower_asymptote", {0.5}, {}, false},
                       {"lapse_rate", {0.0, 0.02, 0.05}, {}, true}};
    spec.stop = {.trials = 120};
    for (const int limit : {0, 4}) {
        spec.repeatLimit = limit;
        const auto model = questPlusModel(spec);
        QVERIFY(model);
        QuestPlus run(*model, 1);
        double last = 0.0;
        int inARow = 0, most = 0;
        while (!run.done()) {
            const double wanted = std::pow(10.0, run.next().stimulus[0]);
            const double presented = std::log10(QString::number(wanted, 'g', 4).toDouble());
            QVERIFY(run.record(1, {presented}));
            inARow = presented == last ? inARow + 1 : 1;
            last = presented;
            most = std::max(most, inARow);
        }
        QVERIFY2(limit == 0 ? most > 4 : most == 4, qPrintable(QString::number(most)));
    }
}

/// Two rows of the same value with different probabilities: a trial taken back leaves what the chosen row
/// said of the others.
void TestQuestPlus::undoTakesTheRowThatWasChosen() {
    QuestPlusSpec spec;
    spec.function = "table";
    spec.outcomes = 2;
    spec.stimuli = {{"intensity", {1.0, 1.0, 2.0}}};
    spec.parameters = {{"level", {1.0, 2.0}, {}, false}};
    // [outcome][stimulus][cell]: the first row says nothing, the second much
    spec.table = {{{0.5, 0.5}, {0.9, 0.2}, {0.6, 0.4}}, {{0.5, 0.5}, {0.1, 0.8}, {0.4, 0.6}}};
    spec.stop = {.trials = 10};
    const auto model = questPlusModel(spec);
    QVERIFY2(model, model ? "" : model.error().message.c_str());
    QuestPlus run(*model, 1), without(*model, 1);
    for (const int given : {1, 1, 0}) {
        const Choice choice = run.next();
        QCOMPARE(choice.candidate, 1);
        QVERIFY(run.record(given, choice.stimulus));
    }
    QVERIFY(run.undo());
    for (const int given : {1, 1})
        QVERIFY(without.record(given, without.next().stimulus));
    QVERIFY(run.posterior().probability() == without.posterior().probability());
    QVERIFY(run.posterior().probability()[1] > 0.9);
}

/// The dimensions of csf in any order choose the same stimuli; one that it does not have is refused.
void TestQuestPlus::dimensionsGoByName() {
    const std::pair<std::string, std::vector<double>> contrast{"contrast", {-50, -40, -30, -20, -10, 0}},
        spatial{"spatial_freq", {0, 8, 16, 24, 32, 40}}, temporal{"temporal_freq", {0}};
    QuestPlusSpec spec;
    spec.function = "csf";
    spec.parameters = {{"min_thresh", {-50, -40, -30}, {}, false},
                       {"c0", {-60, -50, -40}, {}, false},
                       {"cf", {0.8, 1.2, 1.6}, {}, false},
                       {"cw", {0}, {}, false},
                       {"slope", {3}, {}, false},
                       {"lower_asymptote", {0.5}, {}, false},
                       {"lapse_rate", {0.01}, {}, false}};
    spec.stop = {.trials = 20};
    spec.stimuli = {contrast, spatial, temporal};
    auto named = makeProcedure(spec, 1);
    spec.stimuli = {spatial, temporal, contrast};
    auto turned = makeProcedure(spec, 1);
    QVERIFY(named && turned);
    for (int trial = 0; trial < 12; ++trial) {
        const Stimulus a = (*named)->next().stimulus, b = (*turned)->next().stimulus;
        QVERIFY((a == Stimulus{b[2], b[0], b[1]}));
        QVERIFY((*named)->record(trial % 3 == 0 ? 0 : 1, a) && (*turned)->record(trial % 3 == 0 ? 0 : 1, b));
    }
    spec.stimuli[0].first = "frequency";
    const auto refused = makeProcedure(spec, 1);
    QVERIFY(!refused && refused.error().message.find("spatial_freq is missing") != std::string::npos);
}

/// The check of a ranking makes no tables: at the ends of all ranges, and just outside of them, it says what
/// the making of the model says.
void TestQuestPlus::rankingThatIsCheckedCanBeMade() {
    int made = 0;
    int refused = 0;
    for (const bool ties : {false, true})
        for (const double difference : {0.0, 1e-9, 20.0})
            for (const double sigma : {-20.0, -19.9, 0.0, 19.9})
                for (const double lapse : {-0.01, 0.0, 0.999, 1.0})
                    for (const double tie : {1e-3, 20.0, 20.1}) {
                        Rank3Spec spec;
                        spec.allowTies = ties;
                        spec.differences = {difference, 0.01};
                        spec.log10Sigma = {sigma, -1.0};
                        spec.lapse = {lapse};
                        spec.tieThresholds = {tie, 1.0};
                        const auto good = checkRank3(spec);
                        const auto model = rank3Model(spec);
                        QCOMPARE(good.has_value(), model.has_value());
                        if (!good)
                            QCOMPARE(good.error().message, model.error().message);
                        ++(good ? made : refused);
                    }
    QCOMPARE(made, 2 * 3 * 2 * 3 + 2 * 3 * 2 * 2); // without ties their thresholds do not matter
    QCOMPARE(refused, 2 * 3 * 4 * 4 * 3 - made);
}

QTEST_APPLESS_MAIN(TestQuestPlus)
#include "test_quest_plus.moc"
