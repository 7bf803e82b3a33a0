// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "report/report_data.h"
#include "session/session_view.h"

namespace chiron::session_report {

/// All data that the printed report and the debrief show of one stored session: facts, stored scores, trials,
/// samples. `language` selects the content's texts. Reads through the session's connection, on its thread.
/// Errors: those of the reader.
core::Result<report::ReportData> reportDataOf(session::SessionView& session, database::Connection& connection,
                                              const database::Actor& actor, const std::string& language);

/// The same without data from the recording (samples, answers, duration), for a debrief that must not wait
/// and for a session whose recording was erased.
/// Errors: those of reading the scores.
core::Result<report::ReportData> reportHeadOf(const database::SessionRecord& record,
                                              const session::SessionSetup& setup,
                                              database::Connection& connection, const database::Actor& actor,
                                              const std::string& language);

/// Adds the published benchmark of a metric in this version if it has one (MetricDefinition::published); only
/// for sessions whose force was felt. Pure function.
void addPublishedBand(report::MetricRow& row, int version);

/// The number of trials that came to an end: marked, done, timed out or failed, but not cut off by the end of
/// the session. Pure function.
int trialsDoneOf(const std::vector<database::TrialRecord>& trials);

/// The tissue's force and the part of it that was felt. Pure function.
report::ForceFacts feltFactsOf(const scoring::SessionTrace& trace);

} // namespace chiron::session_report
