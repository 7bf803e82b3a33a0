// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/trial_outcome.h"

#include "report/report_text.h"

namespace chiron::report {

QString trialOutcomeWords(TrialOutcome outcome, bool tears) {
    switch (outcome) {
    case TrialOutcome::done:
        return Words::tr("✓ done");
    case TrialOutcome::timedOut:
        return Words::tr("✗ time was up");
    case TrialOutcome::failed:
        return tears ? Words::tr("✗ torn") : Words::tr("✗ no longer possible");
    case TrialOutcome::unfinished:
        break;
    }
    return Words::tr("not finished");
}

} // namespace chiron::report
