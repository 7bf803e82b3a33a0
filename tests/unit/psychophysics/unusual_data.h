// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/fit.h"

#include <QtTest>

#include <cmath>
#include <string>
#include <vector>

/// Experiments that nobody plans but that do occur.
namespace chiron::tests {

struct UnusualData {
    const char* name;
    std::vector<double> right; ///< right answers at each level; the levels are 1, 2, 3, …
    double of;                 ///< trials at each level
    const char* likelihoodWarning;
    const char* posteriorWarning; ///< expected of the Gaussian in 2AFC; empty: none
};

inline const std::vector<UnusualData>& unusualExperiments() {
    static const std::vector<UnusualData> all{
        {"all right", {10, 10, 10, 10}, 10.0, "all_right", "all_right"},
        {"all wrong", {0, 0, 0, 0}, 10.0, "all_wrong", "all_wrong"},
        {"step", {0, 0, 10, 10}, 10.0, "step_function", "overdispersion"},
        {"falling", {20, 18, 15, 11, 6, 2}, 20.0, "no_rise", "not_monotone"},
        {"chance", {10, 10, 10, 10, 10, 10}, 20.0, "no_rise", "threshold_outside"},
        {"one trial each", {0, 1, 0, 1, 1}, 1.0, "few_trials_near_threshold", "few_trials_near_threshold"},
        {"two levels", {11, 20}, 20.0, "step_function", ""},
        {"overdispersed", {20, 40, 22, 40, 21, 40, 20, 40}, 40.0, "overdispersion", "overdispersion"},
        {"usual", {10, 12, 13, 17, 19, 20}, 20.0, "", ""},
    };
    return all;
}

inline psychophysics::PsychometricData counts(const std::vector<double>& right, double of) {
    psychophysics::PsychometricData data;
    for (std::size_t i = 0; i < right.size(); ++i) {
        data.x.push_back(static_cast<double>(i + 1));
        data.k.push_back(right[i]);
        data.n.push_back(of);
    }
    return data;
}

inline psychophysics::FitOptions twoChoices(psychophysics::Sigmoid function = psychophysics::Sigmoid::gauss) {
    psychophysics::FitOptions options;
    options.function = function;
    return options;
}

inline psychophysics::FitOptions yesNo(psychophysics::Sigmoid function = psychophysics::Sigmoid::gauss) {
    psychophysics::FitOptions options = twoChoices(function);
    options.guess = psychophysics::Asymptote::fitted();
    return options;
}

/// Whatever the data, a fit gives finite values, or NaN with a warning; proportions lie between 0 and 1.
inline void mustBeSane(const psychophysics::FitResult& fit) {
    QVERIFY(fit.fitted ? std::isfinite(fit.threshold) && fit.width > 0.0
                       : std::isnan(fit.threshold) && std::isnan(fit.width));
    QVERIFY(fit.fitted || !fit.warnings.empty());
    if (fit.fitted) {
        QVERIFY(fit.lapse >= 0.0 && fit.lapse < 1.0 && fit.guess >= 0.0 && fit.guess < 1.0);
        QVERIFY(!std::isnan(fit.deviance) && fit.deviance >= 0.0);
        QVERIFY(!std::isnan(fit.logLikelihood));
    }
    for (const std::string& warning : fit.warnings) {
        QVERIFY2(warning.find(": ") != std::string::npos && warning.find(' ') > warning.find(':'),
                 warning.c_str());
    }
}

} // namespace chiron::tests
