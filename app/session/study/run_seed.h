// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/study_runner.h"
#include "session/study/study_store.h"

namespace chiron::session {

/// The seed with which a simulated participant's run of this condition begins.
std::uint64_t seedOf(const OpenedStudy& study, const std::string& label, const StudyRunRequest& request);
/// Refuses a requested seed that differs from the seed with which the run began, because it would have no
/// effect.
/// Errors: wrongUse.
core::Result<void> sameSeed(const OpenedStudy& study, const database::StudyRun& run,
                            const StudyRunRequest& request);
/// The same check if no run is left to be done.
core::Result<void> seedIsOfWhatWasDone(const OpenedStudy& study, const StudyRunRequest& request);

} // namespace chiron::session
