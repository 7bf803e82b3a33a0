// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/drivers/keyboard_mouse/motion_intake.h"

#include <string>

namespace chiron::devices {

/// What both pointer drivers check of their settings. Failure: badInput naming driver, value and range. Not in the tick.
core::Result<void> checkPointer(const std::string& driver, const PseudoHaptics& pseudoHaptics, double following_s);

/// MotionIntake's share for a time constant; 0: everything at once.
double followingShare(double following_s);

} // namespace chiron::devices
