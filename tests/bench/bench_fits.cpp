// SPDX-License-Identifier: GPL-3.0-or-later
// Psychometric fits beside R's glm with psyphy's m-AFC link on the same data: one maximum-likelihood fit with
// a fixed and with a free lapse, 2,000 bootstrap fits, and the Bayesian fit (peer: python-psignifit,
// published figure where it is not installed).
#include "bench/alternating.h"
#include "bench/bench_table.h"
#include "psychophysics/fits/fit.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>

using namespace chiron::bench;
using namespace chiron::psychophysics;

namespace {

constexpr int kRepeats = 5;
// Palamedes' demonstration of signal detection fits: 8 levels × 100 trials of 2AFC.
const PsychometricData kData{
    {1, 2, 3, 4, 5, 6, 7, 8}, {51, 53, 55, 69, 72, 86, 95, 99}, {100, 100, 100, 100, 100, 100, 100, 100}};
const PsychometricData kYesNo{
    {-3, -2, -1, 0, 1, 2, 3}, {2, 13, 28, 56, 73, 91, 93}, {100, 100, 100, 100, 100, 100, 100}};

constexpr const char* kScript = R"(
x <- c(1,2,3,4,5,6,7,8); k <- c(51,53,55,69,72,86,95,99); n <- rep(100, 8)
if (suppressWarnings(requireNamespace("psyphy", quietly = TRUE))) { link <- psyphy::mafc.logit(2)
} else { link <- structure(list(linkfun = function(mu) qlogis(pmin(pmax(2 * mu - 1, 1e-8), 1 - 1e-8)),
  linkinv = function(eta) 0.5 + 0.5 * plogis(eta), mu.eta = function(eta) 0.5 * dlogis(eta), valideta = function(eta) TRUE,
  name = "mafc"), class = "link-glm") }
once <- function(k) suppressWarnings(glm(cbind(k, n - k) ~ x, family = binomial(link)))
fit <- once(k)
one <- system.time(for (i in 1:300) once(k)); p <- fitted(fit)
set.seed(1)
many <- system.time(for (i in 1:2000) once(rbinom(8, n, p)))
cat(sprintf("%.9g %.9g %.9g %.9g\n", (one[1] + one[2]) / 300, many[1] + many[2], coef(fit)[1], coef(fit)[2]))
)";

struct RTimes {
    bool measured = false;
    double one_s = 0.0, bootstrap_s = 0.0, intercept = 0.0, slope = 0.0;
};

RTimes runR(const std::string& script) {
    RTimes times;
    const std::string command = "Rscript --vanilla '" + script + "' 2>/dev/null";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
    times.measured = pipe && std::fscanf(pipe.get(), "%lf %lf %lf %lf", &times.one_s, &times.bootstrap_s,
                                         &times.intercept, &times.slope) == 4;
    return times;
}

/// CPU time of one call, from enough of them to be measured.
double timed(int calls, const std::function<void()>& work) {
    return cpuSeconds([&] {
               for (int i = 0; i < calls; ++i) {
                   work();
               }
           }) /
           calls;
}

FitOptions likelihood(Asymptote lapse) {
    FitOptions options;
    options.function = Sigmoid::logistic;
    options.lapse = lapse;
    options.profileIntervals = false;
    return options;
}

BenchRow row(const char* work, const char* peer, const char* unit, double factor,
             const std::vector<double>& theirs, const std::vector<double>& ours, double published,
             double goal) {
    BenchRow line{.work = work, .peer = peer, .unit = unit};
    const bool measured = !theirs.empty();
    line.peerMedian = factor * (measured ? median(theirs) : published);
    line.oursMedian = factor * median(ours);
    line.p99 = factor * percentile(ours, 0.99);
    line.goal = text(">= %.0f times", goal);
    line.agreement = measured ? "–" : "peer not measured: published figure";
    line.reached = verdict(*line.ratio() >= goal);
    return line;
}

} // namespace

int main(int argc, char** argv) {
    printHeading("Psychometric fits");
    const std::string script = std::string(argc > 1 ? argv[1] : ".") + "/chiron-bench-fits.R";
    if (FILE* file = std::fopen(script.c_str(), "w")) {
        std::fputs(kScript, file);
        std::fclose(file);
    }
    const FitOptions fixed = likelihood(Asymptote::fixedAt(0.0)), free = likelihood(Asymptote::fitted());
    FitOptions bootstrap = fixed;
    bootstrap.bootstrap = Bootstrap::parametric;
    FitOptions yesNo;
    yesNo.guess = Asymptote::fitted();
    std::vector<double> rOne, rMany, fixedTimes, freeTimes, bootstrapTimes, choiceTimes, yesNoTimes;
    RTimes r;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        if (r = runR(script); r.measured) {
            rOne.push_back(r.one_s);
            rMany.push_back(r.bootstrap_s);
        }
        fixedTimes.push_back(timed(5000, [&] { fitMaximumLikelihood(kData, fixed); }));
        freeTimes.push_back(timed(1000, [&] { fitMaximumLikelihood(kData, free); }));
        bootstrapTimes.push_back(timed(3, [&] { fitMaximumLikelihood(kData, bootstrap); }));
        choiceTimes.push_back(timed(10, [&] { fitBayesian(kData, FitOptions{}); }));
        yesNoTimes.push_back(timed(3, [&] { fitBayesian(kYesNo, yesNo); }));
    }
    std::remove(script.c_str());
    std::vector<BenchRow> rows{
        row("ML fit, fixed lapse", "R glm + psyphy", "us", 1e6, rOne, fixedTimes, 1.2e-3, 400.0),
        row("ML fit, free lapse", "R glm + psyphy (fixed)", "us", 1e6, rOne, freeTimes, 1.2e-3, 50.0),
        row("2,000 bootstrap fits, BCa", "R glm + psyphy", "ms", 1e3, rMany, bootstrapTimes, 3.3, 200.0),
        row("Bayesian fit, 2AFC", "python-psignifit", "ms", 1e3, {}, choiceTimes, 1.04, 20.0),
        row("Bayesian fit, yes-no", "python-psignifit", "ms", 1e3, {}, yesNoTimes, 8.0, 16.0)};
    if (r.measured) {
        const FitResult fit = fitMaximumLikelihood(kData, fixed);
        const double slope = unitsOf(fit.function).spread / fit.best.width;
        rows.front().agreement = text("slope %.1e, intercept %.1e apart", std::abs(slope / r.slope - 1.0),
                                      std::abs(-slope * fit.best.threshold / r.intercept - 1.0));
    }
    printTable(rows);
    return 0;
}
