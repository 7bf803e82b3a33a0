// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/report/palpation_report_data.h"
#include "app/exercises/palpation/session/palpation_record.h"
#include "catalogue/exercise.h"
#include "report/report_section.h"
#include "scoring/trace.h"

#include <memory>
#include <optional>

namespace chiron::session_report {

/// The report's content for one palpation trial.
report::PalpationTrialReport palpationTrialOf(const session::PalpationTrialRecord& record,
                                              const simulation::PalpationParameters& level);

/// Empty for other exercises, and if the recording does not contain the reports; the metrics state this.
std::optional<report::PalpationReport> palpationReportOf(const scoring::SessionTrace& trace,
                                                         const catalogue::ExerciseLevel& level);

/// The section of a report; null if palpationReportOf() is empty. Pure function.
std::shared_ptr<const report::ReportSection> palpationSectionOf(const scoring::SessionTrace& trace,
                                                                const catalogue::ExerciseLevel& level);

} // namespace chiron::session_report
