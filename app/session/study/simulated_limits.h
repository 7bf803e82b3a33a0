// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/study/study_limits.h"

namespace chiron::session {

/// What the simulated gimbal of headless runs renders passively, at the delay that is measured on it with a participant's hand at rest: the
/// way that a device which is plugged in is measured. Always the same. Takes some 14 s of simulated time. Failure: measureDelay's.
core::Result<RenderingLimits> simulatedLimits();

} // namespace chiron::session
