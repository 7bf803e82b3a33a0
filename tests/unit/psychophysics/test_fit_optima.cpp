// SPDX-License-Identifier: GPL-3.0-or-later
// Data whose likelihood has a second maximum, a long ridge, or a maximum at no lapses at all; the best
// likelihoods are those of a grid polished by two general optimisers.
#include "psychophysics/fits/fit.h"

#include <QVector>
#include <QtTest>
#include <cmath>
#include <random>

using namespace chiron::psychophysics;

class TestFitOptima : public QObject {
    Q_OBJECT
private slots:
    void bestKnown_data();
    void bestKnown();
    void stepFarFromZero();
    void heightOfNoRise_data();
    void heightOfNoRise();
    void nothingOfTheStimulus_data();
    void nothingOfTheStimulus();
    void equalToAFixedLapse();
};

namespace {

PsychometricData dataOf(const QVector<double>& x, const QVector<double>& k, double n) {
    return {{x.begin(), x.end()},
            {k.begin(), k.end()},
            std::vector<double>(static_cast<std::size_t>(x.size()), n)};
}

FitOptions optionsOf(Sigmoid function, double guess, double lapse) { // negative: free
    FitOptions options;
    options.function = function;
    options.guess = guess < 0.0 ? Asymptote::fitted() : Asymptote::fixedAt(guess);
    options.lapse = lapse < 0.0 ? Asymptote::fitted() : Asymptote::fixedAt(lapse);
    return options;
}

} // namespace

void TestFitOptima::bestKnown_data() {
    QTest::addColumn<int>("function");
    QTest::addColumn<double>("guess");
    QTest::addColumn<double>("lapse");
    QTest::addColumn<QVector<double>>("x");
    QTest::addColumn<QVector<double>>("k");
    QTest::addColumn<double>("n");
    QTest::addColumn<double>("best");
    QTest::newRow("no lapses, no guesses, levels that are certain")
        << int(Sigmoid::gumbel) << -1.0 << -1.0
        << QVector<double>{1.8464801988795134, 2.7052719534032659, 2.7465522800451674, 7.5365536712990808,
                           7.604359690711803,  7.859077768424517,  9.2668832080959778}
        << QVector<double>{0, 3, 2, 5, 5, 5, 5} << 5.0 << -2.536441895417899;
    QTest::newRow("a ridge towards the largest lapse")
        << int(Sigmoid::gauss) << -1.0 << -1.0
        << QVector<double>{1.2284397488046095, 1.818554519851417,  2.1575136679194014, 2.3925287724449107,
                           2.8056517297757395, 2.8553201872392453, 4.4662800625547572, 6.1052000109138502,
                           7.6838713832703256, 9.2526896135409977}
        << QVector<double>{8, 12, 8, 12, 10, 6, 14, 10, 9, 10} << 59.0 << -23.13428773562552;
    QTest::newRow("a second maximum beside a step")
        << int(Sigmoid::weibull) << 1.0 / 3.0 << 0.02 << QVector<double>{1, 5.5, 10}
        << QVector<double>{11, 29, 28} << 31.0 << -7.072181178958061;
}

void TestFitOptima::bestKnown() {
    QFETCH(int, function);
    QFETCH(double, guess);
    QFETCH(double, lapse);
    QFETCH(QVector<double>, x);
    QFETCH(QVector<double>, k);
    QFETCH(double, n);
    QFETCH(double, best);
    const FitResult fit =
        fitMaximumLikelihood(dataOf(x, k, n), optionsOf(static_cast<Sigmoid>(function), guess, lapse));
    QVERIFY(fit.fitted);
    QVERIFY2(fit.logLikelihood > best - 1e-6, qPrintable(QString::number(fit.logLikelihood, 'g', 12)));
}

/// A step at a level, a million units from 0: threshold and width no longer hold the digits that the level's
/// share needs.
void TestFitOptima::stepFarFromZero() {
    PsychometricData data{{1.330194843412051, 1.9980525608761504, 3.8805000168244828, 4.281151613503576,
                           5.3277953440450165, 7.048100839358845},
                          {7, 4, 3, 9, 12, 9},
                          {39, 27, 12, 14, 13, 9}};
    const FitResult near = fitMaximumLikelihood(data, optionsOf(Sigmoid::tdist, 0.25, -1.0));
    for (double& x : data.x)
        x += 1e6;
    const FitResult far = fitMaximumLikelihood(data, optionsOf(Sigmoid::tdist, 0.25, -1.0));
    QVERIFY(std::abs(far.threshold - 1e6 - near.threshold) < 1e-8);
    QVERIFY2(std::abs(far.logLikelihood - near.logLikelihood) < 1e-6,
             qPrintable(QString::number(far.logLikelihood - near.logLikelihood)));
    QVERIFY(std::abs(far.deviance - near.deviance) < 1e-6);
}

