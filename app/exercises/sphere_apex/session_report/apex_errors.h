// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/report/apex_report.h"
#include "catalogue/exercise.h"
#include "report/report_section.h"
#include "scoring/trace.h"
#include "session_report/exercise_words.h"

#include <memory>
#include <vector>

namespace chiron::session_report {

/// The position of each trial's answer, % of the radius, as the scores count it; without a mark, the tool's
/// position at the end. Pure function.
std::vector<report::ApexError> apexErrorsOf(const scoring::SessionTrace& trace);

/// The section of a report. Pure function.
std::shared_ptr<const report::ReportSection> apexSectionOf(const scoring::SessionTrace& trace,
                                                           const catalogue::ExerciseLevel& level);

/// The words for the end of a trial and for damage.
EndWords apexEnds();

} // namespace chiron::session_report
