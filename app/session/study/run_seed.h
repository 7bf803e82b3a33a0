// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/study_runner.h"
#include "session/study/study_store.h"

namespace chiron::session {

/// What a simulated participant's run of this condition is begun with.
std::uint64_t seedOf(const OpenedStudy& study, const std::string& label, const StudyRunRequest& request);
/// A seed that is asked for and would change nothing is refused (wrongUse): the run's choices are those of the one it was begun with.
core::Result<void> sameSeed(const OpenedStudy& study, const database::StudyRun& run, const StudyRunRequest& request);
/// The same where nothing is left to be run.
core::Result<void> seedIsOfWhatWasDone(const OpenedStudy& study, const StudyRunRequest& request);

} // namespace chiron::session
