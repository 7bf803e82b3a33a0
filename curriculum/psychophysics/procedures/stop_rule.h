// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::psychophysics {

/// Says when a run ends: at whichever limit is reached first. 0: this limit does not apply.
struct StopRule {
    int trials = 0;        ///< at most this many
    int minimumTrials = 0; ///< the run never ends before
    int reversals = 0;
    double sd = 0.0;                 ///< largest posterior sd of the first parameter
    bool reversalsAndTrials = false; ///< trials and reversals must both be reached (PsychoPy's rule)
};

} // namespace chiron::psychophysics
