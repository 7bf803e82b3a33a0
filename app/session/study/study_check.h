// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/study_limits.h"
#include "session/study/study_runner.h"

namespace chiron::session {

// What a simulated participant's run is refused for, asked before anything of it is written: a study, a participant or a row of the order
// design that were made for a refused run would stand in the way of the next one.

/// Whether the observer is of the study's kind. Failure: wrongUse.
core::Result<void> checkObserver(const psychophysics::StudyDesign& design, const psychophysics::ObserverSpec& observer);

/// All that can be told from the design: observer, condition, and of each condition to be done table, procedures and what the simulated device
/// renders. `blind`: conditions go by sealed codes, so request.condition is left to the database. Failure: wrongUse, notFound, badInput.
core::Result<void> checkStudyRun(const psychophysics::StudyDesign& design, bool blind, const StudyRunRequest& request);

/// What the run's device can render: measured once for all its conditions. A quick run has no device. Failure: simulatedLimits().
core::Result<RenderingLimits> limitsOfRun(const StudyRunRequest& request);

/// Largest difference that the simulated device renders. Failure: badInput, notFound (the scripted trainee).
core::Result<double> limitOnStation(const psychophysics::StudyDesign& design, bool blind, const psychophysics::Condition& condition,
                                    const StudyRunRequest& request, const RenderingLimits& limits);

} // namespace chiron::session
