// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::haptics {

/// Returns true if no entry of force or torque is infinite or not a number.
inline bool isFinite(const core::Wrench& w) noexcept {
    return w.force.allFinite() && w.torque.allFinite();
}

} // namespace chiron::haptics
