// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/comparison_reporter.h"

namespace chiron::session_report {

EndWords ComparisonReporter::ends() const {
    return {MarkTexts::tr("Answered"), MarkTexts::tr("The comparison was completed"),
            MarkTexts::tr("Time was up without an answer"),
            MarkTexts::tr("The comparison could no longer be completed"),
            MarkTexts::tr("The object was damaged")};
}

} // namespace chiron::session_report
