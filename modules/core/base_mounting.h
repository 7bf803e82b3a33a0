// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace chiron::core {

/// Where and how a device stands in the field W, in addition to where its exercise places it (P2, "Flexible
/// Mounting Options").
/// Unit: SI.
/// Frame: W.
struct BaseMounting {
    double scale = 1.0;               ///< tool movement per hand movement, kSmallestScale..kLargestScale
    std::array<double, 3> origin_m{}; ///< shift of the workspace in W, at most kLargestShift_m per axis
    bool leftHanded = false;          ///< the workspace is mirrored left to right
    /// Rotation of the device's base: first to the left about the vertical, then tilted away from the person,
    /// then rolled to the right; at most kLargestTurn_rad for each angle. Not for a pointer, which has no
    /// base.
    std::array<double, 3> turn_rad{};
    /// A rotation of 0 is deliberate: the base is not turned, whatever the level says.
    bool turnGiven = false;

    static constexpr double kSmallestScale = 0.25;
    static constexpr double kLargestScale = 4.0;
    static constexpr double kLargestShift_m = 0.030;
    /// 45°: beyond it a gimbal no longer reaches the field.
    static constexpr double kLargestTurn_rad = 0.7853981633974483;

    bool turned() const noexcept { return turn_rad != std::array<double, 3>{}; }
    /// Returns this mounting, in which every value that still has its default is replaced by that of `usual`.
    BaseMounting over(const BaseMounting& usual) const noexcept {
        BaseMounting both = *this;
        if (scale == 1.0)
            both.scale = usual.scale;
        if (origin_m == std::array<double, 3>{})
            both.origin_m = usual.origin_m;
        both.leftHanded = leftHanded != usual.leftHanded; // a left-handed person gets the level's picture
                                                          // mirrored
        if (!turned() && !turnGiven)
            both.turn_rad = usual.turn_rad;
        return both;
    }
};

} // namespace chiron::core
