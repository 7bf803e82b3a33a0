// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::psychophysics {

/// When a run ends: whichever comes first. 0: does not end it.
struct StopRule {
    int trials = 0;        ///< at most so many
    int minimumTrials = 0; ///< never before
    int reversals = 0;
    double sd = 0.0;       ///< posterior sd of the first parameter at most
    bool reversalsAndTrials = false; ///< trials and reversals must both be reached (PsychoPy's rule)
};

} // namespace chiron::psychophysics
