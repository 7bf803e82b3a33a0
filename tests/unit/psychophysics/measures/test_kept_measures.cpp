// SPDX-License-Identifier: GPL-3.0-or-later
// What answers of many kinds say, from single tails to groups and studies of the apex, figure by figure
// against what was kept: published cases and laws show that measures are right, this that none of them
// changes unsaid, with data that carry little, too.
#include "support/kept_figures.h"
#include "tests/unit/psychophysics/measures/thurstone_runs.h"

#include "core/random.h"
#include "psychophysics/measures/adjustment_summary.h"
#include "psychophysics/measures/dense_solve.h"
#include "psychophysics/measures/dprime.h"
#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/magnitude_estimation.h"
#include "psychophysics/measures/page_trend.h"
#include "psychophysics/measures/pairwise_ranking.h"
#include "psychophysics/measures/questionnaire_measures.h"
#include "psychophysics/measures/random_effects.h"
#include "psychophysics/measures/ranking_summary.h"
#include "psychophysics/measures/run_curve.h"
#include "psychophysics/measures/scored_answers.h"
#include "psychophysics/measures/thurstone_posterior.h"
#include "psychophysics/measures/variance_components.h"
#include "psychophysics/study/apex_study.h"
#include "psychophysics/study/group_estimate.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <tuple>

using namespace chiron;
using namespace psychophysics;
using tests::Figures;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const QString kFile = QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/psychophysics/data/kept_measures.txt");

const std::vector<DiscriminationTask> kRules{{Discrimination::mAfc, 2},
                                             {Discrimination::mAfc, 3},
                                             {Discrimination::mAfc, 7},
                                             {Discrimination::oddityDifferencing, 3},
                                             {Discrimination::oddityIndependent, 3},
                                             {Discrimination::sameDifferentIndependent, 2},
                                             {Discrimination::abxDifferencing, 2},
                                             {Discrimination::abxIndependent, 2},
                                             {Discrimination::tetrad, 4}};

void warn(Figures& out, const std::vector<Warning>& warnings) {
    for (const Warning& warning : warnings)
        out.say(QStringLiteral("warns"), warningText(warning));
}

void tell(Figures& out, const RunEstimate& of) {
    out.add(QStringLiteral("run"), of.weber, of.weber95.low, of.weber95.high, of.jnd, of.sigma_log10,
            of.sigma95.low, of.sigma95.high, of.priorInfluence);
    out.add(QStringLiteral("also"), of.pse, of.pse95.low, of.pse95.high, of.criterion, of.lapse, of.tie,
            of.tie95.low, of.tie95.high, of.exponent, of.exponent95.low, of.exponent95.high);
    out.add(QStringLiteral("curve"), of.threshold, of.threshold95.low, of.threshold95.high, of.fitThreshold,
            of.fitThreshold95.low, of.fitThreshold95.high, of.deviance, of.pValue, of.trials);
    for (const CurvePoint& point : of.points)
        out.add(QStringLiteral("point"), point.difference, point.right, point.of);
    for (std::size_t i = 0; i < of.curveDifference.size(); i += 17)
        out.add(QStringLiteral("at"), of.curveDifference[i], of.curveProportion[i],
                of.curveLow.size() > i ? of.curveLow[i] : kNaN,
                of.curveHigh.size() > i ? of.curveHigh[i] : kNaN);
    out.say(QStringLiteral("by"), std::string(methodText(of.method)) + ", " + of.unit);
    warn(out, of.warnings);
}

void tell(Figures& out, const WorthEstimate& of) {
    out.add(QStringLiteral("worth"), of.fitted, of.logLikelihood);
    out.each(QStringLiteral("ln"), of.logWorth);
    out.each(QStringLiteral("error"), of.standardError);
    out.say(QStringLiteral("warns"), of.warnings);
}

void tell(Figures& out, const RankCorrelation& of) {
    out.add(QStringLiteral("tau"), of.tau, of.pValue, of.exact, of.pairs);
    out.say(QStringLiteral("warns"), of.warnings);
}

void tell(Figures& out, const Concordance& of) {
    out.add(QStringLiteral("W"), of.w, of.chiSquare, of.pValue, of.exactP, of.judges, of.objects);
    out.say(QStringLiteral("warns"), of.warnings);
}

void tell(Figures& out, const PageTrend& of) {
    out.add(QStringLiteral("L"), of.l, of.expected, of.z, of.exactP, of.normalP, of.pValue, of.judges,
            of.objects);
    out.say(QStringLiteral("warns"), of.warnings);
}

void tell(Figures& out, const DPrimeEstimate& of) {
    out.add(QStringLiteral("d'"), of.proportion, of.dPrime, of.standardError, of.low, of.high, of.pValue,
            of.scoreChiSquare, of.scoreP);
    out.say(QStringLiteral("warns"), of.warnings);
}

void tell(Figures& out, const RankingSummary& of) {
    out.add(QStringLiteral("rankings"), of.rankings, of.tied, of.judges, of.complete.right, of.complete.of,
            of.complete.share, of.complete.low, of.complete.high, of.complete.pValue, of.adaptive);
    out.add(QStringLiteral("intervals"), of.wLow, of.wHigh, of.tau, of.tauLow, of.tauHigh, of.davidsonTie);
    tell(out, of.agreement);
    tell(out, of.trend);
    tell(out, of.bradleyTerry);
    tell(out, of.plackettLuce);
    tell(out, of.thurstone);
}

/// A run at the given differences by an observer of that σ.
std::vector<ScoredTrial> answered(Task task, const std::vector<double>& differences, int each, double sigma,
                                  double lapse, std::uint64_t seed) {
    core::Random random(seed);
    std::vector<ScoredTrial> trials;
    for (int i = 0; i < each; ++i)
        for (const double difference : differences)
            trials.push_back(thurstone_runs::simulated(task, difference, sigma, lapse, random));
    return trials;
}

RunEstimate runOf(Task task, double sigma, std::uint64_t seed, int each = 12) {
    const Condition condition = thurstone_runs::conditionOf(task);
    return estimateRun(condition, answered(task, condition.stimulus.differences, each, sigma, 0.02, seed), 1);
}

} // namespace

