// SPDX-License-Identifier: GPL-3.0-or-later
// The apex study: P2's numbers, known populations, and data that carry nothing.
#include "core/random.h"
#include "psychophysics/measures/variance_components.h"
#include "psychophysics/study/apex_study.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron::psychophysics;

class TestApexStudy : public QObject {
    Q_OBJECT
private slots:
    void planningObserver();
    void knownPopulation();
    void biasIsFound();
    void byHand();
    void varianceComponentsOfDyestuff();
    void varianceComponentsMaximiseTheRestrictedLikelihood();
    void power();
    void degenerate();
};

/// psychophysics.md: sd over mean of |e| is 0.756; 14.2 % R means σ = 17.8 % R = 3.6 mm an axis, the earlier
/// device's 29.7 % 7.4 mm.
void TestApexStudy::planningObserver() {
    QVERIFY(std::abs(kSdOverMeanAbsolute - std::sqrt(std::acos(-1.0) / 2.0 - 1.0)) < 1e-9);
    QVERIFY(std::abs(kSdOverMeanAbsolute - 0.756) < 5e-4 &&
            std::abs(kP2SdPercent / kP2MeanPercent - 0.796) < 5e-4);
    QVERIFY(std::abs(kP2MeanPercent * std::sqrt(std::acos(-1.0) / 2.0) - 17.8) < 0.05);
    const ApexSummary large = summariseApex(simulateApex({}, 200, 100, kP2Radius_m, 1), kP2Radius_m, 1);
    qInfo("observer of 17.8 %% R: mean %.2f %%, sd %.2f %%, ratio %.4f, sigma %.2f mm",
          large.meanAbsolutePercent, large.sdAbsolutePercent, large.sdOverMean, large.impliedSd_mm);
    QVERIFY(std::abs(large.meanAbsolutePercent - 14.2) < 0.25 &&
            std::abs(large.sdOverMean - kSdOverMeanAbsolute) < 0.01);
    QVERIFY(std::abs(large.impliedSd_mm - 3.56) < 0.06);
}

void TestApexStudy::knownPopulation() {
    int covered = 0;
    double within = 0.0;
    double between = 0.0;
    for (int seed = 1; seed <= 200; ++seed) {
        const auto trials = simulateApex({.sdPercent = 15.0, .sdBetweenPercent = 8.0}, 8, 10, 0.02,
                                         static_cast<std::uint64_t>(seed));
        const ApexSummary summary = summariseApex(trials, 0.02, 1);
        for (const ApexAxis& axis : summary.axes) {
            covered += axis.bias95_mm.low <= 0.0 && 0.0 <= axis.bias95_mm.high ? 1 : 0;
            within += axis.sdWithin_mm * axis.sdWithin_mm / 400.0;
            between += axis.sdBetween_mm * axis.sdBetween_mm / 400.0;
        }
    }
    qInfo("bias intervals cover %.3f; sd within %.3f mm (3.0), between %.3f mm (1.6)", covered / 400.0,
          std::sqrt(within), std::sqrt(between));
    QVERIFY(covered >= 368 && std::abs(std::sqrt(within) - 3.0) < 0.1 &&
            std::abs(std::sqrt(between) - 1.6) < 0.15);
}

void TestApexStudy::biasIsFound() {
    auto trials = simulateApex({}, 10, 10, 0.02, 3);
    for (ApexTrial& trial : trials)
        trial.errorX_m += 0.004;
    const ApexSummary summary = summariseApex(trials, 0.02, 3);
    QVERIFY(summary.axes[0].bias95_mm.low < 4.0 && summary.axes[0].bias95_mm.high > 4.0 &&
            summary.axes[0].bias95_mm.low > 0.0);
    QVERIFY(std::any_of(summary.warnings.begin(), summary.warnings.end(),
                        [](const Warning& w) { return warningText(w).starts_with("bias_x: "); }));
    QVERIFY(summary.bars.size() == 10 && summary.points.size() == 100);
    QCOMPARE(summary.meanAbsoluteBootstrap95.low, summariseApex(trials, 0.02, 3).meanAbsoluteBootstrap95.low);
}

