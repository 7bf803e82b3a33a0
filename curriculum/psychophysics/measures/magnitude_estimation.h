// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/warning.h"

#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// A number said for a stimulus.
struct MagnitudeAnswer {
    int subject = 0;
    double stimulus = 0.0; ///< SI, above zero
    double number = 0.0;   ///< above zero
};

struct SubjectPower {
    int subject = 0;
    double exponent = std::numeric_limits<double>::quiet_NaN();
    double intercept = std::numeric_limits<double>::quiet_NaN(); ///< log10 of the number at stimulus 1, before moduli were made equal
    int answers = 0;
};

struct MagnitudeLevel {
    double stimulus = 0.0;
    double geometricMean = 0.0; ///< over subjects, of each subject's own geometric mean, moduli made equal
    double sdLog10 = std::numeric_limits<double>::quiet_NaN(); ///< between subjects, moduli made equal
    int subjects = 0;
};

/// number = k · stimulus^exponent (Stevens 1957).
struct MagnitudeScale {
    double exponent = std::numeric_limits<double>::quiet_NaN(); ///< mean of the subjects' own slopes; of one subject, its slope
    double exponentLow = std::numeric_limits<double>::quiet_NaN(); ///< 95 %: t over subjects; of one subject, t of the regression
    double exponentHigh = std::numeric_limits<double>::quiet_NaN();
    double sdBetween = std::numeric_limits<double>::quiet_NaN(); ///< of the subjects' slopes
    double constant = std::numeric_limits<double>::quiet_NaN();  ///< k of the line through all levels
    std::vector<SubjectPower> subjects;
    std::vector<MagnitudeLevel> levels;
    std::vector<Warning> warnings;
};

/// Log–log regression a subject, moduli made equal by moving each subject's mean log to the mean of all (Lane, Catania & Stevens 1961),
/// geometric means by level. Answers that are not above zero are left out.
MagnitudeScale magnitudeScale(const std::vector<MagnitudeAnswer>& answers);

} // namespace chiron::psychophysics