class TestKeptMeasures : public QObject {
    Q_OBJECT
private slots:
    void tails();
    void discrimination();
    void counts();
    void agreement();
    void trends();
    void worths();
    void rankings();
    void solving();
    void subjects();
    void settingsAndNumbers();
    void questionnaires();
    void sortedAnswers();
    void observers();
    void runs();
    void groups();
    void apex();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const char* name, const Figures& figures) {
        const QString differs = m_kept.differs(QLatin1String(name), figures.lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_kept{kFile, tests::sameFigures};
};

void TestKeptMeasures::tails() {
    Figures out;
    for (const auto& [k, n] : std::vector<std::pair<int, int>>{
             {0, 0}, {0, 5}, {5, 5}, {3, 5}, {-1, 5}, {6, 5}, {38, 50}, {0, 400}, {211, 400}, {7, -1}}) {
        for (const double p : {-0.1, 0.0, 0.2, 0.5, 1.0, 1.1})
            out.add(QStringLiteral("binomial %1 of %2").arg(k).arg(n), p, binomialUpperTail(k, n, p),
                    binomialLowerTail(k, n, p));
        for (const double level : {0.5, 0.95, 0.99}) {
            const ProportionInterval exact = exactInterval(k, n, level), score = wilsonInterval(k, n, level),
                                     corrected = wilsonInterval(k, n, level, true);
            out.add(QStringLiteral("interval"), level, exact.low, exact.high, score.low, score.high,
                    corrected.low, corrected.high);
        }
    }
    for (const auto& [n, k] :
         std::vector<std::pair<double, double>>{{0, 0}, {5, 0}, {5, 2}, {5, 5}, {1000, 321}})
        out.add(QStringLiteral("choose"), n, k, logChoose(n, k));
    for (const double a : {0.3, 1.0, 2.5, 30.0})
        for (const double x : {-0.1, 0.0, 0.1, 0.5, 0.9, 1.0, 1.1, 3.0, 12.0, 60.0})
            out.add(QStringLiteral("beta, gamma"), a, x, betaRegularised(x, a, 0.7),
                    betaRegularised(x, a, 6.0), gammaUpperRegularised(a, x));
    for (const double degrees : {0.5, 1.0, 2.0, 3.0, 9.0, 80.0, HUGE_VAL}) {
        for (const double t : {-HUGE_VAL, -3.0, -0.5, 0.0, 1.0, 2.3, 20.0})
            out.add(QStringLiteral("t"), degrees, t, studentUpperTail(t, degrees));
        for (const double p : {0.0, 0.001, 0.025, 0.4, 0.5, 0.9, 0.975, 1.0})
            out.add(QStringLiteral("t at"), degrees, p, studentQuantile(p, degrees));
    }
    for (const double degrees : {1.0, 2.0, 7.0, 90.0})
        for (const double p : {0.0, 0.01, 0.3, 0.5, 0.975, 0.999})
            out.add(QStringLiteral("chi-square"), degrees, p, chiSquareQuantile(p, degrees),
                    chiSquareUpperTail(10.0 * p * degrees, degrees));
    for (const double share : {-0.1, 0.0, 0.1, 0.5, 0.77, 1.0, 1.1})
        out.add(QStringLiteral("quantile"), share, quantileOf({1.0, 2.0, 4.0, 8.0}, share),
                quantileOf({3.0}, share), quantileOf({}, share));
    hold("tails", out);
}

void TestKeptMeasures::discrimination() {
    Figures out;
    for (const DiscriminationTask& task : kRules) {
        out.add(QStringLiteral("task"), static_cast<int>(task.rule), task.alternatives, chanceOf(task));
        for (const double d : {-2.0, -0.4, 0.0, 0.2, 1.0, 1.7, 2.6, 4.0, 9.0, 40.0, kNaN})
            out.add(QStringLiteral("at"), d, proportionCorrect(task, d), slopeOf(task, d));
        for (const double p : {-0.1, 0.0, 0.1, 0.2, 0.34, 0.5, 0.51, 0.8, 0.999, 1.0, 1.1, kNaN})
            out.add(QStringLiteral("d' at"), p, dPrimeAt(task, p));
        for (const double d : {0.0, 0.8, 1.6}) {
            for (const int trials : {0, 1, 20, 90})
                out.add(QStringLiteral("power"), d, trials, discriminationPower(task, d, trials),
                        discriminationPower(task, d, trials, 0.01));
            out.add(QStringLiteral("trials"), d, d > 0.0 ? trialsForPower(task, d, 0.8) : 0,
                    d > 0.0 ? trialsForPower(task, d, 0.9, 0.01) : 0);
        }
        for (const double hit : {0.0, 0.3, 0.8, 1.0})
            for (const double falseAlarm : {0.1, 0.5, 0.9})
                out.add(QStringLiteral("rates"), hit, falseAlarm, dPrimeOfRates(task, hit, falseAlarm));
    }
    for (const double d : {-13.0, -3.3, -0.01, 0.0, 0.4, 1.234, 5.0, 11.99, 12.5}) {
        const auto p = tabulatedOrderProbabilities(d);
        out.each(QStringLiteral("orders at %1").arg(d), std::vector<double>(p.begin(), p.end()));
    }
    for (const double d : {0.0, 0.7, 2.0})
        for (const double k : {0.0, 1.0, 2.5})
            out.add(QStringLiteral("same-different"), d, k, sameDifferentRates(d, k).hit,
                    sameDifferentRates(d, k).falseAlarm);
    for (const double hit : {0.0, 0.2, 0.6, 0.9, 1.0})
        for (const double falseAlarm : {0.0, 0.1, 0.2, 0.7, 1.0})
            out.add(QStringLiteral("same-different d'"), hit, falseAlarm,
                    sameDifferentDPrime(hit, falseAlarm));
    hold("discrimination", out);
}

void TestKeptMeasures::counts() {
    Figures out;
    for (const DiscriminationTask& task : kRules)
        for (const auto& [k, n] : std::vector<std::pair<int, int>>{{0, 0},
                                                                   {0, 8},
                                                                   {8, 8},
                                                                   {5, 8},
                                                                   {9, 8},
                                                                   {-1, 8},
                                                                   {9, 10},
                                                                   {38, 60},
                                                                   {200, 1000},
                                                                   {1000, 1000}})
            for (const ProportionLimits limits : {ProportionLimits::exact, ProportionLimits::score}) {
                out.add(QStringLiteral("counts"), static_cast<int>(task.rule), task.alternatives, k, n,
                        static_cast<int>(limits));
                tell(out, dPrimeOfCounts(task, k, n, limits));
                if (n == 60)
                    tell(out, dPrimeOfCounts(task, k, n, limits, 0.8));
            }
    for (const std::vector<int>& row : std::vector<std::vector<int>>{{30, 50, 5, 50},
                                                                     {0, 20, 0, 20},
                                                                     {20, 20, 20, 20},
                                                                     {20, 20, 0, 20},
                                                                     {3, 20, 9, 20},
                                                                     {10, 20, 10, 20},
                                                                     {1, 1, 0, 1},
                                                                     {5, 0, 5, 9},
                                                                     {5, 9, 5, 0},
                                                                     {7, 6, 1, 6},
                                                                     {-1, 6, 1, 6},
                                                                     {0, 20, 0, 4},
                                                                     {8, 9, 2, 12},
                                                                     {0, 20, 3, 20},
                                                                     {20, 20, 3, 20},
                                                                     {5, 20, 0, 20},
                                                                     {5, 20, 20, 20}})
        for (const core::RateCorrection correction :
             {core::RateCorrection::logLinear, core::RateCorrection::none})
            for (const double level : {0.95, 0.8}) {
                out.add(QStringLiteral("hits"), row[0], row[1], row[2], row[3], static_cast<int>(correction),
                        level);
                tell(out, sameDifferentOfCounts(row[0], row[1], row[2], row[3], level, correction));
                out.say(QStringLiteral("of rates"), warningsOfRates(row[0], row[1], row[2], row[3]));
            }
    hold("counts", out);
}

void TestKeptMeasures::agreement() {
    Figures out;
    using Rows = std::vector<std::vector<double>>;
    core::Random random(21);
    Rows many, wide, tied;
    for (int i = 0; i < 14; ++i) {
        std::vector<double> a, b, c;
        for (int k = 0; k < 4; ++k)
            a.push_back(k + 2.0 * random.normal());
        for (int k = 0; k < 9; ++k) {
            b.push_back(0.4 * k + 2.0 * random.normal());
            c.push_back(std::floor(0.4 * k + 1.5 * random.normal()));
        }
        many.push_back(a);
        wide.push_back(b);
        tied.push_back(c);
    }
    for (const Rows& rows :
         {Rows{}, Rows{{1, 2, 3}}, Rows{{1, 2, 3}, {1, 2, 3}}, Rows{{1, 2, 3}, {3, 2, 1}, {1, 3, 2}},
          Rows{{1, 1, 3}, {2, 2, 2}, {1, 2, 2}}, Rows{{5, 5, 5}, {2, 2, 2}}, Rows{{1}, {1}},
          Rows{{1, 2}, {1, 2}, {2, 1}, {1, 2}},
          Rows{{1, 2, 3, 4}, {1, kNaN, 3, 4}, {4, 3, 2}, {2, 1, 3, 4}, {1, 2, 4, HUGE_VAL}}, many, wide, tied,
          Rows(many.begin(), many.begin() + 5), Rows(many.begin(), many.begin() + 8)}) {
        tell(out, kendallW(rows));
        tell(out, pageTrend(rows));
    }
    out.each(QStringLiteral("ranks"), midRanks({3, 1, 3, 2, 7, 3, 7}));
    out.each(QStringLiteral("ranks"), midRanks({}));
    const std::vector<double> x{1, 2, 3, 4, 5, 6, 7}, y{2, 1, 4, 3, 6, 7, 5};
    tell(out, kendallTau(x, y));
    tell(out, kendallTau(x, {7, 6, 5, 4, 3, 2, 1}));
    tell(out, kendallTau(x, {1, 1, 2, 2, 3, 3, kNaN}));
    tell(out, kendallTau(x, {1, 1, 1, 1, 1, 1, 1}));
    tell(out, kendallTau({1, 2}, {2, 1}));
    tell(out, kendallTau({1}, {2}));
    tell(out, kendallTau({}, {}));
    tell(out, kendallTau({1, 2, 3}, {1, 2}));
    for (const std::size_t pairs : {8U, 9U, 30U, 100U, 101U, 250U}) {
        std::vector<double> a, b, rounded;
        for (std::size_t i = 0; i < pairs; ++i) {
            a.push_back(random.normal());
            b.push_back(0.4 * a.back() + random.normal());
            rounded.push_back(std::floor(2.0 * b.back()));
        }
        tell(out, kendallTau(a, b));
        tell(out, kendallTau(a, rounded));
        tell(out, kendallTau(rounded, b));
    }
    for (const auto& [right, of] :
         std::vector<std::pair<int, int>>{{0, 0}, {0, 12}, {12, 12}, {5, 12}, {40, 100}, {13, 12}}) {
        const CompleteOrders orders = completeOrders(right, of);
        out.add(QStringLiteral("orders"), orders.right, orders.of, orders.share, orders.low, orders.high,
                orders.pValue);
    }
    hold("agreement", out);
}

void TestKeptMeasures::trends() {
    Figures out;
    for (const int objects : {1, 2, 3, 5, 7, 8})
        for (const int judges : {1, 2, 6, 15})
            for (const double share : {0.0, 0.4, 0.6, 0.8, 1.0}) {
                const double least = objects * (objects + 1.0) * (objects + 2.0) / 6.0 * judges,
                             most = objects * (objects + 1.0) * (2.0 * objects + 1.0) / 6.0 * judges;
                out.add(QStringLiteral("tail"), objects, judges, share,
                        pageUpperTail(objects, judges, std::floor(least + share * (most - least))));
            }
    hold("trends", out);
}

void TestKeptMeasures::worths() {
    Figures out;
    core::Random random(31);
    std::vector<Selection> pairs, sets;
    std::vector<std::vector<int>> orders;
    for (int i = 0; i < 80; ++i) {
        std::vector<std::pair<double, int>> felt;
        for (int k = 0; k < 4; ++k)
            felt.emplace_back(0.5 * k + random.normal(), k);
        std::sort(felt.rbegin(), felt.rend());
        const std::vector<int> best{felt[0].second, felt[1].second, felt[2].second, felt[3].second};
        orders.push_back(i % 3 == 0 ? std::vector<int>{best[0], best[1], best[2]} : best);
        for (const Selection& one : selectionsOf(orders.back(), i % 5 == 0 ? 2.0 : 1.0))
            sets.push_back(one);
        pairs.push_back({best[0], {best[1 + static_cast<std::size_t>(i) % 3]}, 1.0});
        pairs.push_back({best[2], {best[3]}, 1.0});
    }
    const std::vector<Selection> chain{{2, {1}, 5.0}, {1, {0}, 4.0}},
        odd{{2, {1}, 5.0},    {1, {2}, 3.0}, {0, {1}, 2.0}, {1, {0}, 4.0},  {3, {0}, 1.0}, {0, {0}, 1.0},
            {0, {1, 1}, 1.0}, {0, {}, 1.0},  {0, {2}, 0.0}, {0, {2}, kNaN}, {-1, {2}, 1.0}};
    for (const auto& [objects, selections] :
         std::vector<std::pair<int, std::vector<Selection>>>{{4, pairs},
                                                             {4, sets},
                                                             {3, chain},
                                                             {3, odd},
                                                             {3, {}},
                                                             {0, {}},
                                                             {1, {}},
                                                             {2, {{0, {1}, 3.0}, {1, {0}, 1.0}}}}) {
        for (const double regularisation : {0.0, 0.5})
            tell(out, fitPlackettLuce(objects, selections, {regularisation, 20000}));
        tell(out, fitPlackettLuce(objects, selections, {0.0, 1}));
    }
    tell(out, fitThurstonePairs(4, pairs));
    tell(out, fitThurstonePairs(3, chain));
    tell(out, fitThurstonePairs(3, odd));
    tell(out, fitThurstoneOrders(4, orders));
    tell(out, fitThurstoneOrders(3, {{0, 1, 2}, {2, 1, 0}, {1, 0}}));
    tell(out, fitThurstoneOrders(3, {{0, 1, 2}, {0, 1, 2}}));
    const std::vector<std::vector<PairCount>> tied{{{0, 1, 8, 5, 4}, {1, 2, 9, 3, 2}, {0, 2, 7, 6, 5}},
                                                   {{0, 1, 8, 0, 0}, {1, 2, 5, 0, 0}},
                                                   {{0, 1, 0, 0, 4}, {1, 2, 0, 0, 3}},
                                                   {{0, 1, 8, 5, 0}, {1, 2, 9, 3, 0}},
                                                   {{0, 1, 3, 0, 1}, {1, 2, 3, 0, 1}, {2, 0, 1, 1, 0}},
                                                   {},
                                                   {{0, 1, -1, 2, 3},
                                                    {1, 1, 2, 2, 2},
                                                    {0, 5, 1, 1, 1},
                                                    {0, 2, 2, 1, 1},
                                                    {1, 2, 2, 3, 1},
                                                    {1, 0, kNaN, 1, 1}}};
    for (const TieModel model : {TieModel::davidson, TieModel::raoKupper})
        for (const std::vector<PairCount>& rows : tied) {
            const TiedWorthEstimate of = fitTiedPairs(model, 3, rows);
            tell(out, of);
            out.add(QStringLiteral("tie"), of.tie, of.tieStandardError);
        }
    hold("worths", out);
}

void TestKeptMeasures::rankings() {
    Figures out;
    std::vector<std::vector<SaidRanks>> people;
    for (const Task task : {Task::rank3, Task::rank3Ties})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            std::vector<ScoredTrial> trials =
                answered(task, {0.04, 0.08, 0.12}, 6, 0.05 + 0.02 * static_cast<double>(seed), 0.05, seed);
            trials[3].outcome = trials[3].answer = -1;
            trials[5].outcome = trials[5].answer = 13;
            const std::vector<SaidRanks> said = saidRanks(trials);
            tell(out, summariseRankings(said, seed == 2));
            people.push_back(said);
        }
    tell(out, summariseGroupRankings(people));
    tell(out, summariseGroupRankings({people[0], people[1], {}}));
    tell(out, summariseGroupRankings({people[0], people[5], people[6]}));
    tell(out, summariseGroupRankings({}));
    tell(out, summariseRankings({}));
    tell(out, summariseRankings({{1, 2, 3}}));
    tell(out, summariseRankings({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}));
    tell(out, summariseRankings({{2, 2, 2}, {2, 2, 2}}));
    tell(out, summariseRankings({{3, 2, 1}, {1.5, 1.5, 3}, {1, 2.5, 2.5}}));
    hold("rankings", out);
}

