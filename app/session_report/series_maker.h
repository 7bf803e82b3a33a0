// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "report/report_data.h"
#include "session/stored_session.h"

namespace chiron::session_report {

/// Position, force and speed of tool 0 over the whole session at 100 Hz (force: the largest of each 10 ms, so that no
/// peak is lost), paused spans and events; also a digest over the recording's chunks.
core::Result<report::SampleSeries> makeSeries(session::StoredSession& session, QString& recordingDigest);

} // namespace chiron::session_report
