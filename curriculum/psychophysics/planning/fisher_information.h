// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/arrangement.h"

namespace chiron::psychophysics {

/// What one trial says about ln σ: the Fisher information of its outcomes for an ideal Thurstone observer with lapses, at a spacing D/σ.
/// 1/√(N·information) is the relative standard error of the JND after N trials. same_different and yes_no: half of the trials hold no
/// difference and say nothing; criterion √2 σ, and the remembered reference (felt with
/// the same noise). adjustment: 2, whatever the spacing. magnitude: 0.
/// `allCorrectOnly`: rank3 scored as right or wrong. `tie`: rank3_ties: what is felt nearer than so many σ is called equal, which is to be found
/// from the same answers (information about ln σ that is left by that).
double fisherInformation(Task task, double spacing, double lapse, bool allCorrectOnly = false, double tie = 0.5);

struct BestSpacing {
    double spacing = 0.0;     ///< D/σ
    double information = 0.0; ///< a trial, there
    double trialsFor10Percent = 0.0; ///< for a standard error of 10 % of the JND
};
BestSpacing bestSpacing(Task task, double lapse, bool allCorrectOnly = false, double tie = 0.5);

} // namespace chiron::psychophysics
