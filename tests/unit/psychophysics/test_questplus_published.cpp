// SPDX-License-Identifier: GPL-3.0-or-later
// QUEST+ against the published sequences of Watson (2017), as its peer in Python runs them
// (tests/unit/psychophysics/data).
#include "psychophysics/procedures/quest_plus.h"

#include "reference_json.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron::psychophysics;

namespace {

std::string functionOf(const QJsonObject& given) {
    const std::string name = given["func"].toString().toStdString();
    return name == "weibull" ? (given["scale"].toString() == "dB" ? "weibull_db" : "weibull_log10") : name;
}

QuestPlusSpec specOf(const QJsonObject& given) {
    QuestPlusSpec spec;
    spec.function = functionOf(given);
    spec.stop = {.trials = 1000};
    // A JSON object of Qt is sorted by key: the function's own order is kept by name.
    const QJsonObject stimuli = given["stimuli"].toObject();
    for (const std::string_view name : psychometricFunction(spec.function)->stimuli) {
        const QString key = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
        spec.stimuli.emplace_back(name, numbers(stimuli[key]));
    }
    const QJsonObject parameters = given["parameters"].toObject();
    for (auto it = parameters.begin(); it != parameters.end(); ++it)
        spec.parameters.push_back({it.key().toStdString(), numbers(it.value()), {}, false});
    return spec;
}

struct Differences {
    double entropy = 0.0, mean = 0.0, sd = 0.0, margin = 0.0;
    int choices = 0;   ///< that differ although the margin is above 1e-9
    int published = 0; ///< that differ from the published list
    int modes = 0;
};

void compareTrial(const QuestPlus& run, const QJsonObject& given, int trial, Differences& worst) {
    const Choice choice = run.next();
    const Stimulus peer = numbers(given["next"][trial]);
    const double margin = given["margin"][trial].toDouble();
    worst.choices += margin > 1e-9 && choice.stimulus != peer ? 1 : 0;
    worst.entropy =
        std::max(worst.entropy, std::abs(run.expectedEntropy() - given["entropy"][trial].toDouble()));
    worst.margin = std::max(worst.margin, std::abs(choice.entropyMargin - margin));
    const QJsonArray published = given["published_stimuli"].toArray();
    const Stimulus said = numbers(published[trial]);
    for (std::size_t i = 0; i < said.size(); ++i)
        worst.published += said[i] != peer[i] ? 1 : 0;
}

void comparePosterior(const QuestPlus& run, const QJsonObject& given, int trial, Differences& worst) {
    const std::vector<double> means = numbers(given["mean"][trial]);
    const std::vector<double> sds = numbers(given["sd"][trial]);
    const std::vector<double> modes = numbers(given["mode"][trial]);
    const auto estimates = run.estimate().parameters;
    for (std::size_t k = 0; k < estimates.size(); ++k) {
        worst.mean = std::max(worst.mean, std::abs(estimates[k].mean - means[k]));
        worst.sd = std::max(worst.sd, std::abs(estimates[k].sd - sds[k]));
        worst.modes += estimates[k].mode != modes[k] ? 1 : 0;
    }
}

} // namespace

class TestQuestPlusPublished : public QObject {
    Q_OBJECT
private slots:
    void sequences();
    void likelihoodOfTheNotebook();
    void gridPosterior();
};

void TestQuestPlusPublished::sequences() {
    ReferenceTally tally;
    for (const QJsonValue& value : referenceJson("questplus_sequences.json")["cases"].toArray()) {
        const QJsonObject given = value.toObject();
        const auto model = questPlusModel(specOf(given));
        QVERIFY2(model, model ? "" : model.error().message.c_str());
        QuestPlus run(*model, 1);
        Differences worst;
        const QJsonArray responses = given["responses"].toArray();
        for (int trial = 0; trial < responses.size(); ++trial) {
            compareTrial(run, given, trial, worst);
            QVERIFY(run.record(responses[trial].toInt(), numbers(given["next"][trial])));
            comparePosterior(run, given, trial, worst);
        }
        qInfo("%s: %d trials, choices off %d, entropy %.1e, margin %.1e, mean %.1e, sd %.1e, joint modes off "
              "%d",
              qPrintable(given["id"].toString()), static_cast<int>(responses.size()), worst.choices,
              worst.entropy, worst.margin, worst.mean, worst.sd, worst.modes);
        ++tally.cases;
        tally.passed +=
            worst.choices == 0 && worst.entropy < 1e-9 && worst.mean < 1e-9 && worst.sd < 1e-8 ? 1 : 0;
        tally.worst = std::max({tally.worst, worst.entropy, worst.mean});
        QCOMPARE(worst.published, 0);
        const QJsonObject mode = given["published_final_mode"].toObject();
        for (const NamedEstimate& estimate : run.estimate().parameters)
            if (mode.contains(QString::fromStdString(estimate.name)))
                QCOMPARE(estimate.mode, mode[QString::fromStdString(estimate.name)].toDouble());
    }
    qInfo("questplus_sequences.json: %d cases, %d passed, worst difference %.1e", tally.cases, tally.passed,
          tally.worst);
    QCOMPARE(tally.cases, 5);
    QCOMPARE(tally.passed, tally.cases);
}

