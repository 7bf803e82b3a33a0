// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "report/report_section.h"
#include "scoring/trace.h"

#include <memory>

namespace chiron::session_report {

/// The section of a session's report that is specific to the level's exercise; null if there is none. A new
/// exercise adds a line in app/exercises/report_catalogue.cpp. Pure function.
std::shared_ptr<const report::ReportSection> exerciseSectionOf(const scoring::SessionTrace& trace,
                                                               const catalogue::ExerciseLevel& level);

} // namespace chiron::session_report
