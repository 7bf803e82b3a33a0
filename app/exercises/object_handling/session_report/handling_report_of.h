// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/object_handling/report/handling_report.h"
#include "catalogue/exercise.h"
#include "scoring/trace.h"

namespace chiron::session_report {

/// The results of a session of object handling: squeeze and position in each trial, and each trial's own
/// metrics, as the scores compute them. A trial that was stopped is included as not finished. Pure function.
report::HandlingReport handlingReportOf(const scoring::SessionTrace& trace,
                                        const catalogue::ExerciseLevel& level);

} // namespace chiron::session_report
