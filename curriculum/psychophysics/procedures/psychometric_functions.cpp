// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/psychometric_functions.h"

#include "core/normal_distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::psychophysics {

namespace {

using Asymptotes = PsychometricFunction::Asymptotes;

/// Returns 1 - exp(-10^e), accurate near 0 too.
double weibullOf(double exponent) {
    return -std::expm1(-std::exp(std::numbers::ln10 * exponent));
}

double weibullDb(const double* x, const double* s) {
    return weibullOf(s[1] * (x[0] - s[0]) / 20.0);
}
double weibullLog10(const double* x, const double* s) {
    return weibullOf(s[1] * (x[0] - s[0]));
}
double weibullLinear(const double* x, const double* s) {
    return x[0] <= 0.0 ? 0.0 : -std::expm1(-std::pow(x[0] / s[0], s[1]));
}
double normCdf(const double* x, const double* s) {
    return core::normalCumulative((x[0] - s[0]) / s[1]);
}
double logistic(const double* x, const double* s) {
    return 1.0 / (1.0 + std::exp(-s[1] * (x[0] - s[0])));
}
double gumbel(const double* x, const double* s) {
    return weibullOf(s[1] * (x[0] - s[0]));
}
double reverseGumbel(const double* x, const double* s) {
    return std::exp(-std::exp(std::numbers::ln10 * -s[1] * (x[0] - s[0])));
}
double hyperbolicSecant(const double* x, const double* s) {
    return 2.0 / std::numbers::pi * std::atan(std::exp(0.5 * std::numbers::pi * s[1] * (x[0] - s[0])));
}

/// Watson 2017, example 4: threshold max(min_thresh, c0 + cf f + cw w), in dB.
double contrastSensitivity(const double* x, const double* s) {
    return weibullOf(s[4] * (x[0] - std::max(s[0], s[1] + s[2] * x[1] + s[3] * x[2])) / 20.0);
}

} // namespace

std::vector<std::string_view> PsychometricFunction::parameters() const {
    std::vector<std::string_view> names = shape;
    if (asymptotes == Asymptotes::guessLapse)
        names.push_back("lower_asymptote");
    names.push_back("lapse_rate");
    return names;
}

double PsychometricFunction::base(const double* a) const noexcept {
    return a[0];
}

double PsychometricFunction::scale(const double* a) const noexcept {
    return asymptotes == Asymptotes::guessLapse ? 1.0 - a[0] - a[1] : 1.0 - 2.0 * a[0];
}

const std::vector<PsychometricFunction>& psychometricFunctions() {
    static const std::vector<PsychometricFunction> all{
        {"weibull_db",
         "1 - exp(-10^(slope (x - threshold)/20))",
         {"intensity"},
         {"threshold", "slope"},
         Asymptotes::guessLapse,
         weibullDb},
        {"weibull_log10",
         "1 - exp(-10^(slope (x - threshold)))",
         {"intensity"},
         {"threshold", "slope"},
         Asymptotes::guessLapse,
         weibullLog10},
        {"weibull",
         "1 - exp(-(x/threshold)^slope)",
         {"intensity"},
         {"threshold", "slope"},
         Asymptotes::guessLapse,
         weibullLinear,
         true},
        {"norm_cdf", "Phi((x - mean)/sd)", {"intensity"}, {"mean", "sd"}, Asymptotes::guessLapse, normCdf},
        {"norm_cdf_2",
         "Phi((x - mean)/sd)",
         {"intensity"},
         {"mean", "sd"},
         Asymptotes::symmetricLapse,
         normCdf},
        {"logistic",
         "1/(1 + exp(-slope (x - threshold)))",
         {"intensity"},
         {"threshold", "slope"},
         Asymptotes::guessLapse,
         logistic},
        {"gumbel",
         "1 - exp(-10^(slope (x - threshold)))",
         {"intensity"},
         {"threshold", "slope"},
         Asymptotes::guessLapse,
         gumbel},
        {"reverse_gumbel",
         "exp(-10^(-slope (x - threshold)))",
         {"intensity"},
         {"threshold", "slope"},
         Asymptotes::guessLapse,
         reverseGumbel},
        {"hyperbolic_secant",
         "2/pi atan(exp(pi/2 slope (x - threshold)))",
         {"intensity"},
         {"threshold", "slope"},
         Asymptotes::guessLapse,
         hyperbolicSecant},
        {"csf",
         "1 - exp(-10^(slope (contrast - max(min_thresh, c0 + cf spatial_freq + cw temporal_freq))/20))",
         {"contrast", "spatial_freq", "temporal_freq"},
         {"min_thresh", "c0", "cf", "cw", "slope"},
         Asymptotes::guessLapse,
         contrastSensitivity},
    };
    return all;
}

const PsychometricFunction* psychometricFunction(std::string_view name) {
    for (const PsychometricFunction& function : psychometricFunctions())
        if (function.name == name)
            return &function;
    return nullptr;
}

} // namespace chiron::psychophysics
