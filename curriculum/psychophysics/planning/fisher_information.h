// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/arrangement.h"

namespace chiron::psychophysics {

/// Returns the information about ln σ in one trial: the Fisher information of its outcomes for an ideal
/// Thurstone observer with lapses, at a spacing D/σ. 1/√(N·information) is the relative standard error of the
/// JND after N trials. same_different and yes_no: half of the trials have no difference and carry no
/// information; the criterion is √2 σ, and the remembered reference has the same noise. adjustment: 2 at any
/// spacing. magnitude: 0.
/// `allCorrectOnly`: rank3 scored as right or wrong. `tie`: for rank3_ties, percepts nearer than this many σ
/// are called equal. This threshold has to be estimated from the same answers, and the result is the
/// information about ln σ that then remains.
double fisherInformation(Task task, double spacing, double lapse, bool allCorrectOnly = false,
                         double tie = 0.5);

struct BestSpacing {
    double spacing = 0.0;            ///< D/σ
    double information = 0.0;        ///< per trial, at this spacing
    double trialsFor10Percent = 0.0; ///< for a standard error of 10 % of the JND
};
BestSpacing bestSpacing(Task task, double lapse, bool allCorrectOnly = false, double tie = 0.5);

} // namespace chiron::psychophysics
