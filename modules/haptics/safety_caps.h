// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "core/geometry.h"
#include "haptics/safety_tool.h"

#include <cmath>

namespace chiron::haptics {

/// Returns the factor that brings a wrench to the nearest cap (models.md §5, caps): the minimum over the
/// actuated axes of cap/|effort|, of force cap/max(‖f‖, load) and of torque cap/‖τ‖. A factor above 1 means
/// that there is room. It is infinite for a zero wrench, and 0 if the kinematics returns a value that is not
/// finite. A cap of 0 is not a limit here (that part of the wrench was removed before). `sample` is the
/// newest good one. `load_N`: simulation::SceneOutput::load_N.
/// Thread: haptic.
double capRatio(const SafetyToolLimits& limits, const core::DeviceSample& sample,
                const core::Wrench& wrench_W, double load_N = 0.0) noexcept;

/// Returns the rendered force, in multiples of the cap, for a requested force of `x` caps: x up to 1 − w,
/// then 1 − w e^{−(x − 1 + w)/w}, which joins without a corner and approaches 1. A hand that trembles against
/// a stiff wall at the cap feels the corner of a force that is cut off as a buzz at twice its tremor. w is
/// the knee, 0 … 0.5; with 0 the force is cut off.
inline double bentToCap(double x, double knee) noexcept {
    const double over = x - (1.0 - knee);
    return over <= 0.0 ? x : knee > 0.0 ? 1.0 - knee * std::exp(-over / knee) : 1.0;
}

/// Returns the energy, as a multiple of U, of a spring whose force is bent into the cap: for U = ½ k s² and x
/// = k s/cap it is (2/x²) ∫₀ˣ bentToCap.
inline double bentEnergy(double x, double knee) noexcept {
    const double from = 1.0 - knee, over = x - from;
    if (over <= 0.0)
        return 1.0;
    const double missing = knee > 0.0 ? knee * knee * (1.0 - std::exp(-over / knee)) : 0.0;
    return 2.0 / (x * x) * (0.5 * from * from + over - missing);
}

/// Scales the whole wrench, so that its direction is kept, until every cap holds; returns true if it had to.
/// With a knee the force bends into the cap, and true means that it was bent.
bool applyCaps(const SafetyToolLimits& limits, const core::DeviceSample& sample, core::Wrench& wrench_W,
               double load_N = 0.0, double knee = 0.0) noexcept;

} // namespace chiron::haptics