/// Two participants, two trials each, radius 10 mm; per cent of the radius by hand.
void TestApexStudy::byHand() {
    const ApexSummary s =
        summariseApex({{1, 0.001, -0.002}, {1, 0.003, 0.002}, {2, -0.001, 0.0}, {2, -0.001, 0.004}}, 0.01, 1);
    QVERIFY(std::abs(s.axes[0].bias_mm - 0.5) < 1e-12 && std::abs(s.axes[1].bias_mm - 1.0) < 1e-12);
    QVERIFY(std::abs(s.axes[0].sdWithin_mm - 1.0) < 1e-12);  // (2·1 + 0)/2 degrees
    QVERIFY(std::abs(s.axes[0].sdBetween_mm - 2.0) < 1e-12); // (9 − 1)/2 = 4
    QVERIFY(std::abs(s.axes[0].sdPercent - 10.0 * std::sqrt(5.0)) < 1e-9);
    QVERIFY(std::abs(s.meanAbsolutePercent - 17.5) < 1e-12); // (10+20+30+20+10+0+10+40)/8
    QVERIFY(std::abs(s.meanAbsolute_mm - 1.75) < 1e-12 && std::abs(s.bars[1].meanPercent - 15.0) < 1e-12);
    QVERIFY(std::abs(s.meanDistance_mm - (std::sqrt(5.0) + std::sqrt(13.0) + 1.0 + std::sqrt(17.0)) / 4.0) <
            1e-12);
}

/// Box & Tiao 1973 (lme4's Dyestuff and Dyestuff2): six batches of five. REML by lme4: 1764 and 2451; 0
/// and 13.81, where the mean square within is 14.95.
void TestApexStudy::varianceComponentsOfDyestuff() {
    const VarianceComponents yield = varianceComponents({{1545, 1440, 1440, 1520, 1580},
                                                         {1540, 1555, 1490, 1560, 1495},
                                                         {1595, 1550, 1605, 1510, 1560},
                                                         {1445, 1440, 1595, 1465, 1545},
                                                         {1595, 1630, 1515, 1635, 1625},
                                                         {1520, 1455, 1450, 1480, 1445}});
    QVERIFY(std::abs(yield.between - 1764.05) < 0.01 && std::abs(yield.within - 2451.25) < 0.01 &&
            std::abs(yield.mean - 1527.5) < 1e-9 && !yield.cut);
    const VarianceComponents cut = varianceComponents({{7.298, 3.846, 2.434, 9.566, 7.990},
                                                       {5.220, 6.556, 0.608, 11.788, -0.892},
                                                       {0.110, 10.386, 13.434, 5.510, 8.166},
                                                       {2.212, 4.852, 7.092, 9.288, 4.980},
                                                       {0.282, 9.014, 4.458, 9.446, 7.198},
                                                       {1.722, 4.782, 8.106, 0.758, 3.758}});
    qInfo("Dyestuff: between %.2f, within %.2f; Dyestuff2: between %.2f, within %.3f", yield.between,
          yield.within, cut.between, cut.within);
    QVERIFY(cut.cut && cut.between == 0.0 && std::abs(cut.within - 13.81) < 0.005 &&
            std::abs(cut.mean - 5.6656) < 1e-9);
}

namespace {

/// Minus twice the log of the restricted likelihood, from the whole covariance matrix: ln|V| + ln|1'V⁻¹1| +
/// y'Py, by elimination.
double restrictedDeviance(const std::vector<std::vector<double>>& groups, double within, double between) {
    std::vector<double> y;
    std::vector<std::size_t> of;
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (const double value : groups[g]) {
            y.push_back(value);
            of.push_back(g);
        }
    const std::size_t n = y.size();
    std::vector<std::vector<double>> v(n, std::vector<double>(n + 2)); // with the right hand sides y and 1
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
            v[i][j] = (i == j ? within : 0.0) + (of[i] == of[j] ? between : 0.0);
        v[i][n] = y[i];
        v[i][n + 1] = 1.0;
    }
    double logs = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
        logs += std::log(v[k][k]);
        for (std::size_t i = 0; i < n; ++i)
            if (i != k)
                for (std::size_t j = n + 2; j-- > k;)
                    v[i][j] -= v[i][k] / v[k][k] * v[k][j];
    }
    double ones = 0.0, cross = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        ones += v[i][n + 1] / v[i][i];
        cross += v[i][n] / v[i][i];
        squares += y[i] * v[i][n] / v[i][i];
    }
    return logs + std::log(ones) + squares - cross * cross / ones;
}

} // namespace

