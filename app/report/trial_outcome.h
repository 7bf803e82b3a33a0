// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::report {

/// How a trial of a task without a mark ended.
enum class TrialOutcome {
    done,
    timedOut,
    failed,     ///< it could not be done any more
    unfinished, ///< the session ended before
};

/// In words: "done", "time was up", "torn" (where it can tear), "not finished".
QString trialOutcomeWords(TrialOutcome outcome, bool tears);

} // namespace chiron::report
