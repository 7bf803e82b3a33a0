// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_published.h"

#include "psychophysics/fits/sigmoid.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace chiron::psychophysics;
using namespace chiron::published;

namespace {

Sigmoid functionOf(const QString& fit) {
    if (fit.contains(QLatin1String("weib")) || fit.contains(QLatin1String("cloglog"))) {
        return Sigmoid::weibull;
    }
    return fit.contains(QLatin1String("logi")) ? Sigmoid::logistic : Sigmoid::gauss;
}

FitOptions optionsOf(const QString& fit, double guess) {
    FitOptions options;
    options.function = functionOf(fit);
    options.guess = Asymptote::fixedAt(guess);
    options.lapse = fit.endsWith(QLatin1String("free"))
                        ? Asymptote::fitted()
                        : Asymptote::fixedAt(fit.endsWith(QLatin1String("0.02")) ? 0.02 : 0.0);
    options.largestAsymptote = 0.99;
    options.profileIntervals = false;
    return options;
}

double rangeOf(const std::vector<double>& x) {
    return *std::max_element(x.begin(), x.end()) - *std::min_element(x.begin(), x.end());
}

/// Intercept and slope of glm are those of z = a + b x; errors from expected information.
void compareGlm(Tally& tally, const FitResult& fit, const QJsonObject& peer) {
    const SigmoidUnits units = unitsOf(fit.function);
    const double slope = units.spread / fit.best.width;
    const double wantedSlope = peer["slope"].toDouble(), wantedIntercept = peer["intercept"].toDouble();
    tally.compare("slope", slope, wantedSlope, 1e-3 * std::abs(wantedSlope));
    tally.compare("intercept", units.middle - slope * fit.best.threshold, wantedIntercept,
                  1e-3 * std::abs(wantedIntercept));
    const double slopeError = peer["se_slope"].toDouble(),
                 thresholdError = peer["se_of_that_delta_method"].toDouble();
    tally.compare("error of slope", slope * fit.expectedError.width / fit.best.width, slopeError,
                  1e-3 * slopeError);
    if (units.middle == 0.0) { // x at the predictor's zero is the threshold
        tally.compare("error of threshold", fit.expectedError.threshold, thresholdError,
                      1e-3 * thresholdError);
    }
    tally.compare("AIC", fit.aic, peer["AIC"].toDouble(), 2e-4);
}

void compareQuickpsy(Tally& tally, const FitResult& fit, const QJsonObject& peer, double range,
                     bool fixedLapse) {
    if (peer["degenerate_step_function"].toBool()) {
        tally.require("step flagged",
                      std::any_of(fit.warnings.begin(), fit.warnings.end(),
                                  [](const std::string& w) { return w.rfind("step_function:", 0) == 0; }));
    } else if (fixedLapse) {
        const double at = thresholdAt(fit, peer["threshold_prob"].toDouble());
        tally.compare("threshold", at, peer["threshold"].toDouble(), 1e-3 * range);
    }
}

double betterLikelihood(const QJsonObject& file, const QString& id, const QString& fit, double peer) {
    for (const QJsonValue missed : file["missed_optima"].toArray()) {
        if (missed["case"].toString() == id && missed["fit"].toString() == fit) {
            peer = std::max(peer, missed["better_loglik_found"].toDouble());
        }
    }
    return peer;
}

} // namespace

class TestFitPublishedLikelihood : public QObject {
    Q_OBJECT
private slots:
    void rPeers();
    void missedOptima();
    void groupedTrials();
    void questPlusNotebook();
};

void TestFitPublishedLikelihood::rPeers() {
    const QJsonObject file = dataFile("ml_fits_r_peers.json");
    Tally tally(QStringLiteral("ml_fits_r_peers.json"));
    int fits = 0;
    for (const QJsonValue value : file["cases"].toArray()) {
        const QString id = value["id"].toString();
        tally.startCase(id);
        const PsychometricData data{numbers(value["x"]), numbers(value["k"]), numbers(value["n"])};
        const QJsonObject peers = value["fits"].toObject();
        for (auto peer = peers.begin(); peer != peers.end(); ++peer, ++fits) {
            const FitResult fit =
                fitMaximumLikelihood(data, optionsOf(peer.key(), value["guess_rate"].toDouble()));
            const QJsonObject numbersOfPeer = peer.value().toObject();
            const double likelihood = numbersOfPeer["loglik_with_binomial_coefficient"].toDouble();
            tally.notBelow(qPrintable(peer.key() + QStringLiteral(" log-likelihood")), fit.logLikelihood,
                           betterLikelihood(file, id, peer.key(), likelihood), 1e-4);
            if (fit.logLikelihood < likelihood + 1e-3) { // else a better optimum was found
                tally.compare("deviance", fit.deviance, numbersOfPeer["deviance"].toDouble(), 1e-3);
                if (peer.key().startsWith(QLatin1String("glm"))) {
                    compareGlm(tally, fit, numbersOfPeer);
                } else {
                    compareQuickpsy(tally, fit, numbersOfPeer, rangeOf(data.x),
                                    !peer.key().endsWith(QLatin1String("free")));
                }
            }
        }
        tally.endCase();
    }
    std::printf("fits compared: %d\n", fits);
    QVERIFY(tally.report());
}

