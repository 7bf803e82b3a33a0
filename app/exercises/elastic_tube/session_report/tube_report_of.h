// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/elastic_tube/report/tube_report.h"
#include "catalogue/exercise.h"
#include "scoring/trace.h"

namespace chiron::session_report {

/// The results of a session on an elastic tube: tension and stretch with their targets, and each trial's own
/// metrics, as the scores compute them. A trial that was stopped is included as not finished. Pure function.
report::TubeReport tubeReportOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level);

} // namespace chiron::session_report