void TestFitOptima::heightOfNoRise_data() {
    QTest::addColumn<QVector<double>>("k");
    QTest::addColumn<double>("expected");
    const auto binomial = [](double k, double n) {
        return std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0);
    };
    const double falling = binomial(15, 20) + binomial(12, 20) + binomial(9, 20);
    QTest::newRow("falling") << QVector<double>{15, 12, 9}
                             << falling + 36.0 * std::log(0.6) + 24.0 * std::log(0.4);
    QTest::newRow("below guessing") << QVector<double>{9, 8, 7}
                                    << binomial(9, 20) + binomial(8, 20) + binomial(7, 20) +
                                           60.0 * std::log(0.5);
    QTest::newRow("all right") << QVector<double>{20, 20, 20} << 60.0 * std::log(0.98);
}

/// No threshold, but how likely answers are without one is known, for comparing models.
void TestFitOptima::heightOfNoRise() {
    QFETCH(QVector<double>, k);
    QFETCH(double, expected);
    const FitResult fit =
        fitMaximumLikelihood(dataOf({1, 2, 3}, k, 20.0), optionsOf(Sigmoid::logistic, 0.5, 0.02));
    QVERIFY(!fit.fitted && std::isnan(fit.threshold) && !fit.warnings.empty());
    QVERIFY2(std::abs(fit.logLikelihood - expected) < 1e-9,
             qPrintable(QString::number(fit.logLikelihood, 'g', 12)));
    QVERIFY(fit.deviance >= 0.0);
}

void TestFitOptima::nothingOfTheStimulus_data() {
    QTest::addColumn<int>("function");
    for (const Sigmoid function : {Sigmoid::logistic, Sigmoid::gauss, Sigmoid::weibull, Sigmoid::gumbel,
                                   Sigmoid::rgumbel, Sigmoid::logn, Sigmoid::tdist, Sigmoid::hyperbolic})
        QTest::newRow(std::string(token(function)).c_str()) << int(function);
}

/// Trials without a stimulus, on an axis of logarithms, are answered by guessing whatever the curve is: they
/// add a constant to the likelihood.
void TestFitOptima::nothingOfTheStimulus() {
    QFETCH(int, function);
    std::mt19937_64 random(7);
    for (int round = 0; round < 40; ++round) {
        FitOptions options = optionsOf(static_cast<Sigmoid>(function), 0.5, round % 2 == 0 ? 0.02 : -1.0);
        options.scale = StimulusScale::ln;
        QVector<double> x{0.5, 1.0, 2.0, 4.0, 8.0}, k;
        const double steep = 1.0 + 0.15 * round;
        for (const double at : x)
            k << static_cast<double>(std::binomial_distribution<int>(
                30, 0.5 + 0.48 * (1.0 - std::exp(-std::pow(at / 2.0, steep))))(random));
        const FitResult without = fitMaximumLikelihood(dataOf(x, k, 30.0), options);
        x.prepend(0.0);
        k.prepend(13.0);
        const FitResult with = fitMaximumLikelihood(dataOf(x, k, 30.0), options);
        QCOMPARE(with.fitted, without.fitted);
        const double blank = std::lgamma(31.0) - std::lgamma(14.0) - std::lgamma(18.0) + 30.0 * std::log(0.5);
        QVERIFY2(std::abs(with.logLikelihood - without.logLikelihood - blank) < 1e-6,
                 qPrintable(QStringLiteral("round %1: %2 short")
                                .arg(round)
                                .arg(without.logLikelihood + blank - with.logLikelihood)));
        if (without.fitted && round % 2 == 0)
            QVERIFY(std::abs(with.threshold / without.threshold - 1.0) < 1e-4);
    }
}

/// "equal" beside a lapse that is given: both are that, and nothing of them is fitted.
void TestFitOptima::equalToAFixedLapse() {
    const PsychometricData data = dataOf({1, 2, 3, 4, 5}, {3, 6, 14, 24, 28}, 30.0);
    FitOptions both = optionsOf(Sigmoid::gauss, 0.05, 0.05), equal = both;
    equal.guess = Asymptote::equalToLapse();
    for (const bool bayesian : {false, true}) {
        const auto fit = [&](const FitOptions& options) {
            return bayesian ? fitBayesian(data, options) : fitMaximumLikelihood(data, options);
        };
        const FitResult asked = fit(equal), meant = fit(both);
        QCOMPARE(asked.guess, 0.05);
        QCOMPARE(asked.lapse, 0.05);
        QCOMPARE(asked.threshold, meant.threshold);
        QCOMPARE(asked.width, meant.width);
        QCOMPARE(asked.freeParameters, meant.freeParameters);
        QCOMPARE(asked.aic, meant.aic);
    }
}

QTEST_GUILESS_MAIN(TestFitOptima)
#include "test_fit_optima.moc"
