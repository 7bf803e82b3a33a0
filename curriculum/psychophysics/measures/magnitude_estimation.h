// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/warning.h"

#include <limits>
#include <string>
#include <vector>

namespace chiron::psychophysics {

/// A number that a participant gave for a stimulus.
struct MagnitudeAnswer {
    int subject = 0;
    double stimulus = 0.0; ///< SI, above zero
    double number = 0.0;   ///< above zero
};

struct SubjectPower {
    int subject = 0;
    double exponent = std::numeric_limits<double>::quiet_NaN();
    /// log10 of the number at stimulus 1, before the moduli were equalised.
    double intercept = std::numeric_limits<double>::quiet_NaN();
    int answers = 0;
};

struct MagnitudeLevel {
    double stimulus = 0.0;
    /// Over subjects, of each subject's own geometric mean after the moduli were equalised.
    double geometricMean = 0.0;
    double sdLog10 = std::numeric_limits<double>::quiet_NaN(); ///< between subjects, after the moduli were
                                                               ///< equalised
    int subjects = 0;
};

/// number = k · stimulus^exponent (Stevens 1957).
struct MagnitudeScale {
    /// Mean of the subjects' own slopes; for a single subject, its slope.
    double exponent = std::numeric_limits<double>::quiet_NaN();
    /// 95 %: t interval over subjects; for a single subject, t interval of the regression.
    double exponentLow = std::numeric_limits<double>::quiet_NaN();
    double exponentHigh = std::numeric_limits<double>::quiet_NaN();
    double sdBetween = std::numeric_limits<double>::quiet_NaN(); ///< of the subjects' slopes
    double constant = std::numeric_limits<double>::quiet_NaN();  ///< k of the line through all levels
    std::vector<SubjectPower> subjects;
    std::vector<MagnitudeLevel> levels;
    std::vector<Warning> warnings;
};

/// Fits a log–log regression per subject. The moduli are equalised by moving each subject's mean log to the
/// mean of all subjects (Lane, Catania & Stevens 1961); the levels hold geometric means. Answers that are not
/// above zero are left out.
MagnitudeScale magnitudeScale(const std::vector<MagnitudeAnswer>& answers);

} // namespace chiron::psychophysics
