// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::report {

/// How a trial of a task without a mark ended.
enum class TrialOutcome {
    done,
    timedOut,
    failed,     ///< the trial could not be continued
    unfinished, ///< the session ended first
};

/// The outcome in words: "done", "time was up", "torn" (if the object can tear), "not finished".
QString trialOutcomeWords(TrialOutcome outcome, bool tears);

} // namespace chiron::report