/// Groups of unequal sizes: no pair of variances near by (or far off) is likelier.
void TestApexStudy::varianceComponentsMaximiseTheRestrictedLikelihood() {
    for (int seed = 1; seed <= 30; ++seed) {
        auto random = chiron::core::Random::stream(static_cast<std::uint64_t>(seed), "unbalanced groups");
        std::vector<std::vector<double>> groups;
        for (int g = 0; g < 5; ++g) {
            const double own = 0.2 * (seed % 4) * random.normal();
            groups.emplace_back();
            for (std::uint64_t left = 1 + random.below(6); left > 0; --left)
                groups.back().push_back(own + random.normal());
        }
        const VarianceComponents found = varianceComponents(groups);
        const double least = restrictedDeviance(groups, found.within, found.between);
        for (const double w : {0.5, 0.9, 0.999, 1.001, 1.1, 2.0})
            for (const double b : {-1.0, -0.1, -1e-3, 0.0, 1e-3, 0.1, 1.0})
                if (const double between = found.between + b * found.within; between >= 0.0)
                    QVERIFY2(restrictedDeviance(groups, w * found.within, between) > least - 1e-9,
                             qPrintable(QString::number(seed)));
    }
}

void TestApexStudy::power() {
    const ApexPlan p2 = planApex({}, 5, 10, kP2EarlierMeanPercent, 400, 1);
    const ApexPlan none = planApex({}, 5, 10, 14.2, 400, 1);
    const ApexPlan fewer = planApex({.sdPercent = 17.8, .sdBetweenPercent = 10.0}, 3, 3, 20.0, 400, 1);
    qInfo("5 participants, 10 trials: half width %.2f %% R, power against 29.7 %% R %.3f, false alarms %.3f",
          p2.halfWidthPercent, p2.power, none.power);
    QVERIFY(p2.power > 0.99 && none.power < 0.1 && fewer.power < 0.6 &&
            fewer.halfWidthPercent > p2.halfWidthPercent);
    QVERIFY(std::isnan(planApex({}, 1, 10, 20.0, 10, 1).power));
}

void TestApexStudy::degenerate() {
    QVERIFY(std::isnan(summariseApex({}, 0.02, 1).meanAbsolutePercent) &&
            !summariseApex({}, 0.02, 1).warnings.empty());
    QVERIFY(summariseApex({{1, 0.0, 0.0}}, 0.0, 1).warnings.front().kind == WarningKind::noRadius &&
            warningText({WarningKind::noRadius}).starts_with("radius: "));
    const ApexSummary one =
        summariseApex({{1, 0.001, 0.002}, {1, std::nan(""), 0.0}, {2, 0.0, HUGE_VAL}}, 0.02, 1);
    QVERIFY(one.trials == 1 && one.leftOut == 2 && std::isnan(one.axes[0].sd_mm) &&
            std::isnan(one.meanAbsolute95.low));
    const ApexSummary exact =
        summariseApex({{1, 0.0, 0.0}, {1, 0.0, 0.0}, {2, 0.0, 0.0}, {2, 0.0, 0.0}}, 0.02, 1);
    QVERIFY(exact.meanAbsolutePercent == 0.0 && exact.axes[0].sd_mm == 0.0);
    const ApexSummary far = summariseApex({{1, 0.05, 0.0}, {2, 0.0, 0.0}}, 0.02, 1);
    QVERIFY(std::any_of(far.warnings.begin(), far.warnings.end(),
                        [](const Warning& w) { return warningText(w).starts_with("beyond_radius: 1"); }));
}

QTEST_APPLESS_MAIN(TestApexStudy)
#include "test_apex_study.moc"
