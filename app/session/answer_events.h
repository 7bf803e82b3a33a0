// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/session_types.h"
#include "scoring/trace.h"
#include "session/stored_session.h"

#include <span>
#include <vector>

namespace chiron::session {

/// What a session's answers were worth, as events among the others: "missed" (a mark beside the sphere, or in the air), "false_alarm"
/// (where a finding was marked that found no lump; detail: finding, from 1) and "lump_missed" (at the end of a trial that came to
/// one). By the same judgement as the scores. Reads the recording once more where there is any. Failure: the reader's.
core::Result<std::vector<database::EventRecord>> answerEvents(StoredSession& session, const scoring::SessionTrace& trace,
                                                              std::span<const database::TrialRecord> trials);

} // namespace chiron::session
