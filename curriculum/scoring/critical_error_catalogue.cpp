// SPDX-License-Identifier: GPL-3.0-or-later
// Critical errors other than tissue that gave way: one line per exercise that has such a rule.
#include "scoring/critical_error_catalogue.h"

#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"

namespace chiron::scoring {

std::vector<CriticalSpan> criticalSpans(const TrialTrace& trial) {
    std::vector<CriticalSpan> all;
    for (const auto spansOf : {criticalTrauma})
        for (const CriticalSpan& span : spansOf(trial))
            all.push_back(span);
    return all;
}

} // namespace chiron::scoring
