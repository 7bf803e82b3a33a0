// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/magnitude_estimation.h"

#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/measures/sample_moments.h"

#include <cmath>
#include <map>

namespace chiron::psychophysics {

namespace {

struct Line {
    double slope = std::numeric_limits<double>::quiet_NaN();
    double intercept = std::numeric_limits<double>::quiet_NaN();
    double standardError = std::numeric_limits<double>::quiet_NaN(); ///< of the slope
    double degrees = 0.0;
};

Line lineThrough(const std::vector<double>& x, const std::vector<double>& y) {
    Line line;
    const double middle = momentsOf(x).mean;
    const double height = momentsOf(y).mean;
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - middle) * (x[i] - middle);
        xy += (x[i] - middle) * (y[i] - height);
    }
    if (!(xx > 1e-18))
        return line;
    line.slope = xy / xx;
    line.intercept = height - line.slope * middle;
    line.degrees = static_cast<double>(x.size()) - 2.0;
    double residual = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
        residual += std::pow(y[i] - line.intercept - line.slope * x[i], 2);
    if (line.degrees > 0.0)
        line.standardError = std::sqrt(residual / line.degrees / xx);
    return line;
}

/// Logarithms of one subject's answers, also by stimulus.
struct Logs {
    std::vector<double> x, y;
    std::map<double, std::vector<double>> byStimulus;
};

void takeLevels(MagnitudeScale& result, const std::map<int, Logs>& subjects) {
    std::vector<double> moduli;
    for (const auto& [subject, logs] : subjects)
        moduli.push_back(momentsOf(logs.y).mean);
    const double common = momentsOf(moduli).mean;
    std::map<double, std::vector<double>> levels;
    std::size_t row = 0;
    for (const auto& [subject, logs] : subjects) {
        for (const auto& [stimulus, said] : logs.byStimulus)
            levels[stimulus].push_back(momentsOf(said).mean - moduli[row] + common);
        ++row;
    }
    std::vector<double> x;
    std::vector<double> y;
    for (const auto& [stimulus, means] : levels) {
        const SampleMoments m = momentsOf(means);
        result.levels.push_back({stimulus, std::pow(10.0, m.mean), m.sd, m.count});
        x.push_back(std::log10(stimulus));
        y.push_back(m.mean);
    }
    result.constant = std::pow(10.0, lineThrough(x, y).intercept);
}

void takeExponent(MagnitudeScale& result, const std::map<int, Logs>& subjects) {
    std::vector<double> slopes;
    Line last;
    for (const auto& [subject, logs] : subjects) {
        const Line line = lineThrough(logs.x, logs.y);
        result.subjects.push_back({subject, line.slope, line.intercept, static_cast<int>(logs.x.size())});
        if (std::isfinite(line.slope)) {
            slopes.push_back(line.slope);
            last = line;
        }
    }
    const SampleMoments m = momentsOf(slopes);
    result.exponent = m.mean;
    result.sdBetween = m.sd;
    const bool one = m.count == 1;
    const double degrees = one ? last.degrees : m.count - 1.0;
    const double error = one ? last.standardError : m.sd / std::sqrt(static_cast<double>(m.count));
    if (m.count > 0 && degrees > 0.0) {
        result.exponentLow = m.mean - studentQuantile(0.975, degrees) * error;
        result.exponentHigh = m.mean + studentQuantile(0.975, degrees) * error;
    }
    if (m.count == 0)
        result.warnings.push_back({WarningKind::oneStimulus});
    else if (m.count < 3)
        result.warnings.push_back({WarningKind::fewSubjects, m.count});
}

} // namespace

MagnitudeScale magnitudeScale(const std::vector<MagnitudeAnswer>& answers) {
    MagnitudeScale result;
    std::map<int, Logs> subjects;
    int leftOut = 0;
    for (const MagnitudeAnswer& answer : answers) {
        if (!(answer.stimulus > 0.0 && answer.number > 0.0) || !std::isfinite(answer.stimulus) ||
            !std::isfinite(answer.number)) {
            ++leftOut;
            continue;
        }
        Logs& logs = subjects[answer.subject];
        logs.x.push_back(std::log10(answer.stimulus));
        logs.y.push_back(std::log10(answer.number));
        logs.byStimulus[answer.stimulus].push_back(logs.y.back());
    }
    if (leftOut > 0)
        result.warnings.push_back({WarningKind::leftOutNumbers, leftOut});
    if (subjects.empty()) {
        result.warnings.push_back({WarningKind::noNumbers});
        return result;
    }
    takeExponent(result, subjects);
    takeLevels(result, subjects);
    return result;
}

} // namespace chiron::psychophysics