void TestKeptMeasures::solving() {
    Figures out;
    const auto rows = [&](const char* name, const Matrix& matrix) {
        out.add(QLatin1String(name), matrix.size());
        for (const auto& row : matrix)
            out.each(QStringLiteral("row"), row);
    };
    rows("inverse", inverseOf({{0, 2, 1}, {1, 0, 3}, {4, 1, 1}}));
    rows("singular", inverseOf({{1, 2}, {2, 4}}));
    rows("of none", inverseOf({}));
    const auto hill = [](const std::vector<double>& x) {
        return -std::pow(x[0] - 0.7, 2) - 0.5 * std::pow(x[1] + 0.3 * x[0], 2) -
               0.1 * std::pow(x[0] - 0.7, 4);
    };
    const auto ridge = [](const std::vector<double>& x) { return -std::log(std::cosh(x[0] + x[1] - 1.0)); };
    for (const auto& [name, f, start] : std::vector<
             std::tuple<const char*, std::function<double(const std::vector<double>&)>, std::vector<double>>>{
             {"hill", hill, {0, 0}},
             {"far hill", hill, {4, -3}},
             {"ridge", ridge, {0, 0}},
             {"rising", [](const std::vector<double>& x) { return x[0]; }, {0}}}) {
        const Maximum top = maximise(f, start);
        out.add(QLatin1String(name), top.found, std::round(1e4 * top.value) / 1e4);
        if (top.found)
            out.each(QStringLiteral("at"), top.at);
        rows("covariance", top.covariance);
    }
    hold("solving", out);
}

