// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/study_limits.h"
#include "session/study/study_runner.h"

namespace chiron::session {

// Checks that can refuse a simulated participant's run before anything of it is written. A study, a
// participant or a row of the order design created for a refused run would obstruct the next one.

/// Checks that the observer fits the type of the study.
/// Errors: wrongUse.
core::Result<void> checkObserver(const psychophysics::StudyDesign& design,
                                 const psychophysics::ObserverSpec& observer);

/// Checks everything that follows from the design: the observer, the condition, and for each condition to be
/// done its table, its procedures and what the simulated device renders. `blind`: conditions have sealed
/// codes, so the database checks request.condition.
/// Errors: wrongUse, notFound, badInput.
core::Result<void> checkStudyRun(const psychophysics::StudyDesign& design, bool blind,
                                 const StudyRunRequest& request);

/// The limits of the run's device, measured once for all its conditions. A quick run has no device.
/// Errors: those of simulatedLimits().
core::Result<RenderingLimits> limitsOfRun(const StudyRunRequest& request);

/// The largest difference that the simulated device renders.
/// Errors: badInput, notFound (the scripted trainee).
core::Result<double> limitOnStation(const psychophysics::StudyDesign& design, bool blind,
                                    const psychophysics::Condition& condition, const StudyRunRequest& request,
                                    const RenderingLimits& limits);

} // namespace chiron::session