void TestFitPublishedLikelihood::missedOptima() {
    const QJsonObject file = dataFile("ml_fits_r_peers.json");
    Tally tally(QStringLiteral("ml_fits_r_peers.json, optima the peer missed"));
    for (const QJsonValue missed : file["missed_optima"].toArray()) {
        tally.startCase(missed["case"].toString() + QLatin1Char(' ') + missed["fit"].toString());
        for (const QJsonValue value : file["cases"].toArray()) {
            if (value["id"].toString() == missed["case"].toString()) {
                const PsychometricData data{numbers(value["x"]), numbers(value["k"]), numbers(value["n"])};
                const FitResult fit = fitMaximumLikelihood(
                    data, optionsOf(missed["fit"].toString(), value["guess_rate"].toDouble()));
                tally.notBelow("log-likelihood", fit.logLikelihood, missed["better_loglik_found"].toDouble(),
                               1e-4);
            }
        }
        tally.endCase();
    }
    QVERIFY(tally.report());
}

namespace {

PsychometricData groupTrials(const QString& participant, const QString& condition) {
    QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/psychophysics/data/qpdat_trials.csv"));
    PsychometricData data;
    if (file.open(QIODevice::ReadOnly)) {
        for (const QByteArray& line : file.readAll().split('\n')) {
            const auto cells = line.split(',');
            if (cells.size() == 5 && cells[0] == participant.toUtf8() && cells[1] == condition.toUtf8()) {
                data.x.push_back(cells[3].toDouble());
                data.k.push_back(cells[4].toDouble());
                data.n.push_back(1.0);
            }
        }
    }
    return data;
}

double numberOf(const QJsonValue& rows, const QString& participant, const QString& condition, const char* key,
                const char* parameter = nullptr) {
    for (const QJsonValue row : rows.toArray()) {
        if (row["participant"].toString() == participant && row["cond"].toString() == condition &&
            (parameter == nullptr || row["parn"].toString() == QLatin1String(parameter))) {
            return row[QLatin1String(key)].toDouble();
        }
    }
    return kNotKnown;
}

PsychometricData blocks(const FitResult& fit) {
    PsychometricData data;
    for (const FittedLevel& level : fit.levels) {
        data.x.push_back(level.x);
        data.k.push_back(level.right);
        data.n.push_back(level.of);
    }
    return data;
}

} // namespace

void TestFitPublishedLikelihood::groupedTrials() {
    const QJsonObject group = dataFile("ml_fits_r_peers.json")["grouped_case"].toObject();
    Tally tally(QStringLiteral("ml_fits_r_peers.json grouped case (qpdat_trials.csv)"));
    FitOptions options = optionsOf(QStringLiteral("cum_normal_lapse_0"), 0.0);
    for (const char* person : {"Participant1", "Participant2", "Participant3"}) {
        for (const char* cond : {"cond1", "cond2"}) {
            const QString participant = QLatin1String(person), condition = QLatin1String(cond);
            tally.startCase(participant + QLatin1Char(' ') + condition);
            const auto wanted = [&](const char* table, const char* key, const char* parameter = nullptr) {
                return numberOf(group[QLatin1String(table)], participant, condition, key, parameter);
            };
            const FitResult trials = fitMaximumLikelihood(groupTrials(participant, condition), options);
            const FitResult fit = fitMaximumLikelihood(blocks(trials), options);
            tally.compare("threshold of trials", trials.threshold, fit.threshold, 1e-9 * 400.0);
            tally.compare("threshold", fit.threshold, wanted("thresholds", "thre"), 1e-3);
            tally.compare("sd", fit.width / unitsOf(Sigmoid::gauss).spread, wanted("par", "par", "p2"), 1e-3);
            tally.compare("error of threshold", fit.error.threshold, wanted("par", "se", "p1"), 1e-3 * 10.0);
            tally.compare("error of sd", fit.error.width / unitsOf(Sigmoid::gauss).spread,
                          wanted("par", "se", "p2"), 1e-3 * 10.0);
            tally.compare("deviance", fit.deviance, wanted("deviance", "deviance"), 1e-3);
            tally.compare("p", fit.chiSquareP, wanted("deviance", "p_value"), 1e-5);
            tally.compare("log-likelihood", fit.logLikelihood, wanted("logliks", "loglik"), 1e-4);
            tally.compare("AIC", fit.aic, wanted("aic", "aic"), 2e-4);
            tally.endCase();
        }
    }
    QVERIFY(tally.report());
}

/// The log-likelihood that Watson's notebook prints, at its parameters: psi by the product's own sigmoid on
/// the dB axis.
void TestFitPublishedLikelihood::questPlusNotebook() {
    const QJsonObject notebook = dataFile("fit_small_checks.json")["mathematica_questplus_loglik"].toObject();
    Tally tally(QStringLiteral("published_small_checks.json, QUEST+ notebook log-likelihood"));
    tally.startCase(QStringLiteral("notebook"));
    const QJsonObject p = notebook["parameters"].toObject();
    FitResult at;
    at.function = Sigmoid::gumbel; // a Weibull whose x is already in dB
    const SigmoidUnits units = unitsOf(at.function);
    const double slope = p["slope"].toDouble() * std::log(10.0) / 20.0;
    at.best = {p["threshold"].toDouble() + units.middle / slope, units.spread / slope, p["lapse"].toDouble(),
               p["guess"].toDouble(), 0.0};
    const auto x = numbers(notebook["x"]), correct = numbers(notebook["correct"]);
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double psi = proportionAt(at, x[i]);
        sum += std::log(correct[i] > 0.0 ? psi : 1.0 - psi);
    }
    tally.compare("log-likelihood", sum, notebook["log_likelihood"].toDouble(), 5e-6);
    tally.endCase();
    QVERIFY(tally.report());
}

QTEST_GUILESS_MAIN(TestFitPublishedLikelihood)
#include "test_fit_published_likelihood.moc"