void TestKeptMeasures::subjects() {
    Figures out;
    const auto effects = [&](const std::vector<double>& y, const std::vector<double>& v) {
        const RandomEffects of = randomEffects(y, v);
        out.add(QStringLiteral("effects"), of.mean, of.standardError, of.low, of.high, of.predictionLow,
                of.predictionHigh, of.tau, of.q, of.qP, of.iSquared, of.pZero, of.subjects);
        out.each(QStringLiteral("weights"), of.weights);
    };
    effects({}, {});
    effects({0.3}, {0.01});
    effects({0.3, 0.5}, {0.01, 0.02});
    effects({0.3, 0.3, 0.3}, {0.01, 0.01, 0.02});
    effects({0.1, 0.5, -0.2, 0.3, 0.9}, {0.01, 0.02, 0.01, 0.04, 0.02});
    effects({0.1, 0.12, 0.08, 0.11, 0.1}, {0.04, 0.02, 0.01, 0.04, 0.02});
    effects({0.1, 0.5, -0.2, 0.3}, {0.0, 0.0, 0.0, 0.0});
    effects({-3, 4, 12, 5, -8, 1}, {0.5, 0.2, 3.0, 0.7, 0.1, 9.0});
    for (const int subjects : {1, 2, 3, 6, 12}) {
        std::vector<double> values;
        for (int i = 0; i < subjects; ++i)
            values.push_back(std::exp(0.4 * ((i * 7) % 5)) + 0.1 * i);
        const auto mean = [&](const std::vector<int>& drawn) {
            double sum = 0.0;
            for (const int i : drawn)
                sum += values[static_cast<std::size_t>(i)];
            return drawn.empty() ? 0.0 : sum / static_cast<double>(drawn.size());
        };
        const BootstrapInterval of = bootstrapSubjects(subjects, mean, 17, 300),
                                constant = bootstrapSubjects(
                                    subjects, [](const std::vector<int>&) { return 2.0; }, 17, 50);
        out.add(QStringLiteral("drawn"), subjects, of.low, of.high, of.percentileLow, of.percentileHigh,
                constant.low, constant.high, constant.percentileLow, constant.percentileHigh);
    }
    for (const std::vector<std::vector<double>>& groups : std::vector<std::vector<std::vector<double>>>{
             {},
             {{}},
             {{1}},
             {{1, 2, 4}},
             {{1, 2}, {5, 6.5, 7}, {3}},
             {{1, 4}, {2, 3}, {0, 5, 2.6}},
             {{1}, {3}, {4}},
             {{2, 2}, {2, 2}},
             {{}, {1, 1.5, 2, 2.5}, {4, 4.5}, {9, 9.1, 9.2, 8.7, 8}},
             {{2, 2}, {3, 3}}}) {
        const VarianceComponents of = varianceComponents(groups);
        out.add(QStringLiteral("components"), of.mean, of.within, of.between, of.cut);
    }
    hold("subjects", out);
}

