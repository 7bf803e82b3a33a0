// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "report/report_section.h"
#include "scoring/trace.h"

#include <memory>

namespace chiron::session_report {

/// What the exercise of this level alone shows in a report of a session; null where it has nothing to show. A new kind adds a line in
/// app/exercises/report_catalogue.cpp. Pure.
std::shared_ptr<const report::ReportSection> exerciseSectionOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level);

} // namespace chiron::session_report
