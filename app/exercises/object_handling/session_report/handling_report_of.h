// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/object_handling/report/handling_report.h"
#include "catalogue/exercise.h"
#include "report/report_section.h"
#include "scoring/trace.h"
#include "session_report/exercise_words.h"

#include <memory>

namespace chiron::session_report {

/// What a session of object handling came to: squeeze and place of each trial, and its own metrics, as the scores compute them. A trial
/// that was stopped is there, as not finished. Pure.
report::HandlingReport handlingReportOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level);

/// The section of a report. Pure.
std::shared_ptr<const report::ReportSection> handlingSectionOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level);

/// What the end of a trial, and damage, are called.
EndWords handlingEnds();

} // namespace chiron::session_report