void TestKeptMeasures::settingsAndNumbers() {
    Figures out;
    for (const double reference : {0.0, kNaN, 200.0})
        for (const std::vector<double>& settings :
             std::vector<std::vector<double>>{{},
                                              {210},
                                              {190, 230},
                                              {200, 200, 200},
                                              {205, 180, 240, 231, 199, 188, 0, -3, kNaN},
                                              {190, 200, 210, 220, 215, 205, 195, 185, 200, 230, 207}}) {
            const AdjustmentSummary of = summariseSettings(reference, settings);
            out.add(QStringLiteral("settings"), of.settings, of.pse, of.pseLow, of.pseHigh,
                    of.constantErrorLog10, of.sdLog10, of.sdLow, of.sdHigh, of.jndLog10);
            warn(out, of.warnings);
        }
    core::Random random(41);
    std::vector<MagnitudeAnswer> one, several;
    for (int subject = 0; subject < 5; ++subject)
        for (const double stimulus : {50.0, 100.0, 200.0, 400.0})
            for (int i = 0; i < 2; ++i)
                several.push_back({subject, stimulus,
                                   (3.0 + subject) * std::pow(stimulus, 0.6 + 0.05 * subject) *
                                       std::exp(0.2 * random.normal())});
    for (const MagnitudeAnswer& answer : several)
        if (answer.subject == 2)
            one.push_back(answer);
    std::vector<MagnitudeAnswer> spoiled = several;
    spoiled[0].number = 0.0;
    spoiled[1].stimulus = -1.0;
    spoiled[2].number = kNaN;
    spoiled.push_back({9, 100.0, 3.0});
    spoiled.push_back({8, 100.0, 3.0});
    spoiled.push_back({8, 100.0, 5.0});
    for (const std::vector<MagnitudeAnswer>& answers :
         {std::vector<MagnitudeAnswer>{},
          {{0, 100, 5}},
          {{0, 100, 5}, {0, 200, 9}},
          {{0, 100, 5}, {0, 100, 9}},
          one,
          several,
          spoiled,
          std::vector<MagnitudeAnswer>(several.begin(), several.begin() + 16)}) {
        const MagnitudeScale of = magnitudeScale(answers);
        out.add(QStringLiteral("scale"), of.exponent, of.exponentLow, of.exponentHigh, of.sdBetween,
                of.constant);
        for (const SubjectPower& subject : of.subjects)
            out.add(QStringLiteral("subject"), subject.subject, subject.exponent, subject.intercept,
                    subject.answers);
        for (const MagnitudeLevel& level : of.levels)
            out.add(QStringLiteral("level"), level.stimulus, level.geometricMean, level.sdLog10,
                    level.subjects);
        warn(out, of.warnings);
    }
    hold("settings and numbers", out);
}

