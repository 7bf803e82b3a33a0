// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/study/study_limits.h"

namespace chiron::session {

/// The limits that the simulated gimbal of headless runs renders passively, at the delay measured on it with
/// a participant's hand at rest, in the same way as for a connected device. The result is always the same.
/// Takes about 14 s of simulated time.
/// Errors: those of measureDelay.
core::Result<RenderingLimits> simulatedLimits();

} // namespace chiron::session