/// Watson's notebook: the log-likelihood of its 32 example trials at the parameters they were simulated with.
void TestQuestPlusPublished::likelihoodOfTheNotebook() {
    const QJsonObject given =
        referenceJson("procedure_checks.json")["mathematica_questplus_loglik"].toObject();
    const QJsonObject at = given["parameters"].toObject();
    QuestPlusSpec spec;
    spec.function = "weibull_db";
    spec.stimuli = {{"intensity", {0.0}}};
    spec.parameters = {{"threshold", {at["threshold"].toDouble()}, {}, false},
                       {"slope", {at["slope"].toDouble()}, {}, false},
                       {"lower_asymptote", {at["guess"].toDouble()}, {}, false},
                       {"lapse_rate", {at["lapse"].toDouble()}, {}, false}};
    const auto model = questPlusModel(spec);
    QVERIFY(model);
    const std::vector<double> x = numbers(given["x"]);
    const std::vector<double> right = numbers(given["correct"]);
    double sum = 0.0;
    std::vector<double> likelihood;
    for (std::size_t i = 0; i < x.size(); ++i) {
        (*(*model)->tablesAt({x[i]}))->likelihood(0, static_cast<int>(right[i]), likelihood);
        sum += std::log(likelihood[0]);
    }
    const double off = std::abs(sum - given["log_likelihood"].toDouble());
    qInfo(
        "published_small_checks.json, mathematica_questplus_loglik: 1 case, %d passed, worst difference %.1e",
        off < 5.1e-6 ? 1 : 0, off);
    QVERIFY(off < 5.1e-6); // its last printed digit
}

/// Palamedes' PFBA example: a posterior on a grid, by its printed means and sd.
void TestQuestPlusPublished::gridPosterior() {
    const QJsonObject given = referenceJson("procedure_checks.json")["palamedes_PFBA"].toObject();
    std::vector<double> alpha, beta, lapse;
    for (int i = -100; i <= 100; ++i)
        alpha.push_back(i / 100.0);
    for (int i = -50; i <= 50; ++i)
        beta.push_back(std::pow(10.0, i / 100.0));
    for (int i = 0; i <= 6; ++i)
        lapse.push_back(i / 100.0);
    QuestPlusSpec spec;
    spec.function = "logistic";
    spec.stimuli = {{"x", numbers(given["x"])}};
    spec.parameters = {{"threshold", alpha, {}, false},
                       {"slope", beta, {}, false},
                       {"lower_asymptote", {0.5}, {}, false},
                       {"lapse_rate", lapse, {}, false}};
    const auto model = questPlusModel(spec);
    QVERIFY(model);
    PosteriorGrid posterior = (*model)->prior;
    const std::vector<double> k = numbers(given["k"]);
    const std::vector<double> n = numbers(given["n"]);
    std::vector<double> likelihood;
    for (std::size_t x = 0; x < k.size(); ++x)
        for (const int outcome : {0, 1}) {
            (*model)->tables->likelihood(x, outcome, likelihood);
            for (int i = 0; i < (outcome == 1 ? k[x] : n[x] - k[x]); ++i)
                QVERIFY(posterior.update(likelihood));
        }
    const QJsonObject mean = given["posterior_mean"].toObject();
    const QJsonObject sd = given["posterior_sd"].toObject();
    const std::vector<double> slopes = posterior.marginal(1);
    double logMean = 0.0, logSquare = 0.0;
    for (std::size_t i = 0; i < slopes.size(); ++i)
        logMean += slopes[i] * std::log10(beta[i]);
    for (std::size_t i = 0; i < slopes.size(); ++i)
        logSquare += slopes[i] * std::pow(std::log10(beta[i]) - logMean, 2);
    const double off = std::max({std::abs(posterior.estimate(0).mean - mean["alpha"].toDouble()),
                                 std::abs(logMean - mean["log10_beta"].toDouble()),
                                 std::abs(posterior.estimate(3).mean - mean["lambda_"].toDouble()),
                                 std::abs(posterior.sd(0) - sd["alpha"].toDouble()),
                                 std::abs(std::sqrt(logSquare) - sd["log10_beta"].toDouble()),
                                 std::abs(posterior.sd(3) - sd["lambda_"].toDouble())});
    qInfo("published_small_checks.json, palamedes_PFBA: 1 case, %d passed, worst difference %.1e",
          off < 5.1e-5 ? 1 : 0, off);
    QVERIFY(off < 5.1e-5); // its last printed digit
}

QTEST_APPLESS_MAIN(TestQuestPlusPublished)
#include "test_questplus_published.moc"