void TestKeptMeasures::questionnaires() {
    Figures out;
    Questionnaire asked;
    using Kind = QuestionnaireItem::Kind;
    for (const auto& [id, kind, scale, construct] :
         std::vector<std::tuple<const char*, Kind, int, const char*>>{
             {"real", Kind::likert, 5, "face"},
             {"useful", Kind::likert, 5, "face"},
             {"teaches", Kind::likert, 4, "content"},
             {"liked", Kind::likert, 7, "content"},
             {"alone", Kind::likert, 5, ""},
             {"years", Kind::number, 5, ""},
             {"hand", Kind::choice, 5, ""},
             {"words", Kind::text, 5, ""},
             {"unanswered", Kind::likert, 5, "none"}}) {
        QuestionnaireItem item;
        item.id = id;
        item.kind = kind;
        item.scale = scale;
        item.construct = construct;
        if (kind == Kind::choice)
            item.choices = {StudyText{{"en", "left"}}, StudyText{{"en", "right"}}, StudyText{{"en", "both"}}};
        asked.items.push_back(item);
    }
    std::vector<QuestionnaireReply> replies;
    core::Random random(51);
    for (int i = 0; i < 9; ++i) {
        QuestionnaireReply reply;
        reply.performance = random.normal();
        const auto rated = [&](int scale) {
            return static_cast<double>(1 + random.below(static_cast<std::uint64_t>(scale)));
        };
        reply.numbers = {{"real", i < 7 ? 4.0 + i % 2 : rated(5)},
                         {"useful", 5.0},
                         {"teaches", rated(4)},
                         {"liked", rated(7)},
                         {"alone", rated(5)},
                         {"years", random.uniform(0.0, 20.0)},
                         {"hand", static_cast<double>(random.below(3))}};
        reply.texts = {{"words", i % 3 == 0 ? "" : "said " + std::to_string(i)}};
        replies.push_back(reply);
    }
    replies[1].numbers["real"] = 6.0;
    replies[2].numbers["real"] = 0.0;
    replies[3].numbers["real"] = 2.5;
    replies[4].numbers.erase("real");
    replies[5].numbers["hand"] = 3.0;
    replies[6].numbers["hand"] = -1.0;
    replies[7].numbers["years"] = kNaN;
    replies[8].performance = kNaN;
    for (const std::size_t count : {0U, 1U, 4U, 5U, 9U}) {
        const QuestionnaireSummary of = summariseQuestionnaire(
            asked, {replies.begin(), replies.begin() + static_cast<std::ptrdiff_t>(count)});
        out.add(QStringLiteral("replies"), of.replies);
        out.say(QStringLiteral("warns"), of.warnings);
        for (const LikertSummary& item : of.likert) {
            out.say(QStringLiteral("item"), item.item + ", " + item.construct);
            out.each(QStringLiteral("counts"), item.counts);
            out.add(QStringLiteral("rated"), item.scale, item.answered, item.missing, item.median,
                    item.lowerQuartile, item.upperQuartile, item.agreement, item.agreementLow,
                    item.agreementHigh, item.contentValidityIndex, item.contentValidityKappa);
            tell(out, item.withPerformance);
            out.say(QStringLiteral("warns"), item.warnings);
        }
        for (const ConstructSummary& construct : of.constructs) {
            out.say(QStringLiteral("construct"), construct.construct);
            out.add(QStringLiteral("rated"), construct.items, construct.answers, construct.median,
                    construct.agreement, construct.agreementLow, construct.agreementHigh,
                    construct.contentValidityAverage, construct.contentValidityUniversal);
        }
        for (const NumberSummary& item : of.numbers) {
            out.say(QStringLiteral("number"), item.item);
            out.add(QStringLiteral("given"), item.answered, item.mean, item.sd, item.median);
            out.each(QStringLiteral("choices"), item.choiceCounts);
            tell(out, item.withPerformance);
        }
        for (const TextAnswers& item : of.texts)
            out.say(QString::fromStdString(item.item), item.answers);
    }
    hold("questionnaires", out);
}

void TestKeptMeasures::sortedAnswers() {
    Figures out;
    for (int task = 0; task < kTasks; ++task) {
        const auto which = static_cast<Task>(task);
        std::vector<ScoredTrial> trials = answered(which, {-0.08, 0.0, 0.04, 0.08}, 5, 0.05, 0.1, 61);
        trials[0].difference = kNaN;
        trials[1].answer = 99;
        trials[2].answer = -1;
        trials[3].answer = trials[3].outcome = -1;
        trials[4].arrangement = 40;
        trials[5].answer = -1;
        trials[5].outcome = 1;
        const ScoredAnswers of = sortAnswers(which, trials);
        out.add(QStringLiteral("task"), task, of.used, of.right, of.leftOut, of.binned, of.smallestDifference,
                of.largestDifference, of.levels, kindOfCurve(which));
        for (const AnswerCount& count : of.counts)
            out.add(QStringLiteral("count"), count.difference, count.kind, count.count);
        for (const CurvePoint& point : of.points)
            out.add(QStringLiteral("point"), point.difference, point.right, point.of);
    }
    core::Random random(62);
    std::vector<ScoredTrial> many;
    for (int i = 0; i < 600; ++i)
        many.push_back(
            thurstone_runs::simulated(Task::twoAfc, random.uniform(0.001, 0.3), 0.08, 0.02, random));
    const ScoredAnswers of = sortAnswers(Task::twoAfc, many);
    out.add(QStringLiteral("many"), of.used, of.right, of.leftOut, of.binned, of.smallestDifference,
            of.largestDifference, of.levels, of.counts.size(), of.points.size());
    for (std::size_t i = 0; i < of.counts.size(); i += 29)
        out.add(QStringLiteral("count"), of.counts[i].difference, of.counts[i].kind, of.counts[i].count);
    hold("sorted answers", out);
}

