// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "report/report_data.h"
#include "session/session_view.h"

namespace chiron::session_report {

/// Everything the printed report and the debrief show of one stored session: facts, stored scores, trials, samples.
/// `language` picks the content's texts. Reads through the session's connection, on its thread. Failure: the reader's.
core::Result<report::ReportData> reportDataOf(session::SessionView& session, database::Connection& connection,
                                      const database::Actor& actor, const std::string& language);

/// The same without what has to be read from the recording (samples, answers, duration): for a debrief that must not wait, and
/// for a session whose recording was erased. Failure: the scores'.
core::Result<report::ReportData> reportHeadOf(const database::SessionRecord& record, const session::SessionSetup& setup,
                                              database::Connection& connection, const database::Actor& actor,
                                              const std::string& language);

/// Adds the published benchmark of a metric where there is one; of sessions whose force was felt. Pure.
void addPublishedBand(report::MetricRow& row, int version);

/// Trials that came to an end: marked, done, timed out or failed; not those that the session's end broke off. Pure.
int trialsDoneOf(const std::vector<database::TrialRecord>& trials);

/// What the tissue answered, and what of it was felt. Pure.
report::ForceFacts feltFactsOf(const scoring::SessionTrace& trace);

} // namespace chiron::session_report
