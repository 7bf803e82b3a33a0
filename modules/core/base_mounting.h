// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace chiron::core {

/// How a device stands in the field W, beside where its exercise puts it (P2, "Flexible Mounting Options"). SI units.
struct BaseMounting {
    double scale = 1.0;               ///< tool movement per hand movement, kSmallestScale..kLargestScale
    std::array<double, 3> origin_m{}; ///< shift of the workspace in W, at most kLargestShift_m an axis
    bool leftHanded = false;          ///< mirrored left to right
    /// How the device's base is turned: to the left about the vertical, then tilted away from the person, then rolled to the
    /// right; at most kLargestTurn_rad each. Not for a pointer, which has no base.
    std::array<double, 3> turn_rad{};
    bool turnGiven = false; ///< a turn of 0 is meant as well: the base is not turned, whatever the level says

    static constexpr double kSmallestScale = 0.25;
    static constexpr double kLargestScale = 4.0;
    static constexpr double kLargestShift_m = 0.030;
    static constexpr double kLargestTurn_rad = 0.7853981633974483; ///< 45°: beyond it a gimbal no longer reaches the field

    bool turned() const noexcept { return turn_rad != std::array<double, 3>{}; }
    /// This one, and where it says nothing (every value as it is made), what `usual` says.
    BaseMounting over(const BaseMounting& usual) const noexcept {
        BaseMounting both = *this;
        if (scale == 1.0)
            both.scale = usual.scale;
        if (origin_m == std::array<double, 3>{})
            both.origin_m = usual.origin_m;
        both.leftHanded = leftHanded != usual.leftHanded; // a left-handed person's picture of the level
        if (!turned() && !turnGiven)
            both.turn_rad = usual.turn_rad;
        return both;
    }
};

} // namespace chiron::core