void TestKeptMeasures::observers() {
    Figures out;
    for (int task = 0; task < kTasks; ++task) {
        const auto which = static_cast<Task>(task);
        const bool rates = which == Task::sameDifferent || which == Task::yesNo;
        const int kinds = rates ? 4 : ranksThree(which) ? outcomes(which) : 2;
        for (const double difference : {-0.1, 0.0, 0.03, 0.2})
            for (const ThurstonePoint& at : {ThurstonePoint{-1.2, 0.0, 0.4}, ThurstonePoint{-0.8, 0.1, 0.0},
                                             ThurstonePoint{-2.5, 0.02, 1.1}}) {
                std::vector<double> shares;
                for (int kind = 0; kind < kinds && which != Task::adjustment && which != Task::magnitude;
                     ++kind)
                    shares.push_back(answerProbability(which, difference, kind, at));
                out.each(QStringLiteral("task %1 at %2").arg(task).arg(difference), shares);
            }
        ThurstonePrior prior;
        out.add(QStringLiteral("prior"), task, priorLog10SigmaSd(which, prior));
        prior.evenUpTo = -1.0;
        prior.highCriterion = 3.0;
        out.add(QStringLiteral("prior, even so far"), task, priorLog10SigmaSd(which, prior));
        if (which == Task::yesNo) {
            prior.lowCriterion = -0.5;
            prior.highCriterion = 0.5;
        }
        const ScoredAnswers answers =
            sortAnswers(which, answered(which, {0.02, 0.06, 0.12}, 14, 0.06, 0.02, 71));
        const ThurstonePosterior of = thurstonePosterior(which, answers.counts, prior, 30);
        out.add(QStringLiteral("posterior"), of.known, of.medianLog10Sigma, of.meanLog10Sigma,
                of.sdLog10Sigma, of.lowLog10Sigma, of.highLog10Sigma, of.meanLapse, of.criterion,
                of.lowCriterion, of.highCriterion, of.densityAtLowSigma, of.densityAtHighSigma,
                of.draws.size());
        for (std::size_t i = 0; i < of.draws.size(); i += 7)
            out.add(QStringLiteral("draw"), of.draws[i].log10Sigma, of.draws[i].lapse, of.draws[i].criterion);
    }
    hold("observers", out);
}

void TestKeptMeasures::runs() {
    Figures out;
    for (int task = 0; task < kTasks; ++task) {
        const auto which = static_cast<Task>(task);
        Condition condition = thurstone_runs::conditionOf(which);
        const auto of = [&](const char* name, std::vector<ScoredTrial> trials) {
            out.say(QStringLiteral("-- %1").arg(QLatin1String(name)), std::string(token(which)));
            core::Random random(9);
            for (ScoredTrial& trial : trials)
                trial.value = which == Task::adjustment ? 205.0 * std::exp(0.1 * random.normal())
                              : which == Task::magnitude
                                  ? 10.0 * std::pow(10.0, 0.8 * trial.difference + 0.05 * random.normal())
                                  : trial.value;
            tell(out, estimateRun(condition, trials, 1));
        };
        of("usual", answered(which, condition.stimulus.differences, 10, 0.07, 0.02, 81));
        of("few", answered(which, {0.05, 0.1, 0.2}, 3, 0.07, 0.0, 82));
        of("none", {});
        if (which == Task::rank3Ties)
            continue; // each takes half a second
        of("lapses", answered(which, condition.stimulus.differences, 10, 0.04, 0.35, 83));
        of("chance", answered(which, {0.02, 0.04}, 30, 5.0, 0.0, 84));
        of("easy", answered(which, {0.3, 0.5}, 15, 0.02, 0.0, 85));
        of("one level", answered(which, {0.1}, 40, 0.1, 0.02, 86));
        of("no difference", answered(which, {0.0}, 20, 0.1, 0.02, 87));
        condition.criterion = 0.6;
        of("another criterion", answered(which, {-0.1, -0.05, 0.05, 0.1, 0.2}, 14, 0.08, 0.02, 88));
        std::vector<ScoredTrial> sided = answered(which, {0.03, 0.06, 0.12}, 25, 0.08, 0.0, 89);
        for (ScoredTrial& trial : sided)
            if (trial.outcome == 0 && answers(which) > 1)
                trial.answer = correctAnswer(which, trial.arrangement) == 0 ? 1 : 0;
        of("one side", sided);
        std::vector<ScoredTrial> worse = answered(which, {0.03, 0.06, 0.12}, 25, 0.08, 0.0, 90);
        for (ScoredTrial& trial : worse)
            trial.difference = 0.15 - trial.difference;
        of("worse where easier", worse);
    }
    Condition other = thurstone_runs::conditionOf(Task::twoAfc);
    other.stimulus.reference = 0.0;
    tell(out, estimateRun(other, {}, 1));
    other.stimulus.attribute = Attribute::apex;
    other.stimulus.reference = 0.02;
    tell(out, estimateRun(other, answered(Task::twoAfc, {0.1}, 3, 0.1, 0.0, 91), 1));
    hold("runs", out);
}

