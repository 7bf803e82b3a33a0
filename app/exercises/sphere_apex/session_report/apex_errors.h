// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/report/apex_report.h"
#include "report/report_section.h"
#include "catalogue/exercise.h"
#include "scoring/trace.h"
#include "session_report/exercise_words.h"

#include <memory>
#include <vector>

namespace chiron::session_report {

/// Where each trial's answer lay, % of the radius: what the scores count; without a mark, where the tool stood at the end. Pure.
std::vector<report::ApexError> apexErrorsOf(const scoring::SessionTrace& trace);

/// The section of a report. Pure.
std::shared_ptr<const report::ReportSection> apexSectionOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level);

/// What the end of a trial, and damage, are called.
EndWords apexEnds();

} // namespace chiron::session_report
