// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <cmath>
#include <cstdint>

namespace chiron::recording {

inline constexpr double kForceResolution_N = 1e-3;   ///< 1 mN
inline constexpr double kTorqueResolution_Nm = 1e-5; ///< 0.01 mN·m
inline constexpr double kAngleResolution_rad = 1e-5; ///< display pose
inline constexpr double kEnergyResolution_J = 1e-5;  ///< 10 µJ, a hundredth of the passivity guard's
                                                     ///< threshold

/// Largest count that a finite value is stored as (about 1 MN at 1 mN); larger values saturate.
inline constexpr std::int64_t kMaximumQuantum = std::int64_t{1} << 30;
inline constexpr std::int64_t kNaNQuantum = kMaximumQuantum + 2;      ///< represents NaN
inline constexpr std::int64_t kInfinityQuantum = kMaximumQuantum + 1; ///< with either sign, represents ±
                                                                      ///< infinity

/// Returns the steps per unit of a quantised channel: 1/resolution, rounded to the nearest whole number (1e-3
/// -> 1000) if it is one, so that a stored value equals the double nearest to its decimal text.
double stepsPerUnit(double resolution) noexcept;

/// Returns the result of quantise() if `steps` = value · stepsPerUnit is no number within ±kMaximumQuantum.
std::int64_t quantiseOutOfRange(double value) noexcept;

/// Returns NaN or ± infinity for their codes; NaN for anything else.
double dequantiseCode(std::int64_t count) noexcept;

/// Rounds to the nearest step, ties to even (the rounding mode of the models). Finite values saturate at
/// ±kMaximumQuantum; NaN and infinities get their codes. Defined for every double.
inline std::int64_t quantise(double value, double stepsPerUnit) noexcept {
    const double steps = value * stepsPerUnit;
    if (std::abs(steps) <= static_cast<double>(kMaximumQuantum)) [[likely]]
        return std::lrint(steps);
    return quantiseOutOfRange(value);
}
/// Returns the double that a stored count represents: count / stepsPerUnit; the codes give NaN and ±
/// infinity.
inline double dequantise(std::int64_t count, double stepsPerUnit) noexcept {
    if (count >= -kMaximumQuantum && count <= kMaximumQuantum) [[likely]]
        return static_cast<double>(count) / stepsPerUnit;
    return dequantiseCode(count);
}

/// Rounds the force to 1 mN and the torque to 0.01 mN·m: exactly the values that a reader of the recording
/// gets.
core::Array6 roundedWrench(const core::Array6& wrench) noexcept;
/// Returns the frame with its wrenches and display pose as they will be read back, and with its reserved and
/// unused parts set to zero, so that live scoring from rounded frames equals later scoring from the file.
/// Quantities and energies are also set to zero, because the channel table decides which of them a recording
/// has and at what resolution.
core::HapticFrame roundedFrame(const core::HapticFrame& frame) noexcept;

} // namespace chiron::recording