void TestKeptMeasures::groups() {
    Figures out;
    std::vector<RunEstimate> first, second;
    for (std::uint64_t i = 0; i < 7; ++i) {
        first.push_back(runOf(Task::twoAfc, 0.05 + 0.01 * static_cast<double>(i % 4), 100 + i));
        second.push_back(runOf(Task::twoAfc, 0.07 + 0.02 * static_cast<double>(i % 3), 200 + i, 8));
        first.back().exponent = 0.6 + 0.03 * static_cast<double>(i);
    }
    second[2].weber = kNaN;
    second[4].warnings.push_back({WarningKind::priorEdgeHigh});
    RunEstimate shut;
    shut.warnings.push_back({WarningKind::sealed});
    std::vector<RunEstimate> yes;
    for (std::uint64_t i = 0; i < 3; ++i)
        yes.push_back(runOf(Task::yesNo, 0.06, 300 + i));
    const auto group = [&](const std::vector<RunEstimate>& runs) {
        const GroupEstimate of = estimateGroup(runs, 5);
        out.add(QStringLiteral("group"), of.weber, of.weber95.low, of.weber95.high, of.bootstrap95.low,
                of.bootstrap95.high, of.prediction95.low, of.prediction95.high, of.jnd, of.sigma_log10);
        out.add(QStringLiteral("between"), of.sdBetweenLog10, of.iSquared, of.heterogeneityP, of.pse,
                of.pse95.low, of.pse95.high, of.exponent, of.exponent95.low, of.exponent95.high,
                of.participants, of.leftOut);
        for (const GroupMember& member : of.members)
            out.add(QStringLiteral("member"), member.index, member.weber, member.errorLog10, member.weight);
        out.say(QStringLiteral("by"), of.method + ", " + of.unit);
        warn(out, of.warnings);
    };
    group({});
    group({first[0]});
    group({first[0], first[1]});
    group({first[0], first[1], first[2], shut, second[2]});
    group({shut, shut});
    group(first);
    group(second);
    group(yes);
    const auto comparison = [&](const ConditionComparison& of) {
        out.add(QStringLiteral("compared"), of.ratio, of.ratio95.low, of.ratio95.high, of.bootstrap95.low,
                of.bootstrap95.high, of.pValue, of.pHolm, of.sdBetweenLog10, of.paired, of.participants,
                of.first, of.second);
        warn(out, of.warnings);
    };
    ConditionComparison a = compareConditions(first, second, 6), b = compareGroups(first, second),
                        c = compareConditions({first[0], first[1], first[2]}, {first[3], first[4]}, 6),
                        d = compareConditions({}, {}, 6);
    adjustHolm({&a, &b, &c, &d});
    for (const ConditionComparison& each :
         {a, b, c, d, compareGroups({first[0]}, second), compareGroups({}, second),
          compareGroups({first[0], first[1]}, {second[0], second[1], shut}),
          compareConditions({first[0]}, {second[0]}, 6)})
        comparison(each);
    const auto models = [&](Task x, const std::vector<RunEstimate>& runsX, Task y,
                            const std::vector<RunEstimate>& runsY) {
        const ThresholdModels of = compareThresholdModels(x, runsX, y, runsY);
        out.add(QStringLiteral("models"), of.likelihoodRatio, of.freedom, of.pValue, of.aicDifference,
                of.participants);
    };
    models(Task::twoAfc, first, Task::twoAfc, second);
    models(Task::twoAfc, first, Task::threeAfc, second);
    models(Task::yesNo, yes, Task::yesNo, {yes[1], yes[2]});
    models(Task::adjustment, first, Task::adjustment, second);
    models(Task::magnitude, first, Task::magnitude, second);
    models(Task::twoAfc, {}, Task::twoAfc, second);
    hold("groups", out);
}

void TestKeptMeasures::apex() {
    Figures out;
    const auto summary = [&](const std::vector<ApexTrial>& trials, double radius_m) {
        const ApexSummary of = summariseApex(trials, radius_m, 3);
        out.add(QStringLiteral("apex"), of.participants, of.trials, of.leftOut, of.meanAbsolutePercent,
                of.sdAbsolutePercent, of.meanAbsolute95.low, of.meanAbsolute95.high,
                of.meanAbsoluteBootstrap95.low, of.meanAbsoluteBootstrap95.high, of.meanAbsolute_mm,
                of.sdOverMean, of.meanDistance_mm, of.impliedSdPercent, of.impliedSd_mm);
        for (const ApexAxis& axis : of.axes)
            out.add(QStringLiteral("axis"), axis.bias_mm, axis.bias95_mm.low, axis.bias95_mm.high,
                    axis.biasPercent, axis.sd_mm, axis.sdWithin_mm, axis.sdBetween_mm, axis.sdPercent);
        for (const ApexBar& bar : of.bars)
            out.add(QStringLiteral("bar"), bar.participant, bar.trials, bar.meanPercent, bar.sdPercent,
                    bar.biasXPercent, bar.biasYPercent);
        for (std::size_t i = 0; i < of.points.size(); i += 11)
            out.add(QStringLiteral("point"), of.points[i].participant, of.points[i].xPercent,
                    of.points[i].yPercent);
        warn(out, of.warnings);
    };
    const std::vector<ApexTrial> five = simulateApex({17.8, 6.0}, 5, 10, 0.02, 9);
    std::vector<ApexTrial> leaning = five, spoiled = five;
    for (ApexTrial& trial : leaning)
        trial.errorX_m += 0.006;
    spoiled[0].errorX_m = kNaN;
    spoiled[1].errorY_m = HUGE_VAL;
    spoiled[2].errorX_m = 0.05;
    summary(five, 0.02);
    summary(leaning, 0.02);
    summary(spoiled, 0.015);
    summary({five.begin(), five.begin() + 1}, 0.02);
    summary({five.begin(), five.begin() + 7}, 0.02);
    summary({five.begin(), five.begin() + 13}, 0.02);
    summary({}, 0.02);
    summary(five, 0.0);
    summary(simulateApex({}, 2, 3, 0.01, 4), 0.01);
    for (const auto& [people, trials, other] : std::vector<std::tuple<int, int, double>>{
             {5, 10, 29.7}, {3, 4, 14.0}, {1, 5, 20.0}, {0, 0, 20.0}, {2, 2, 14.2}}) {
        const ApexPlan plan = planApex({17.8, 4.0}, people, trials, other, 25, 7);
        out.add(QStringLiteral("plan"), plan.meanAbsolutePercent, plan.halfWidthPercent, plan.power,
                plan.meanError, plan.halfWidthError, plan.powerError);
    }
    hold("apex", out);
}

QTEST_APPLESS_MAIN(TestKeptMeasures)
#include "test_kept_measures.moc"
