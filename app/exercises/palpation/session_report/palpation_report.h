// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "app/exercises/palpation/report/palpation_report_data.h"
#include "report/report_section.h"
#include "scoring/trace.h"
#include "app/exercises/palpation/session/palpation_record.h"

#include <memory>
#include <optional>

namespace chiron::session_report {

/// What a report tells of one trial of a palpation.
report::PalpationTrialReport palpationTrialOf(const session::PalpationTrialRecord& record, const simulation::PalpationParameters& level);

/// Nothing for other exercises, and where the recording does not tell what was reported: the metrics say so then.
std::optional<report::PalpationReport> palpationReportOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level);

/// The section of a report; null where palpationReportOf() gives nothing. Pure.
std::shared_ptr<const report::ReportSection> palpationSectionOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level);

} // namespace chiron::session_report
