// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/wrench_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::recording {

double stepsPerUnit(double resolution) noexcept {
    const double steps = 1.0 / resolution;
    const double whole = std::round(steps);
    return std::abs(steps - whole) <= 1e-9 * whole ? whole : steps;
}

std::int64_t quantiseOutOfRange(double value) noexcept {
    if (std::isnan(value))
        return kNaNQuantum;
    if (std::isinf(value))
        return value > 0 ? kInfinityQuantum : -kInfinityQuantum;
    return value > 0 ? kMaximumQuantum : -kMaximumQuantum;
}

double dequantiseCode(std::int64_t count) noexcept {
    if (count == kInfinityQuantum)
        return std::numeric_limits<double>::infinity();
    if (count == -kInfinityQuantum)
        return -std::numeric_limits<double>::infinity();
    return std::numeric_limits<double>::quiet_NaN();
}

core::Array6 roundedWrench(const core::Array6& wrench) noexcept {
    static const double forceSteps = stepsPerUnit(kForceResolution_N);
    static const double torqueSteps = stepsPerUnit(kTorqueResolution_Nm);
    core::Array6 rounded{};
    for (std::size_t i = 0; i < 3; ++i) {
        rounded[i] = dequantise(quantise(wrench[i], forceSteps), forceSteps);
        rounded[i + 3] = dequantise(quantise(wrench[i + 3], torqueSteps), torqueSteps);
    }
    return rounded;
}

core::HapticFrame roundedFrame(const core::HapticFrame& frame) noexcept {
    core::HapticFrame rounded;
    rounded.tools = std::min<std::uint32_t>(frame.tools, core::kMaxTools);
    rounded.header = frame.header;
    rounded.header.reserved = 0;
    rounded.header.energySupplied_J = rounded.header.energyStored_J = 0.0;
    rounded.header.quantities = {};
    const double forceSteps = stepsPerUnit(kForceResolution_N);
    const double angleSteps = stepsPerUnit(kAngleResolution_rad);
    for (std::size_t t = 0; t < rounded.tools; ++t) {
        core::ToolFrame& tool = rounded.tool[t];
        tool = frame.tool[t];
        tool.reserved = 0;
        tool.tissue = roundedWrench(tool.tissue);
        tool.commanded = roundedWrench(tool.commanded);
        tool.measured = roundedWrench(tool.measured);
        tool.display[0] = dequantise(quantise(tool.display[0], forceSteps), forceSteps);
        tool.display[1] = dequantise(quantise(tool.display[1], angleSteps), angleSteps);
        tool.display[2] = dequantise(quantise(tool.display[2], angleSteps), angleSteps);
    }
    return rounded;
}

} // namespace chiron::recording
