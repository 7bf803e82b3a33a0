// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/drivers/keyboard_mouse/motion_intake.h"

#include <string>

namespace chiron::devices {

/// Checks the settings that both pointer drivers share. Not for the tick.
/// Errors: badInput naming driver, value and range.
core::Result<void> checkPointer(const std::string& driver, const PseudoHaptics& pseudoHaptics,
                                double following_s);

/// Returns MotionIntake's share for a time constant; with 0 the tool follows at once.
double followingShare(double following_s);

} // namespace chiron::devices
