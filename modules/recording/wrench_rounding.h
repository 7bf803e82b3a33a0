// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"

#include <cmath>
#include <cstdint>

namespace chiron::recording {

inline constexpr double kForceResolution_N = 1e-3;   ///< 1 mN
inline constexpr double kTorqueResolution_Nm = 1e-5; ///< 0.01 mN·m
inline constexpr double kAngleResolution_rad = 1e-5; ///< display pose
inline constexpr double kEnergyResolution_J = 1e-5;  ///< 10 µJ, a hundredth of what the passivity guard acts on

/// Largest count a finite value is stored as (about 1 MN at 1 mN): beyond it the value saturates.
inline constexpr std::int64_t kMaximumQuantum = std::int64_t{1} << 30;
inline constexpr std::int64_t kNaNQuantum = kMaximumQuantum + 2;      ///< stands for NaN
inline constexpr std::int64_t kInfinityQuantum = kMaximumQuantum + 1; ///< ± stands for ± infinity

/// Steps per unit of a quantised channel: 1/resolution to the nearest whole number (1e-3 -> 1000) if that is
/// one, so that a stored value equals the double nearest to its decimal text.
double stepsPerUnit(double resolution) noexcept;

/// What quantise() gives where `steps` = value · stepsPerUnit is no number within ±kMaximumQuantum.
std::int64_t quantiseOutOfRange(double value) noexcept;

/// NaN or ± infinity for their codes; NaN for anything else.
double dequantiseCode(std::int64_t count) noexcept;

/// Nearest step, ties to even (the mode that models run in); finite values saturate at ±kMaximumQuantum, NaN
/// and infinities get their codes. Defined for every double.
inline std::int64_t quantise(double value, double stepsPerUnit) noexcept {
    const double steps = value * stepsPerUnit;
    if (std::abs(steps) <= static_cast<double>(kMaximumQuantum)) [[likely]]
        return std::lrint(steps);
    return quantiseOutOfRange(value);
}
/// The double that a stored count stands for: count / stepsPerUnit; codes give NaN and ± infinity back.
inline double dequantise(std::int64_t count, double stepsPerUnit) noexcept {
    if (count >= -kMaximumQuantum && count <= kMaximumQuantum) [[likely]]
        return static_cast<double>(count) / stepsPerUnit;
    return dequantiseCode(count);
}

/// Force parts at 1 mN, torque parts at 0.01 mN·m: exactly what a reader of the recording gets.
core::Array6 roundedWrench(const core::Array6& wrench) noexcept;
/// The frame with its wrenches and display pose as they will be read back, and its reserved and unused parts
/// zero: live scoring from rounded frames equals later scoring from the file. Quantities and energies are zero too: which of
/// them a recording has, and how finely, is its channel table's to say.
core::HapticFrame roundedFrame(const core::HapticFrame& frame) noexcept;

} // namespace chiron::recording
