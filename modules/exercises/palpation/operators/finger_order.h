// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cstdint>

namespace chiron::operators {

/// An order from the operator's strategy to one finger, valid until the next order.
/// Unit: SI.
/// Frame: W.
struct FingerOrder {
    core::Vec3 goal_W = core::Vec3::Zero();
    double speed_m_per_s = 0.1;
    std::uint32_t buttons = 0;
    core::Vec3 surface_W = core::Vec3::Zero();  ///< the point of the surface that it presses, as seen
    core::Vec3 normal_W{0.0, 0.0, 1.0};         ///< of the surface there, as seen
    core::Quat turn_W = core::Quat::Identity(); ///< orientation that the hand is to take; identity: pads down
    int press = 0;                              ///< increases with each press that it is to attend to …
    double attendFrom_s = 0.0;                  ///< … between these times
    double attendUntil_s = 0.0;
    int pressure = 0;
};

} // namespace chiron::operators
